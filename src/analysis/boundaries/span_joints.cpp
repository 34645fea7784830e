#include "span_joints.hpp"

#include "analysis/follow/step.hpp"
#include "analysis/tolerances.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "higherpair/numeric/newton_root.hpp"
#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

const Boundary& boundary_of_side(const Run& run, const SideOfContact& at) {
  return boundary_at(run, at.contact, at.side);
}

const BoundaryPlace& place_in(const State& state, const SideOfContact& at) {
  return state.contacts[at.contact].place[at.side];
}

// Whether the contact is on another span in run.work.trial than in run.at.state.
bool is_on_other_span(const Run& run, const SideOfContact& at) {
  return place_in(run.work.trial, at).span != place_in(run.at.state, at).span;
}

std::optional<SideOfContact> changed_place(const Run& run) {
  for (const SideOfContact& at : BoundarySides(run.mechanism())) {
    if (is_on_other_span(run, at)) {
      return at;
    }
  }
  return std::nullopt;
}

// Speed of a contact along a boundary; on a corner, the turning rate of its normal relative to the body. Its
// sign is the same on either side of a joint: u1 = (ω_r + κ2 v_s) / (κ1 + κ2) and u2 = (ω_r - κ1 v_s) / (κ1 +
// κ2).
double running_speed(const Run& run, const SideOfContact& at, const State& state) {
  const ContactMotion& motion = state.contacts[at.contact];
  const Contact& contact = run.mechanism().contacts[at.contact];
  const BodyMotion& body = state.bodies[ref_of(contact, at.side).body];
  return boundary_of_side(run, at).is_corner(place_in(state, at)) ? motion.rates.phi_dot - body.omega
         : at.side == 0                                           ? motion.rates.along1
                                                                  : -motion.rates.along2;
}

// A contact's side on which the contact turns back within the step, and where.
struct Turn {
  SideOfContact at;
  double x = 0;
};

// Whether a contact that reverses its sense within the step may have been on another span in between.
bool may_have_left(const Run& run, const SideOfContact& at, double h) {
  if (is_on_other_span(run, at)) {
    return true;
  }
  const Boundary& boundary = boundary_of_side(run, at);
  const BoundaryPlace& from = place_in(run.at.state, at);
  const BoundaryPlace& to = place_in(run.work.trial, at);
  if (boundary.spans().size() == 1) {
    return false;
  }
  const double before = running_speed(run, at, run.at.state);
  const double after = running_speed(run, at, run.work.trial);
  const double end = end_of(boundary, from.span, before * h > 0).t;
  const double room =
      std::min(std::abs(distance_along(boundary, from, end)), std::abs(distance_along(boundary, to, end)));
  return !(kFartherAlong * std::max(std::abs(before), std::abs(after)) * std::abs(h) < room);
}

std::vector<Turn> turned_back(const Run& run, double h) {
  std::vector<Turn> turned;
  for (const SideOfContact& at : BoundarySides(run.mechanism())) {
    const bool touches =
        run.at.state.contacts[at.contact].touches && run.work.trial.contacts[at.contact].touches;
    if (touches && running_speed(run, at, run.at.state) * running_speed(run, at, run.work.trial) < 0 &&
        may_have_left(run, at, h)) {
      turned.push_back({at});
    }
  }
  return turned;
}

// Where a contact turns back within a step; none if the bodies cannot be placed on the way there.
// Leaves run.work.trial anywhere between.
std::optional<double> turn_within(Run& run, const Path& path, const SideOfContact& at, double s, double h) {
  const auto speed = [&](double x) {
    return solve_from_spans(run, path, s, x) ? running_speed(run, at, run.work.trial) : kNoValue;
  };
  return root_between(speed, running_speed(run, at, run.at.state), h, running_speed(run, at, run.work.trial));
}

// The part of a step up to where a contact turns back on another span than it began on, so that it may be
// back on its own at the end; run.work.trial is then at that position. The whole step if no contact does so.
double length_without_return(Run& run, const Path& path, std::vector<Turn>& turned, double s, double h) {
  double length = h;
  for (Turn& turn : turned) {
    const bool returns = change_trial(run, [&] {
      const auto x = turn_within(run, path, turn.at, s, length);
      turn.x = x.value_or(0);
      return x && *x != 0 && std::abs(*x) < std::abs(length) && solve_from_spans(run, path, s, *x) &&
             is_on_other_span(run, turn.at);
    });
    length = returns ? turn.x : length;
  }
  return length;
}

