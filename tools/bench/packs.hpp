#pragma once

#include "cases.hpp"
#include "higherpair/analysis/dyad_chain.hpp"
#include "vector_floor.hpp"

#include <string>
#include <vector>

namespace higherpair::bench {

/// A whole turn of a mechanism, kStepsPerTurn rows of it at a time: angle, angular velocity and acceleration
/// of its last two bodies, or forces.
struct PackCase {
  std::string name;
  Mechanism mechanism;
  DyadChain chain;
};

/// For DyadChain. Ends the program with a message where its rows are not those of the run, moved to one after
/// the other.
/// \param start  standing at the first row
[[nodiscard]] PackCase checked_packs(const std::string& name, const Run& start);

/// The same with what all joints and the driver do instead, held against the inverse dynamics of the run.
[[nodiscard]] PackCase checked_packs_with_forces(const std::string& name, const Run& start);

/// Checked against the four-bar by hand.
[[nodiscard]] VectorFourBar checked_vector_floor();

/// The fastest of many turns [ns a step].
[[nodiscard]] double measure(VectorFourBar& floor);

}  // namespace higherpair::bench
