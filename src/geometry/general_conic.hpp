#pragma once

#include "higherpair/geometry/curve.hpp"

#include <array>
#include <optional>

namespace higherpair {

/// The curve itself; an error if its numbers are out of the range of double.
[[nodiscard]] CurveResult if_in_range(const Curve& curve);

/// The vertex form of a conic given by its coefficients, of which the largest of A, B, C is between 1 and 2;
/// see make_conic().
[[nodiscard]] CurveResult conic_from_scaled(const std::array<double, 6>& coefficients, Side side,
                                            const std::optional<Vector2d>& near_B);

}  // namespace higherpair
