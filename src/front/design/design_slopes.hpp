#pragma once

#include "design_columns.hpp"
#include "design_runs.hpp"

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// Exact derivatives of the quantities in DesignRows, one column for each variable.
struct DesignSlopes {
  Eigen::MatrixXd measured;            ///< of DesignRows::measured
  Eigen::MatrixXd gaps;                ///< of DesignRows::gaps
  Eigen::MatrixXd transmissions;       ///< of DesignRows::transmissions
  std::vector<Eigen::MatrixXd> paths;  ///< for each path: of x and y of each place, one below the other
};

/// A place of a path whose derivative is wanted: a row, or a position of the only driver near `row`.
struct SlopePlace {
  PointRef point;
  std::size_t row = 0;
  std::optional<double> driver;
};

/// Derivatives by implicit differentiation of the rows of a run (analysis/sensitivity.hpp). An extreme
/// depends on its own row alone. Not covered, and left to finite differences: numbers that do not depend
/// smoothly on the variables; drivers that depend on them; contacts that may separate; jerk; figures of
/// check(); means over many rows of columns other than those of bodies, points and revolute joints; extents
/// of bodies with curves of several parts; candidates that cannot be assembled all the way.
class RunSlopes {
public:
  /// None where the task is not covered. \param setup  must outlive this
  [[nodiscard]] static std::optional<RunSlopes> of(const DesignSetup& setup);

  /// None where the candidate is not covered. \param x  its variables \param rows  of this candidate, whose
  /// path is good \param places  for each path \param groups  whether gaps and transmissions are wanted
  [[nodiscard]] std::optional<DesignSlopes> of_candidate(std::span<const double> x,
                                                         const DesignCandidate& candidate, int branch,
                                                         const DesignRows& rows,
                                                         std::span<const std::vector<SlopePlace>> places,
                                                         bool groups) const;

private:
  explicit RunSlopes(const DesignSetup& setup);

  [[nodiscard]] std::optional<std::vector<MechanismDerivative>> derivatives_at(
      std::span<const double> x) const;

  const DesignSetup* setup_;
  std::vector<std::optional<BodyColumn>> columns_;  // for each measure
};

}  // namespace higherpair
