#pragma once

#include "joint_passage.hpp"
#include "limit_ahead.hpp"
#include "straight_path.hpp"

#include <cstddef>
#include <limits>
#include <optional>

// What becomes of the contacts on a path besides that they go on smoothly: one that is open closes, one that
// may part does so, one comes to a joint of spans, the bodies meet elsewhere, another place takes over. Each
// of these moves run.at.state to where it happens and past it.

namespace higherpair {

/// How far a run has come on a path. Nothing happens twice at one place.
struct OnPath {
  /// At its begin.
  OnPath(Run& run_on_it, const Path& its_path);

  Run& run;
  const Path& path;
  double scale;                                                     ///< one unit of the path's coordinate
  double s = 0;                                                     ///< of run.at.state
  bool open;                                                        ///< a contact is
  double parted_at = std::numeric_limits<double>::quiet_NaN();      ///< s of the last contact that parted
  double taken_over_at = std::numeric_limits<double>::quiet_NaN();  ///< s of the last place that took over
  double met_at = std::numeric_limits<double>::quiet_NaN();         ///< s of the last meeting elsewhere
  JointPassage passed;                                              ///< the last one, at s = passed.x
};

/// Goes on to run.work.trial, `x` beyond run.at.state, with the events on the way.
void advance(OnPath& at, double x);

struct StepTaken {
  std::optional<double> rather;  ///< the step to try instead: nothing has been taken
  bool gone_over = false;        ///< to a second contact
};

/// The same with a step of `h`, unless a driver and follower go over to a second contact well within it: they
/// do so just behind the place, since what else happens is that of the one contact or of the other.
[[nodiscard]] StepTaken take_step(OnPath& at, double h);

/// Goes to where an open contact closes in a step of `h` to run.work.trial, unless another contact comes to a
/// joint of spans before that. False, and run.work.trial as it was, where none does.
[[nodiscard]] bool close_open_contact(OnPath& at, double h);

/// Where the motion of group g cannot go on, goes on without a contact that may part; false where none may.
[[nodiscard]] bool part_contact(OnPath& at, std::size_t g);

/// Goes to where touching boundaries meet elsewhere in a step of `h` to run.work.trial; false where they do
/// not.
[[nodiscard]] bool meet_elsewhere(OnPath& at, double h);

/// Where the contact of group g ends, goes on with another place at which the same bodies touch; false where
/// there is none.
[[nodiscard]] bool hand_over(OnPath& at, std::size_t g);

/// What looks like a limit may be where two corners meet, which have no normal to go on with: goes on beyond
/// it; false at others.
[[nodiscard]] bool pass_vertex(OnPath& at, const PathLimit& limit);

/// What came of a joint of spans in a step.
struct JointOutcome {
  enum Kind {
    kRests,     ///< the contact rests on it, to within rounding: run.work.trial is that of the step again
    kPassed,    ///< run.at.state is at it, and goes on beyond it
    kDiverted,  ///< the motion goes on anew in another way
    kBroken,    ///< the motion of a group does not go on smoothly to it; run.work.trial as above
    kEnds,      ///< run.at.state is at it, and a group cannot go on
  } kind = kRests;
  std::size_t group = 0;
};

/// Goes to a joint of spans in a step of `h`, where accelerations may jump, so that the next one begins
/// beyond it.
[[nodiscard]] JointOutcome pass_joint(OnPath& at, const JointPassage& passage, double h);

}  // namespace higherpair
