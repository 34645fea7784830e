#pragma once

#include "analysis/groups/group_solver.hpp"
#include "higherpair/analysis/run.hpp"

#include <optional>

namespace higherpair {

/// An end of a joint's line that the joint is at or beyond.
struct JointEnd {
  int joint = 0;
  bool upper = false;  ///< Joint::to; else Joint::from
};

/// The first joint of a group that is beyond an end of its line, in a state whose bodies are placed.
[[nodiscard]] std::optional<JointEnd> joint_beyond_end(const Planned& model, std::size_t g,
                                                       const State& state);

/// How far the joints of a group, whose bodies are placed, are from the nearest end of their lines [m, rad];
/// < 0 beyond it, +inf if no joint has an end.
[[nodiscard]] double room_to_end(const Planned& model, std::size_t g, const State& state);

/// The first joint of a group that is at an end of its line, to within the accuracy of a search for it.
[[nodiscard]] std::optional<JointEnd> joint_at_end(const Planned& model, std::size_t g, const State& state);

/// Where in a step from run.at.state, which is at s, to run.work.trial, h ahead, a joint is beyond an end of
/// its line that it comes back from: distance ahead on the path. Leaves run.work.trial unchanged.
[[nodiscard]] std::optional<double> end_passed_within(Run& run, const Path& path, double s, double h);

}  // namespace higherpair
