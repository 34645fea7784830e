#pragma once

#include "higherpair/geometry/boundary.hpp"

#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// A curve of polynomials in one parameter, one on each interval between ascending breaks, whose curvature is
/// continuous.
/// \param powers  row i (degree + 1) + k: the coefficients of (t - breaks[i])ᵏ: x, y; of a rational curve the
///                numerators of x and y, and the denominator
[[nodiscard]] SpanPtr polynomial_span(std::vector<double> breaks, const Eigen::MatrixXd& powers);

}  // namespace higherpair
