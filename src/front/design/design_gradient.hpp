#pragma once

#include "design_candidates.hpp"
#include "design_paths.hpp"
#include "higherpair/design/optimise.hpp"

#include <span>
#include <vector>

namespace higherpair {

/// The candidate evaluated last.
struct EvaluatedCandidate {
  std::span<const double> x;
  int branch = 0;
  const DesignRows& rows;
  const std::vector<std::vector<PathMiss>>& places;  ///< of each path
};

/// Number of residuals of an objective.
[[nodiscard]] Eigen::Index residual_count(const DesignTask::Objective& objective);

/// Computes the derivatives of what an evaluator returns for this candidate; false where they are not known
/// exactly. \param unit  of lengths [m]
[[nodiscard]] bool add_gradient(const DesignSetup& setup, DesignCandidates& candidates,
                                const EvaluatedCandidate& candidate, double unit, DesignJacobian& jacobian);

}  // namespace higherpair
