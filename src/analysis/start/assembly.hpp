#pragma once

#include "higherpair/analysis/run.hpp"

namespace higherpair {

/// A model of a mechanism, planned.
[[nodiscard]] tl::expected<RunModel, StartFailure> planned_model(const Mechanism& mechanism);

/// A mechanism with its plan at these positions of its drivers, not yet assembled.
[[nodiscard]] tl::expected<Run, StartFailure> planned_run(const Mechanism& mechanism,
                                                          const std::vector<double>& drivers);
[[nodiscard]] Run planned_run(RunModel model, const std::vector<double>& drivers);

/// Sum of the squared distances of the points of a group's joints from where the poses put them [m²]: decides
/// which assembly is nearest.
[[nodiscard]] double distance_from_poses(const Mechanism& mechanism, const Group& group,
                                         const std::vector<BodyMotion>& bodies,
                                         const std::vector<BodyMotion>& posed);

/// Sets run.at.state to the assembly at run.at.inputs that is nearest to the poses, without rates; may be
/// stopped by run.stop, and then finds none. \returns why there is none
[[nodiscard]] std::optional<StartFailure> assemble(Run& run);

/// The same in the modes of a branch (branch_run.hpp); false where the branch has no assembly at
/// run.at.inputs. run.at.state then holds the groups before the first that cannot be placed.
[[nodiscard]] bool assemble_on(Run& run, int branch);

/// The poses, with the modes of a branch.
[[nodiscard]] State posed_state(const Mechanism& mechanism, const Plan& plan, int branch);

struct Assemblies {
  std::vector<State> states;  ///< ordered by their distance from the poses, group by group
  bool complete = true;       ///< false: there are more
};

/// Every combination of assembly modes that closes at run.at.inputs.
[[nodiscard]] Assemblies assemble_all(Run& run);

}  // namespace higherpair
