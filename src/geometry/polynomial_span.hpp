#pragma once

#include "higherpair/geometry/boundary.hpp"

#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// A curve that is polynomial in its parameter on each interval between ascending breaks, with a continuous
/// curvature.
/// \param powers  row i (degree + 1) + k: the coefficients of (t - breaks[i])ᵏ: x, y; of a rational curve the
///                numerators of x and y, and the denominator
[[nodiscard]] SpanPtr polynomial_span(std::vector<double> breaks, const Eigen::MatrixXd& powers);

}  // namespace higherpair
