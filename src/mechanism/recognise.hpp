#pragma once

#include "higherpair/mechanism/plan.hpp"

#include <span>
#include <vector>

namespace higherpair {

/// The closed form that places a group's bodies, given the groups before it; CoupledBodies if there is none.
[[nodiscard]] GroupKind kind_of(const Mechanism& mechanism, const BodySet& set,
                                std::span<const Group> before);

/// Finds the closed-form group that a set of bodies forms, given those before it; coupled bodies if there is
/// none.
[[nodiscard]] Group recognise(const Mechanism& mechanism, const BodySet& set,
                              const std::vector<Group>& before);

}  // namespace higherpair
