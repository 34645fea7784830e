#pragma once

#include "design_candidates.hpp"
#include "design_paths.hpp"
#include "higherpair/design/optimise.hpp"

#include <memory>
#include <span>

namespace higherpair {

/// Evaluates candidates for the optimiser, and in the units of tables. The same candidate again costs little.
class ScoringEvaluator : public DesignEvaluator {
public:
  [[nodiscard]] virtual DesignScore score(std::span<const double> x, int branch) = 0;
};

/// The evaluator that problem_of uses. \param setup  must outlive it
[[nodiscard]] std::unique_ptr<ScoringEvaluator> evaluator_of(const DesignSetup& setup);

/// The score of x on a branch.
[[nodiscard]] DesignScore score_of(const DesignSetup& setup, std::span<const double> x, int branch);

/// Sets DesignSetup::scales and cost_scale by the order of magnitude of the limits and of the values at the
/// start.
void set_scales(DesignSetup& setup);

}  // namespace higherpair
