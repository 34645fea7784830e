#pragma once

#include "higherpair/analysis/run.hpp"

namespace higherpair {

/// A mechanism with its plan, at these positions of its drivers; not assembled yet.
[[nodiscard]] tl::expected<Run, StartFailure> planned_run(const Mechanism& mechanism,
                                                          const std::vector<double>& drivers);
[[nodiscard]] Run planned_run(RunModel model, const std::vector<double>& drivers);

/// Squared distances of the points of a group's joints from their places in the poses [m²]: what makes one
/// assembly nearer than another.
[[nodiscard]] double distance_from_poses(const Mechanism& mechanism, const Group& group,
                                         const std::vector<BodyMotion>& bodies,
                                         const std::vector<BodyMotion>& posed);

/// Sets run.at.state to the assembly nearest to the poses at run.at.drivers, without rates; says why there is
/// none.
[[nodiscard]] std::optional<StartFailure> assemble(Run& run);

/// The same in the modes of a branch (branch_run.hpp); false where it has no assembly at run.at.drivers.
/// run.at.state then holds the groups before the first that cannot be placed.
[[nodiscard]] bool assemble_on(Run& run, int branch);

/// The poses, with the modes of a branch.
[[nodiscard]] State posed_state(const Mechanism& mechanism, const Plan& plan, int branch);

struct Assemblies {
  std::vector<State>
      states;            ///< in the order of their distance from the poses, as the modes of each group go
  bool complete = true;  ///< false: there are more
};

/// Every combination of assembly modes that closes at run.at.drivers.
[[nodiscard]] Assemblies assemble_all(Run& run);

}  // namespace higherpair
