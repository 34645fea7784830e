#pragma once

#include "cases.hpp"
#include "higherpair/analysis/dyad_chain.hpp"
#include "vector_floor.hpp"

#include <string>
#include <vector>

namespace higherpair::bench {

/// A whole turn of a mechanism with all its kStepsPerTurn rows computed at once: angle, angular velocity and
/// acceleration of its last two bodies, or forces.
struct PackCase {
  std::string name;
  Mechanism mechanism;
  DyadChain chain;
};

/// A case for DyadChain. Ends the program with a message if its rows differ from those of the run, which
/// moves from one to the next.
/// \param start  at the first row
[[nodiscard]] PackCase checked_packs(const std::string& name, const Run& start);

/// The same with the reactions of all joints and the driver instead, checked against the inverse dynamics of
/// the run.
[[nodiscard]] PackCase checked_packs_with_forces(const std::string& name, const Run& start);

/// The floor, checked against the four-bar by hand.
[[nodiscard]] VectorFourBar checked_vector_floor();

/// The fastest of many turns [ns per step].
[[nodiscard]] double measure(VectorFourBar& floor);

}  // namespace higherpair::bench