// The number of joints from a span to another one in one sense; more than there are where there is no way.
int joints_between(const Boundary& boundary, int from, int to, bool forward) {
  const int count = static_cast<int>(boundary.spans().size());
  int passed = 0;
  for (int span = from; span != to && passed <= count; ++passed) {
    const int next = boundary.next_span(span, forward);
    passed = boundary.joint_after(forward ? span : next) == SpanJoint::kEnd ? count : passed;
    span = next;
  }
  return passed;
}

// The sense in which the contact runs along a boundary, by the fewer joints or by its speed at the step's
// end.
bool runs_forward(const Run& run, const SideOfContact& at, double h) {
  const Boundary& boundary = boundary_of_side(run, at);
  const int from = place_in(run.at.state, at).span;
  const int to = place_in(run.work.trial, at).span;
  const int ahead = joints_between(boundary, from, to, true);
  const int behind = joints_between(boundary, from, to, false);
  if (ahead != behind) {
    return ahead < behind;
  }
  const double before = running_speed(run, at, run.at.state);
  const double after = running_speed(run, at, run.work.trial);
  return (before * after < 0 ? after : before) * h > 0;
}

// A joint by which the contact leaves its span on one side.
struct Exit {
  SideOfContact at;
  bool forward = true;
  BoundaryPlace before, after;  // the two places that meet there
};

Exit exit_of(const Run& run, const SideOfContact& at, double h) {
  const Boundary& boundary = boundary_of_side(run, at);
  const bool forward = runs_forward(run, at, h);
  const int span = place_in(run.at.state, at).span;
  return {at, forward, end_of(boundary, span, forward),
          end_of(boundary, boundary.next_span(span, forward), !forward)};
}

// A function that is 0 where the contact is at the joint, and its rate.
ValueAndSlope beyond_joint(const Run& run, const Exit& exit, const State& state) {
  const Boundary& boundary = boundary_of_side(run, exit.at);
  const BoundaryPlace& place = place_in(state, exit.at);
  const double sense = exit.forward ? 1 : -1;
  const double beyond =
      place.span == exit.before.span  ? -sense * distance_along(boundary, place, exit.before.t)
      : place.span == exit.after.span ? -sense * distance_along(boundary, place, exit.after.t)
                                      : boundary.size();
  return {beyond, sense * running_speed(run, exit.at, state)};
}

// Where a contact reaches the joint.
struct JointAt {
  double x = 0;
  bool solved = false;  // run.work.trial is there
};

// Where a contact reaches the joint between `from` and `to`. Over a kink that is too small for a corner it
// jumps by the turn of the kink times its distance from the centre of curvature of the other curve. \pre
// run.work.trial is at `to`
std::optional<JointAt> joint_between(Run& run, const Path& path, const Exit& exit, double s, double from,
                                     double to) {
  double solved = kNoValue;
  const auto beyond = [&](double x) {
    solved = x;
    return solve_from_spans(run, path, s, x) ? beyond_joint(run, exit, run.work.trial)
                                             : ValueAndSlope{kNoValue, kNoValue};
  };
  const double after = beyond_joint(run, exit, run.work.trial).value;
  const ValueAndSlope before = from != 0 ? beyond(from) : beyond_joint(run, exit, run.at.state);
  const auto left = before.value >= 0
                        ? std::optional(0.0)
                        : newton_root_between([&](double x) { return beyond(from + x); }, before, to - from,
                                              after, kSameJointDirection * run.plan().size);
  if (!left) {
    return std::nullopt;
  }
  return JointAt{from + *left, solved == from + *left};
}

// By which joint a contact leaves its span, and where.
struct Leaving {
  Exit exit;
  JointAt joint;
};

