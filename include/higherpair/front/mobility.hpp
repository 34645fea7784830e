#pragma once

#include "higherpair/front/model.hpp"
#include "higherpair/mechanism/mobility.hpp"

#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// Bodies that are placed together, and how.
struct PlanStep {
  std::vector<int> bodies;  ///< of Mechanism::bodies
  std::string text;
};

/// What a mechanism can do.
struct MobilityFindings {
  Model model;
  Mobility mobility;           ///< SI units
  std::vector<PlanStep> plan;  ///< in the order of solution; empty where the drivers do not place all bodies
  std::optional<std::string> objection;  ///< why it cannot be run
};

/// Counts freedoms, finds the rank, and tries to start the mechanism. Fails only for wrong input, as a
/// driver's positions.
[[nodiscard]] Result<MobilityFindings> mobility_of(const Model& model, double tolerance = 1e-9);

}  // namespace higherpair
