#pragma once

#include "higherpair/analysis/run.hpp"

#include <cstddef>
#include <vector>

namespace higherpair {

/// The straight line of the inputs beyond a limit, on which a lost branch is looked for: from the limit
/// through the row before to this row; or, if these do not lie on one line, from the row before. A position
/// on it is given by its leading input x, the one that changes most in its unit; the others follow in
/// proportion. All rows on one line share it, however many they are; on a curve in time that is all of them.
class LineAhead {
public:
  /// \param from  the row before, or the limit
  /// \param to    this row; not where the line begins
  LineAhead(const Run& run, const std::vector<double>& from, const std::vector<double>& to);

  /// The inputs at x.
  [[nodiscard]] std::vector<double> at(double x) const;
  /// The leading input.
  [[nodiscard]] double x_of(const std::vector<double>& inputs) const { return inputs[leading_]; }
  [[nodiscard]] const std::vector<double>& begin() const { return begin_; }
  [[nodiscard]] std::size_t leading() const { return leading_; }
  /// One unit of x.
  [[nodiscard]] double scale() const { return scale_; }
  /// The sense in which x moves away from the limit: +1, -1.
  [[nodiscard]] double sense() const { return sense_; }
  /// Whether the line begins at the limit.
  [[nodiscard]] bool is_from_limit() const { return is_from_limit_; }

private:
  void aim(const Run& run, const std::vector<double>& to);

  std::vector<double> begin_;
  std::vector<double> slope_;  // d(input)/dx
  std::size_t leading_ = 0;
  double scale_ = 1;
  double sense_ = 1;
  bool is_from_limit_ = true;
};

}  // namespace higherpair
