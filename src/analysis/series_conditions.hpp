#pragma once

#include "series.hpp"

#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// The conditions of a mechanism as functions of time, for coordinates that are power series. Columns: x, y
/// and size·θ of every moving body, then the angle of the normal (times size) of every contact of two curves
/// neither of which is flat.
class SeriesConditions {
public:
  SeriesConditions(const Run& run, const std::vector<DriverMotion>& drivers);

  [[nodiscard]] Eigen::Index columns() const { return columns_; }

  /// Where the row stands.
  [[nodiscard]] Eigen::VectorXd start() const;

  /// The values of all conditions along x(t) = Σ x[k] t^k; [m]. Rolling contacts give the slip since t = 0.
  /// \param driven  false: the drivers stand still
  [[nodiscard]] std::vector<Series> along(const std::vector<Eigen::VectorXd>& x, bool driven) const;

private:
  const Run& run_;
  const std::vector<DriverMotion>& drivers_;
  std::vector<Eigen::Index> normals_;  ///< column of each contact's normal, or -1
  Eigen::Index columns_ = 0;
};

}  // namespace higherpair
