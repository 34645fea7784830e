#pragma once

#include "higherpair/front/sensitivity.hpp"

#include <array>

namespace higherpair {

/// The derivative of a result from its values for a number changed by -2 h, -h, 0, h and 2 h; a value is NaN
/// where there is none.
///
/// Where another extreme takes over within 2 h, or a corner is passed, differences of second and fourth order
/// disagree, and shorter steps are tried. If none of them agree, the derivative is that of the step which
/// differs least from the one before, and its error is that difference.
class DifferenceSlope {
public:
  /// \param h  shorter than those before \param largest  smaller changes than its rounding are none
  void add(const std::array<double, 5>& values, double h, double largest);

  [[nodiscard]] bool needs_shorter_step() const { return needs_shorter_step_; }
  [[nodiscard]] const Slope& slope() const { return best_; }

private:
  Slope last_, best_;
  int steps_ = 0;
  bool needs_shorter_step_ = true;
};

}  // namespace higherpair
