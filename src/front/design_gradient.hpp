#pragma once

#include "design_candidates.hpp"
#include "design_paths.hpp"
#include "higherpair/design/optimise.hpp"

#include <span>
#include <vector>

namespace higherpair {

/// The candidate that was worked out last.
struct DesignStanding {
  std::span<const double> x;
  int branch = 0;
  const DesignRows& rows;
  const std::vector<std::vector<PathMiss>>& places;  ///< of each path
};

/// How many residuals an objective has.
[[nodiscard]] Eigen::Index residual_count(const DesignTask::Objective& objective);

/// The derivatives of what an evaluator says of this candidate; false where they are not known exactly.
/// \param unit  of lengths [m]
[[nodiscard]] bool add_gradient(const DesignSetup& setup, DesignCandidates& candidates,
                                const DesignStanding& standing, double unit, DesignJacobian& jacobian);

}  // namespace higherpair
