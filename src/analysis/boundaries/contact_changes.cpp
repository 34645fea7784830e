#include "contact_changes.hpp"

#include "analysis/follow/events.hpp"
#include "analysis/follow/step.hpp"
#include "analysis/tolerances.hpp"
#include "flat_contacts.hpp"
#include "gap_contacts.hpp"
#include "higherpair/contact/step_length.hpp"
#include "higherpair/numeric/contains.hpp"
#include "overlap.hpp"
#include "shared_places.hpp"
#include "span_ends.hpp"
#include "span_joints.hpp"

#include <cmath>
#include <utility>

namespace higherpair {
namespace {

bool has_just_passed(const OnPath& at, const JointPassage& passage) {
  return passage.contact == at.passed.contact && passage.side == at.passed.side &&
         passage.after.span == at.passed.before.span &&
         std::abs(at.s + passage.x - at.passed.x) <= shortest_step(at.scale, 0);
}

// Whether the contact, at the joint, comes with a corner of one body onto a corner of the other.
bool meets_corners(const Run& run, const JointPassage& passage) {
  const std::size_t other = 1 - passage.side;
  return boundary_at(run, passage.contact, passage.side).is_corner(passage.after) &&
         boundary_at(run, passage.contact, other)
             .is_corner(run.at.state.contacts[passage.contact].place[other]);
}

// Goes on at another place at which the two bodies of group g touch, if there is one.
bool go_elsewhere(OnPath& at, std::size_t g) {
  if (at.s == at.taken_over_at || !take_over(at.run, at.path, at.s, g)) {
    return false;
  }
  at.taken_over_at = at.s;
  return true;
}

// Goes on from the joint at which run.at.state is.
JointOutcome go_on_from_joint(OnPath& at, const JointPassage& passage) {
  const std::size_t g = *group_with_contact(at.run.plan(), static_cast<int>(passage.contact));
  // At an edge, another place at which the bodies touch takes over, if there is one.
  if (is_on_edge(at.run, passage.contact, passage.side, passage.after) && hand_over(at, g)) {
    return {JointOutcome::kDiverted};
  }
  if (meets_corners(at.run, passage)) {
    // Two corners have no common normal of their own.
    const bool goes_on = pass_vertex(at, {g, at.s}) || go_elsewhere(at, g);
    return {goes_on ? JointOutcome::kDiverted : JointOutcome::kEnds, g};
  }
  if (!lies_flat_behind(at.run, passage)) {
    go_over_joint(at.run, at.path, at.s, passage);
    const bool yields =
        joint_of(at.run, passage) != SpanJoint::kSmooth && yield_to_shared_place(at.run, at.path, at.s, g);
    return {yields ? JointOutcome::kDiverted : JointOutcome::kPassed};
  }
  const auto rests = go_over_flat(at.run, at.path, at.s, passage);
  if (!rests) {
    return {JointOutcome::kEnds, g};
  }
  at.passed = *rests;
  at.passed.x = at.s;
  return {JointOutcome::kDiverted};
}

}  // namespace

OnPath::OnPath(Run& run_on_it, const Path& its_path)
    : run(run_on_it), path(its_path), scale(unit_of(run, path)), open(has_open_contact(run.at.state)) {}

void advance(OnPath& at, double x) {
  note_events(at.run, at.path, at.s, x);
  std::swap(at.run.at.state, at.run.work.trial);
  at.s += x;
  end_overlaps(at.run);
}

bool close_open_contact(OnPath& at, double h) {
  Run& run = at.run;
  const auto engagement = at.open ? engagement_within(run, at.path, at.s, h) : std::nullopt;
  if (!engagement) {
    return false;
  }
  return change_trial(run, [&] {
    if (const auto passage = joint_within(run, at.path, at.s, h);
        passage && std::abs(passage->x) < std::abs(engagement->x)) {
      return false;
    }
    const auto x = engage(run, at.path, at.s, *engagement);
    if (x) {
      at.s += *x;
      at.open = has_open_contact(run.at.state);
    }
    return x.has_value();
  });
}

bool part_contact(OnPath& at, const PathLimit& limit) {
  if (at.s != at.parted_at) {
    at.parted.clear();
  }
  const auto group = static_cast<int>(limit.group);
  const auto parting = contains(at.parted, group) ? std::nullopt : why_parting(at.run, limit.group);
  if (!parting) {
    return false;
  }
  StateAside aside(at.run.at.state);
  const bool turns_back = place_at_limit(at.run, at.path, limit, at.s);
  const double s = turns_back ? limit.s : at.s;
  if (turns_back) {
    at.run.at.state = at.run.work.trial;
  }
  if (!release(at.run, at.path, s, limit.group, *parting, !turns_back)) {
    return false;
  }
  aside.commit();
  at.s = s;
  at.parted_at = at.s;
  at.parted.push_back(group);
  at.open = true;
  return true;
}

bool meet_elsewhere(OnPath& at, double h) {
  Run& run = at.run;
  const Meetings meetings = meetings_elsewhere(run, at.path, at.s, h);
  const auto& meeting = meetings.first;
  if (!meeting) {
    for (const SharedTouch& touch : meetings.sharing) {
      note_shared_places(run, at.path, touch, at.s, h);
    }
    return false;
  }
  if (meeting->x != 0) {
    if (!change_trial(run, [&] { return solve_at(run, at.path, at.s, meeting->x); })) {
      return false;
    }
    for (const SharedTouch& touch : meetings.sharing) {
      note_shared_places_until(run, at.path, touch, at.s, meeting->x);
    }
    advance(at, meeting->x);
  }
  // If they meet again at once, neither contact can be kept.
  const bool again = at.s == at.met_at;
  go_over_to(run, at.path, at.s, *meeting, !again);
  at.met_at = at.s;
  return true;
}

bool hand_over(OnPath& at, std::size_t g) {
  const bool at_end = end_reached(at.run, g) || is_at_edge(at.run, g) || slipped_off(at.run, g) ||
                      is_at_ends_of_both(at.run, g);
  return at_end && go_elsewhere(at, g);
}

bool pass_vertex(OnPath& at, const PathLimit& limit) {
  if (limit.s == at.taken_over_at || std::abs(limit.s) > std::abs(at.path.length) ||
      !go_over_vertex(at.run, at.path, limit.s, limit.group)) {
    return false;
  }
  at.s = limit.s;
  at.taken_over_at = at.s;
  return true;
}

JointOutcome pass_joint(OnPath& at, const JointPassage& passage, double h) {
  Run& run = at.run;
  if (has_just_passed(at, passage) || !place_at_joint(run, at.path, at.s, passage)) {
    // The contact stays on the joint: either span describes it.
    (void)try_step(run, at.path, at.s, h);
    return {JointOutcome::kRests};
  }
  if (const auto group = broken_off(run, passage.x)) {
    (void)try_step(run, at.path, at.s, h);
    return {JointOutcome::kBroken, *group};
  }
  if (meet_elsewhere(at, passage.x)) {
    return {JointOutcome::kDiverted};
  }
  if (passage.x != 0) {
    advance(at, passage.x);
  }
  at.passed = passage;
  at.passed.x = at.s;
  return go_on_from_joint(at, passage);
}

}  // namespace higherpair
