#pragma once

#include "higherpair/io/design_task.hpp"

#include <complex>
#include <span>

#include <Eigen/Core>

namespace higherpair {

/// A path moved, turned and scaled to where it is nearest to its points, as far as it is free to be: with
/// P' and T' the places and the points from their means (from the origin, where the position is not free), as
/// complex numbers,
///     T' - z P',   z = Σ P̄'T'/Σ|P'|², its size 1 without scale, real without turn, 1 without both.
class PathPlacement {
public:
  /// \param places  of the path [m], one for each point of `path`
  PathPlacement(const DesignTask::PointPath& path, std::span<const Vector2d> places);

  /// x and y of each place less its point, one after the other [m].
  [[nodiscard]] Eigen::VectorXd misses() const;
  /// Their derivatives, from those of x and y of the places.
  [[nodiscard]] Eigen::MatrixXd miss_slopes(const Eigen::MatrixXd& place_slopes) const;

private:
  using Complex = std::complex<double>;

  const DesignTask::PointPath& path_;
  Eigen::VectorXcd P_, T_;  // from their means
  Complex sum_;             // Σ P̄'T'
  double size2_ = 0;        // Σ|P'|²
  Complex z_ = 1;
};

}  // namespace higherpair