// Where the contact leaves its span by a joint up to run.work.trial, which is `length` beyond run.at.state.
// Leaves run.work.trial anywhere between.
std::optional<Leaving> leaving(Run& run, const Path& path, const std::vector<Turn>& turned, double s,
                               double length, const Exit& exit) {
  // If it turns back on its span, it leaves the span after that turn, though it may have begun at the joint.
  const auto turn = std::find_if(turned.begin(), turned.end(), [&](const Turn& candidate) {
    return candidate.at.contact == exit.at.contact && candidate.at.side == exit.at.side &&
           std::abs(candidate.x) < std::abs(length);
  });
  const auto joint = joint_between(run, path, exit, s, turn == turned.end() ? 0 : turn->x, length);
  return joint ? std::optional(Leaving{exit, *joint}) : std::nullopt;
}

// The first joint between run.at.state and run.work.trial, h beyond it.
std::optional<JointPassage> first_passage(Run& run, const Path& path, const std::vector<Turn>& turned,
                                          double s, double h) {
  std::optional<JointPassage> first;
  // A joint passed before the one that was found shows as a changed span there.
  while (const auto changed = changed_place(run)) {
    const double length = first ? first->x : h;
    const SideOfContact opposite{changed->contact, 1 - changed->side};
    // A contact that jumps along a flat from a corner of one body to one of the other passes a joint of the
    // body whose corner it leaves only.
    const bool may_jump = is_on_other_span(run, opposite) &&
                          boundary_of_side(run, opposite).is_corner(place_in(run.at.state, opposite));
    const auto tried = may_jump ? std::optional(run.work.trial) : std::nullopt;
    auto found = leaving(run, path, turned, s, length, exit_of(run, *changed, h));
    if (!found && tried) {
      run.work.trial = *tried;
      found = leaving(run, path, turned, s, length, exit_of(run, opposite, h));
    }
    if (!found || (first && std::abs(found->joint.x) >= std::abs(first->x))) {
      return first;
    }
    const auto& [exit, joint] = *found;
    first = JointPassage{exit.at.contact, exit.at.side, exit.before, exit.after, joint.x};
    if (!joint.solved && !solve_from_spans(run, path, s, joint.x)) {
      return first;
    }
    run.work.trial.contacts[exit.at.contact].place[exit.at.side] = place_in(run.at.state, exit.at);
  }
  if (first) {
    first->solved = true;
  }
  return first;
}

// Whether a contact has just passed the joint at the end of the path, to within rounding.
bool ends_at(const Run& run, const Path& path, double s, const JointPassage& passage) {
  return std::abs(path.length - s - passage.x) <= kJointAtEnd * unit_of(run, path) &&
         is_on_other_span(run, {passage.contact, passage.side});
}

// Puts a contact that has just passed a joint at the end of the path back onto the joint: rounding does not
// decide on which side of it a row is. Beyond a flat that lies on another one both places have changed.
void stay_before(Run& run, const JointPassage& passage, const State& at_joint) {
  if (passage.solved && lies_flat_behind(run, passage, at_joint)) {
    const std::size_t opposite = 1 - passage.side;
    set_point_of(run, passage.contact, opposite, at_joint.contacts[passage.contact].place[opposite],
                 run.work.trial);
    set_point_of(run, passage.contact, passage.side, passage.before, run.work.trial);
  }
  set_place_of(run, passage.contact, passage.side, passage.before, run.work.trial);
}

}  // namespace

bool passes_unseen(Run& run, const Path& path, double s, double h) {
  if (changed_place(run)) {
    return true;
  }
  const std::vector<Turn> turned = turned_back(run, h);
  return std::any_of(turned.begin(), turned.end(), [&](const Turn& turn) {
    const StateAside aside(run.work.trial);
    return !turn_within(run, path, turn.at, s, h);
  });
}

std::optional<JointPassage> joint_within(Run& run, const Path& path, double s, double h) {
  std::vector<Turn> turned = turned_back(run, h);
  if (turned.empty() && !changed_place(run)) {
    return std::nullopt;
  }
  State tried = run.work.trial;
  const double length = length_without_return(run, path, turned, s, h);
  const auto first = first_passage(run, path, turned, s, length);
  State at_joint = std::exchange(run.work.trial, std::move(tried));
  if (!first) {
    return std::nullopt;
  }
  if (!ends_at(run, path, s, *first)) {
    run.work.trial = std::move(at_joint);
    return first;
  }
  stay_before(run, *first, at_joint);
  set_rates_on(run, path, s + h, run.work.trial);
  return joint_within(run, path, s, h);
}

}  // namespace higherpair
