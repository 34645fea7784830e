#pragma once

#include "higherpair/numeric/tolerances.hpp"

namespace higherpair {

/// Whether Newton's method has converged: rounding keeps the steps from shrinking, or they are below all
/// rounding. (If a component is nearly 0, as along an axis of ground, it has no rounding and steps may shrink
/// for ever.)
/// \param step  size of this step, in radians and units of length
/// \param last  size of the one before
/// \param near  steps are expected to converge quadratically below this
/// \param least  steps up to this count as zero: the next one would certainly be rounding
[[nodiscard]] inline bool newton_has_settled(double step, double last, double near = kNewtonQuadratic,
                                             double least = kNewtonLeast) {
  return step <= least || (step < near && step >= last / 2);
}

}  // namespace higherpair
