#pragma once

#include "higherpair/mechanism/plan.hpp"
#include "structure.hpp"

#include <span>
#include <vector>

namespace higherpair {

/// What a group consists of.
struct GroupItems {
  std::span<const int> bodies;
  std::span<const int> joints;
  std::span<const int> contacts;
  std::span<const int> drivers;
};

/// The closed form that places a group's bodies, given the groups before it; CoupledBodies if there is none.
[[nodiscard]] GroupKind kind_of(const Mechanism& mechanism, const GroupItems& items,
                                std::span<const Group> before);

/// Finds the closed-form group that a set of bodies forms, given those before it; coupled bodies if there is
/// none.
[[nodiscard]] Group recognise(const Mechanism& mechanism, const BodySet& set,
                              const std::vector<Group>& before);

}  // namespace higherpair
