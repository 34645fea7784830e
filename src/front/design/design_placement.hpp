#pragma once

#include "higherpair/io/design_task.hpp"

#include <complex>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// A path moved, turned and scaled, as far as it is free to be, so that it is nearest to its target points.
/// With P' and T' the places and the targets relative to their means (to the origin where the position is not
/// free), as complex numbers, Σ|T' - z P'|² is least for the z of
/// best_similarity.
class PathPlacement {
public:
  using Complex = std::complex<double>;

  /// \param places  of the path [m], one for each point of `path`
  PathPlacement(const DesignTask::PointPath& path, std::span<const Vector2d> places);

  /// A place p of the path goes to turn_and_scale() p + shift() [m].
  [[nodiscard]] Complex turn_and_scale() const { return z_; }
  [[nodiscard]] Complex shift() const { return T_mean_ - z_ * P_mean_; }

  /// x and y of each place less its target point, one after the other [m].
  [[nodiscard]] Eigen::VectorXd misses() const;
  /// Their derivatives, from those of x and y of the places.
  [[nodiscard]] Eigen::MatrixXd miss_slopes(const Eigen::MatrixXd& place_slopes) const;

  /// \name For a path without times, whose places are the nearest ones
  /// @{
  /// The distance of each place from its target point [m], signed by the side on which the target lies,
  /// unsigned where the place has no tangent. \param along  unit tangents of the unplaced path; 0: none
  [[nodiscard]] Eigen::VectorXd distances(std::span<const Vector2d> along) const;
  /// Their derivatives, with the placement following to first order in the distances (Kaufman's
  /// approximation): those of the sum of their squares are exact.
  [[nodiscard]] Eigen::MatrixXd distance_slopes(std::span<const Vector2d> along,
                                                const Eigen::MatrixXd& place_slopes) const;
  /// turn_and_scale() and shift() after one step in which the places may slide along their tangents.
  [[nodiscard]] std::pair<Complex, Complex> moved_by_tangents(std::span<const Vector2d> along) const;
  /// @}

private:
  [[nodiscard]] std::vector<Complex> normals(std::span<const Vector2d> along) const;
  [[nodiscard]] Eigen::MatrixXd freedoms(std::span<const Complex> normals) const;

  const DesignTask::PointPath& path_;
  Complex P_mean_, T_mean_;
  Eigen::VectorXcd P_, T_;  // relative to these means
  Complex sum_;             // Σ P̄'T'
  double size2_ = 0;        // Σ|P'|²
  Complex z_ = 1;
};

}  // namespace higherpair
