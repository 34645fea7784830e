#pragma once

#include <functional>
#include <optional>

namespace higherpair {

struct ValueAndSlope {
  double value = 0;
  double slope = 0;
};

/// The root of f between 0 and h, to within rounding; h may be negative. Newton's method from both ends: a
/// few calls where f is smooth on either side of its root, even if its slope jumps there. Beyond the root f
/// may also jump or have no value (not finite): then the root is approached from the side of 0 alone. None
/// where the values at the two ends have the same sign, or f does not fall to 0 before it jumps.
/// \param at_0, at_h  f at both ends
/// \param nothing     a value of f before a jump that counts as 0
[[nodiscard]] std::optional<double> newton_root_between(const std::function<ValueAndSlope(double)>& f,
                                                        const ValueAndSlope& at_0, double h, double at_h,
                                                        double nothing = 0);

}  // namespace higherpair
