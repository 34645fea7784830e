#pragma once

#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/pose.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {

/// The next step along a path.
struct Stride {
  double step = 0;
  bool last = false;  ///< it reaches the end
};

/// The shortest step that a coordinate at `at` resolves. \param unit  of the coordinate: a radian, or the
/// size
[[nodiscard]] inline double shortest_step(double unit, double at) {
  return kStepResolution * (unit + std::abs(at));
}

/// Controls the length of steps along a path, of a single contact or of a mechanism: halved where a step is
/// refused, doubled after an accepted one, up to the largest.
class StepLength {
public:
  explicit StepLength(double largest) : largest_(largest), length_(largest) {}

  [[nodiscard]] double value() const { return length_; }

  /// The next step, of at most `most`, where `rest` is left of the path. If that is little more than a step,
  /// it is taken as a whole: no remainder of rounding size is left. A step that has been shortened ends where
  /// it should, however little is left behind it.
  [[nodiscard]] Stride next(double rest, double most = kInf) const {
    const double h = std::min(length_, most);
    const bool last = std::abs(rest) <= (before_ > 0 ? 1 : kAlmostThere) * h;
    return {last ? rest : std::copysign(h, rest), last};
  }

  void taken() {
    length_ = std::max(before_, std::min(2 * length_, largest_));
    before_ = 0;
  }
  void refused(double step) {
    length_ = std::abs(step) / 2;
    before_ = 0;
  }
  /// Lets the next step end elsewhere although none was refused: steps after it are as long as before.
  void shorten(double length) {
    before_ = std::max(before_, length_);
    length_ = length;
  }

private:
  double largest_;
  double length_;
  double before_ = 0;  // the length before it was shortened; 0: it was not
};

}  // namespace higherpair
