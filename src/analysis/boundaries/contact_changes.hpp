#pragma once

#include "analysis/follow/limit_ahead.hpp"
#include "analysis/follow/path_events.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "joint_passage.hpp"

#include <cstddef>
#include <optional>
#include <vector>

// Changes of contacts on a path, apart from their smooth motion: an open contact closes, one that may part
// does so, one reaches a joint of spans, the bodies meet elsewhere, or another place takes over. Each
// function moves run.at.state to where the change happens and past it.

namespace higherpair {

/// How far a run has come on a path. It remembers recent changes so that none happens twice at one place.
struct OnPath {
  /// At the beginning of the path.
  OnPath(Run& run_on_it, const Path& its_path);

  Run& run;
  const Path& path;
  double scale;                     ///< one unit of the path's coordinate
  double s = 0;                     ///< position of run.at.state on the path
  bool open;                        ///< whether a contact is open
  double parted_at = kNoValue;      ///< s where contacts parted last
  std::vector<int> parted;          ///< the groups whose contacts did
  double taken_over_at = kNoValue;  ///< s of the last place that took over
  double met_at = kNoValue;         ///< s of the last meeting elsewhere
  JointPassage passed;              ///< the last one, at s = passed.x
};

/// Moves run.at.state on to run.work.trial, `x` beyond it, and records the events on the way.
void advance(OnPath& at, double x);

/// Moves to where an open contact closes in a step of `h` to run.work.trial, unless another contact reaches a
/// joint of spans before that. Otherwise returns false and leaves run.work.trial unchanged.
[[nodiscard]] bool close_open_contact(OnPath& at, double h);

/// At a limit, goes on without a contact that may part; false if there is none.
[[nodiscard]] bool part_contact(OnPath& at, const PathLimit& limit);

/// Moves to where touching bodies meet elsewhere in a step of `h` to run.work.trial, and goes on with the
/// contact there if that is possible; false where they do not meet.
[[nodiscard]] bool meet_elsewhere(OnPath& at, double h);

/// Where the contact of group g ends, goes on with another place at which the same bodies touch; false if
/// there is none.
[[nodiscard]] bool hand_over(OnPath& at, std::size_t g);

/// Two corners that meet have no common normal, which looks like a limit: goes on beyond it; false at other
/// limits.
[[nodiscard]] bool pass_vertex(OnPath& at, const PathLimit& limit);

/// What happened at a joint of spans in a step.
struct JointOutcome {
  enum Kind {
    kRests,     ///< the contact stays on it, to within rounding; run.work.trial is again that of the step
    kPassed,    ///< run.at.state is at it, already on the span beyond
    kDiverted,  ///< the motion goes on differently, e.g. with another contact; step control starts anew
    kBroken,    ///< a group's motion up to it is not smooth; run.work.trial as above
    kEnds,      ///< run.at.state is at it, and the group cannot go on
  } kind = kRests;
  std::size_t group = 0;
};

/// Moves to a joint of spans in a step of `h`. Accelerations may jump there, so the next step begins beyond
/// it.
[[nodiscard]] JointOutcome pass_joint(OnPath& at, const JointPassage& passage, double h);

}  // namespace higherpair
