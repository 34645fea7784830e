#pragma once

#include "higherpair/analysis/run.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace higherpair {

/// \name Runs on a chosen branch
/// A branch is given by the assembly modes of all groups of a plan that have two, as bits of a number in
/// their order: it stays the same branch for other dimensions, whatever the poses. Other choices, such as
/// that of a contact, are made by closeness to the poses.
/// @{

/// Most modes that the number of a branch encodes: further groups are in mode +1.
inline constexpr int kMostBranchModes = 16;

/// The mode on a branch of the k-th group that has two.
[[nodiscard]] constexpr int mode_on(int branch, std::size_t k) {
  return k < kMostBranchModes && ((branch >> k) & 1) != 0 ? -1 : 1;
}

/// 2 to the number of groups with two modes, at most 2 to kMostBranchModes.
[[nodiscard]] int branch_count(const Plan& plan);

/// The branch that a run is on.
[[nodiscard]] int branch_of(const Run& run);

/// Like start_run, on this branch. The dimensions of redundant mechanisms are not checked. None where it
/// cannot be assembled there at the first positions of the drivers.
[[nodiscard]] std::optional<Run> start_on_branch(RunModel model, const std::vector<double>& drivers,
                                                 int branch);

/// By how much a group of links is too short, or too long, to be assembled between the bodies that it depends
/// on, at their present positions [m]; < 0: its reserve. None for groups that are not dyads.
[[nodiscard]] std::optional<double> closure_gap(const Group& group, const std::vector<BodyMotion>& bodies);

/// The same at positions of the drivers for which no row need exist: groups are placed near `run`; those that
/// cannot be placed and all after them are left out. One number for each group of the plan.
[[nodiscard]] std::vector<std::optional<double>> closure_gaps(const Run& run,
                                                              const std::vector<double>& drivers);

/// The same at the first positions of a mechanism that need not have an assembly on the branch.
[[nodiscard]] std::vector<std::optional<double>> first_closure_gaps(RunModel model,
                                                                    const std::vector<double>& drivers,
                                                                    int branch);

/// Sine of the angle between two links joined by a pin, each of which has another pin at its other end
/// (RrrDyad); ±. None where the pin joins no such links.
[[nodiscard]] std::optional<double> transmission_sine(const Plan& plan, int joint,
                                                      const std::vector<BodyMotion>& bodies);
/// @}

}  // namespace higherpair
