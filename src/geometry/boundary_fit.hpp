#pragma once

#include "higherpair/geometry/boundary_fit.hpp"
#include "numeric/singular_values.hpp"

#include <optional>

namespace higherpair::boundary_fit {

/// Points about their centroid, of size 1: 〈|p|²〉 = 1.
struct Normalised {
  std::vector<Vector2d> points;
  Vector2d center = Vector2d::Zero();
  double size = 1;
};

/// Fails for too few points, for points that are not finite or out of range, and for points all at one place.
[[nodiscard]] tl::expected<Normalised, BoundaryFitError> normalised(std::span<const Vector2d> points,
                                                                    std::size_t least);

/// Singular values of the matrix with a row for each point.
[[nodiscard]] SingularValues spread_of(const std::vector<Vector2d>& points);

/// Converts a fit of normalised points to the points' own frame, and fills distances, rms and noise of `fit`.
/// \param lengths  which of the parameters are lengths; the first two are a position
void to_own_frame(const Normalised& from, std::span<const double> distances, std::size_t freedoms,
                  const std::vector<bool>& lengths, BoundaryFit& fit);

/// (JᵀJ)⁻¹; NaN where it does not exist.
[[nodiscard]] Eigen::MatrixXd inverse_of_square(const Eigen::MatrixXd& J);

using Coefficients = Eigen::Matrix<double, 6, 1>;  ///< A … F of a conic

/// x², y², x y, x, y, 1
[[nodiscard]] Coefficients monomials(const Vector2d& p);
/// ∇F at p
[[nodiscard]] Vector2d slope(const Coefficients& conic, const Vector2d& p);

/// \name Starting values by algebraic fits
/// @{
[[nodiscard]] Coefficients taubin_conic(const std::vector<Vector2d>& points);
/// None where the points have no such ellipse.
[[nodiscard]] std::optional<Coefficients> direct_ellipse(const std::vector<Vector2d>& points);
/// {vertex, direction of the axis, semi-latus rectum}: of the parabolas with any axis, the one of the least
/// distances to first order.
[[nodiscard]] Eigen::Vector4d algebraic_parabola(const std::vector<Vector2d>& points);
/// @}

}  // namespace higherpair::boundary_fit
