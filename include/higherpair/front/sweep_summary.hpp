#pragma once

#include "higherpair/front/sweep.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace higherpair {

/// Statistics of a column of numbers, in two passes and constant memory: the first gives least and largest
/// value, mean and deviation; the second the distribution in between.
class ColumnStatistics {
public:
  /// First pass; NaN and infinities are ignored.
  void add(double value);
  /// Second pass, over the same values.
  void place(double value);

  [[nodiscard]] std::int64_t count() const { return count_; }
  [[nodiscard]] double least() const { return least_; }
  [[nodiscard]] double largest() const { return largest_; }
  [[nodiscard]] double mean() const;  ///< NaN without values
  /// Standard deviation with n - 1 in the denominator; 0 for a single value.
  [[nodiscard]] double deviation() const;
  /// The value below which the fraction `share` of all values lies, to within 1/65536 of the range.
  /// \pre count() > 0
  [[nodiscard]] double quantile(double share) const;
  /// The number of values in each of `bars` equal parts of the range.
  [[nodiscard]] std::vector<std::int64_t> histogram(std::size_t bars) const;

private:
  static constexpr std::size_t kBins = 65536;

  std::int64_t count_ = 0;
  double least_ = 0;
  double largest_ = 0;
  double first_ = 0;         // first value; the sums are of differences from it
  long double sum_ = 0;      // of v - first
  long double squares_ = 0;  // of (v - first)²
  std::vector<std::int64_t> bins_;
};

/// Variants that failed for the same reason, apart from the numbers in it.
struct SweepCause {
  std::int64_t count = 0;
  std::string example;  ///< the first
};

/// What a sweep has shown: how many variants are good, why others are not, and the distribution of every
/// result. In two passes over all blocks, in the same order; memory does not grow with their number.
class SweepSummary {
public:
  explicit SweepSummary(const Sweep& sweep);

  void add(const SweepBlock& block);    ///< first pass
  void place(const SweepBlock& block);  ///< second pass, which quantiles and histograms need

  [[nodiscard]] std::int64_t variants() const { return variants_; }
  /// Whether the whole paths of all variants are good.
  [[nodiscard]] bool good() const { return good_ == variants_; }
  /// The most frequent first. After the first 1000 different ones, no others are counted.
  [[nodiscard]] std::vector<SweepCause> causes() const;
  /// Of each of Sweep::result_count() columns, from Sweep::first_result() on.
  [[nodiscard]] const std::vector<ColumnStatistics>& results() const { return results_; }

  /// Readable text with at most 80 characters per line.
  [[nodiscard]] std::string text(const std::string& title) const;

private:
  void add_cause(const std::string& cause);
  template <class Use>
  void for_each_value(const SweepBlock& block, const Use& use);

  Sweep sweep_;
  std::int64_t variants_ = 0;
  std::int64_t good_ = 0;
  std::int64_t rows_ = 0;
  std::map<int, std::int64_t> statuses_;      ///< rows by status, as its index in the words of the column
  std::map<std::string, SweepCause> causes_;  ///< by their text before the first number
  std::vector<ColumnStatistics> results_;
};

}  // namespace higherpair
