#pragma once

#include "higherpair/mechanism/plan.hpp"
#include "structure.hpp"

#include <vector>

namespace higherpair {

/// Finds the closed-form group that a set of bodies is, given those before it; coupled bodies where it is
/// none.
[[nodiscard]] Group recognise(const Mechanism& mechanism, const BodySet& set,
                              const std::vector<Group>& before);

}  // namespace higherpair
