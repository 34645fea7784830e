#pragma once

#include "higherpair/front/measure.hpp"
#include "higherpair/front/model.hpp"
#include "higherpair/io/tasks.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

struct SweepSettings {
  double tolerance = 1e-9;              ///< as RunSettings::tolerance
  std::optional<std::int64_t> samples;  ///< as RunSettings::samples
  int part = 1;                         ///< which of `parts` equal parts of the variants this is, from 1
  int parts = 1;
  const std::atomic<bool>* stop = nullptr;          ///< as RunSettings::stop
  std::shared_ptr<const SweepTask> task = nullptr;  ///< null: that of the profile
};

/// The results of consecutive variants.
struct SweepBlock {
  std::int64_t number = 0;          ///< of the block, from 0
  std::int64_t variants = 0;        ///< number of variants
  std::int64_t good = 0;            ///< number of those whose whole path is good
  std::vector<double> values;       ///< row after row, one for each of Sweep::columns(); NaN where undefined
  std::vector<std::string> causes;  ///< for each row: why it is not good; empty if it is
  bool complete = true;             ///< false: stopped before its last variant
};

/// What a few variants show of a sweep before it is run.
struct SweepForecast {
  std::int64_t tried = 0;
  std::int64_t unreadable = 0;  ///< how many of these have an invalid profile, for example a negative radius
  std::int64_t variant = 0;     ///< the first of them
  std::string cause;            ///< its first mistake
};

/// The variants of a model that [sweep] in its profile asks for, and the table of their results. Immutable;
/// any number of threads may compute its blocks. A block is the same to the last bit whichever thread
/// computes it, and when.
///
/// Every variant has at least one row, even if its profile is invalid or it cannot be assembled: the status
/// is then `not_started`, and the cause says why. Without SweepTask::rows it has just one, with the worst
/// status of the rows of its run. The order, from good to bad: ok, singular, contact_open, overlap,
/// not_converged, not_assemblable, not_started. A path that is not good although its rows are also has a
/// cause.
class Sweep {
public:
  /// Fails for a model without a task or one built in C++, for a task with a mistake (fault_of() of its plan,
  /// paths that lead to no number, columns that do not exist), if the profile itself cannot be run at all,
  /// and if none of the variants that are tried has a valid profile.
  [[nodiscard]] static Result<Sweep> of(const Model& model, const SweepSettings& settings = {});

  /// Number of variants of this part, and of the first of them.
  [[nodiscard]] std::int64_t size() const;
  [[nodiscard]] std::int64_t first() const;
  /// The part is divided into blocks of equally many variants; their size depends on the profile alone.
  [[nodiscard]] std::int64_t blocks() const;
  /// 0 for a number that no block has; block() is empty then.
  [[nodiscard]] std::int64_t variants_of(std::int64_t block) const;

  /// "variant", the variables, the results (or the columns of the rows), "status".
  [[nodiscard]] const std::vector<Column>& columns() const;
  /// The index of the first result in columns(), and the number of results; 0 if rows are written.
  [[nodiscard]] std::size_t first_result() const;
  [[nodiscard]] std::size_t result_count() const;

  [[nodiscard]] const SweepForecast& forecast() const;

  /// Computes a block. It is not complete if it was stopped.
  [[nodiscard]] SweepBlock block(std::int64_t number) const;

  struct Data;
  explicit Sweep(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

private:
  std::shared_ptr<const Data> data_;
};

/// Computes the blocks from `first` on, on several threads at once, and passes them to `take` in order, one
/// at a time. Ends early if `take` returns false or the sweep is stopped.
/// \param threads  number of threads, at most 1024; 0 or less: one for each available core
void run_sweep(const Sweep& sweep, std::int64_t first, int threads,
               const std::function<bool(const SweepBlock&)>& take);

/// The header and the rows of a block as CSV: the columns, followed by `cause`.
[[nodiscard]] std::string sweep_csv_header(const Sweep& sweep);
void append_sweep_csv(const Sweep& sweep, const SweepBlock& block, std::string& out);

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
