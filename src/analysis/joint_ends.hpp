#pragma once

#include "group_solver.hpp"

#include <optional>

namespace higherpair {

/// A joint at an end of its line, or beyond it.
struct JointEnd {
  int joint = 0;
  bool upper = false;  ///< Joint::to; else Joint::from
};

/// The first joint of a group that is farther than an end of its line allows, in a state whose bodies are
/// placed.
[[nodiscard]] std::optional<JointEnd> joint_beyond_end(const Planned& model, std::size_t g,
                                                       const State& state);

/// How far the joints of a group, whose bodies are placed, are from the nearest end of their lines; < 0
/// beyond it, +inf where they have none [m, rad].
[[nodiscard]] double room_to_end(const Planned& model, std::size_t g, const State& state);

/// The first joint of a group that is at an end of its line, to within what a search for it leaves.
[[nodiscard]] std::optional<JointEnd> joint_at_end(const Planned& model, std::size_t g, const State& state);

}  // namespace higherpair
