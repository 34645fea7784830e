#pragma once

#include "higherpair/geometry/tolerances.hpp"

namespace higherpair {

/// Whether Newton's method has come to its end: rounding makes the steps stop falling, or they are below all
/// rounding. Along an axis of ground they may fall for ever: a component that is nearly 0 has no rounding to
/// stop at.
/// \param step  size of this step, in radians and units of length
/// \param last  of the one before
/// \param near  steps below this fall quadratically
/// \param least  steps up to this are none: where the next one would be rounding for certain
[[nodiscard]] inline bool newton_has_settled(double step, double last, double near = kNewtonQuadratic,
                                             double least = kNewtonLeast) {
  return step <= least || (step < near && step >= last / 2);
}

}  // namespace higherpair
