#pragma once

#include "higherpair/linkage/reach.hpp"

namespace higherpair {

/// The angle in [0, π] at which a cosine line is zero: cos ψ = c is solved as tan²(ψ/2) = (1-c)/(1+c), the
/// ratio of the values at both ends, which is accurate to a few roundings of ψ also near 0 and π.
/// \pre The ends have opposite signs, or one of them is zero.
[[nodiscard]] double root_angle(const CosineLine<double>& line);

/// The angle of `u` + `reference`, in (-π, π] [rad].
[[nodiscard]] double absolute_angle(const Rotation<double>& u, double reference);

}  // namespace higherpair
