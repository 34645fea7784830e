#include "gap_contacts.hpp"

#include "analysis/follow/events.hpp"
#include "analysis/follow/joint_ends.hpp"
#include "analysis/groups/group_kinds.hpp"
#include "analysis/tolerances.hpp"
#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/geometry/edges.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "meetings.hpp"
#include "other_place.hpp"
#include "passings.hpp"
#include "span_ends.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr int kMostNudges = 24;

const Contact& contact_of(const Run& run, const TouchingBody& touching) {
  return run.mechanism().contacts[touching.contact];
}

// Sample places of a boundary next to those with the outward normal n_B: one on each part that has this
// normal.
std::vector<BoundaryPlace> facing_places(const Boundary& boundary, const Vector2d& n_B) {
  std::vector<BoundaryPlace> found;
  const auto& samples = boundary.samples();
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const auto& a = samples[i - 1];
    const auto& b = samples[i];
    const Vector2d middle = a.point.n_B + b.point.n_B;
    const bool between =
        cross(a.point.n_B, n_B) * cross(n_B, b.point.n_B) >= -kOnSample && middle.dot(n_B) > 0;
    if (a.place.span == b.place.span && between) {
      found.push_back(a.point.n_B.dot(n_B) > b.point.n_B.dot(n_B) ? a.place : b.place);
    }
  }
  return found;
}

// The ends that the other curve may pass on its way in. Edges are left out: a curve comes onto an edge by
// touching it.
std::vector<Passing> passings_of(const Run& run, const Contact& contact) {
  std::vector<Passing> all;
  const auto add = [&](const CurveRef& own, const CurveRef& other) {
    const Boundary& boundary = boundary_of(run.mechanism(), own);
    for (int span = 0; span < static_cast<int>(boundary.spans().size()); ++span) {
      if (!is_edge(boundary, span)) {
        append_passings(
            run, own, other, span, [](SpanJoint joint) { return joint == SpanJoint::kEnd; }, all);
      }
    }
  };
  add(contact.first, contact.second);
  add(contact.second, contact.first);
  return all;
}

// Where the other curve comes in past an end, near one of its places.
std::optional<Engagement> entry(Run& run, const Path& path, std::size_t g, double s, double h,
                                const Passing& passing, const BoundaryPlace& near) {
  const auto before = passing_at(run, passing, run.at.state, near);
  const auto x = before && before->beyond > 0 ? passing_within(run, path, s, h, passing, near) : std::nullopt;
  if (!x) {
    return std::nullopt;
  }
  const auto there = with_trial<PassingAt>(
      run, path, s, *x, [&](const State& state) { return passing_at(run, passing, state, near); });
  if (!there || !(std::abs(there->beside) <= kCapture * run.plan().size)) {
    return std::nullopt;
  }
  const Contact& contact = contact_of(run, touching_of(run, g));
  const bool own_is_first = passing.own == contact.first;
  const BoundaryPlace& first = own_is_first ? passing.end : there->other;
  return Engagement{g, *x, {first, own_is_first ? there->other : passing.end}};
}

// The places of the other curve that may face an end in run.at.state.
std::vector<BoundaryPlace> facing_places(const Run& run, const Passing& passing) {
  const Vector2d n_W = run.at.state.bodies[passing.own.body].X_WB.R_WB *
                       boundary_of(run.mechanism(), passing.own).at(passing.end).n_B;
  const Pose<double>& X_WC = run.at.state.bodies[passing.other.body].X_WB;
  return facing_places(boundary_of(run.mechanism(), passing.other), X_WC.R_WB.inverse() * Vector2d(-n_W));
}

enum class Closing {
  kClosed,
  kNone,  // the curves do not meet
  kFar,   // they meet, but the body would have to jump there
};

// How far a unit of the follower's coordinate moves its farthest point.
double lever_of_follower(const BoundaryPair& pair) {
  return pair.motion2.turns ? pair.boundary2->size() + pair.boundary2->middle_B().norm() : 1;
}

// Closes a contact that is open in `state`.
Closing close_contact(const Run& run, const Engagement& at, State& state) {
  const TouchingBody& touching = touching_of(run, at.group);
  const Planned model = model_of(run);
  const FrozenPair placed = frozen_pair(model, touching, state);
  const BoundaryPair pair = frozen_boundaries(model, touching, placed);
  const CarriedBody& follower = touching.follower;
  const double turned = carrier_angle(follower, state.bodies);
  auto [place1, place2] = at.place;
  if (!touching.follower_is_second) {
    std::swap(place1, place2);
  }
  const BoundaryResult result =
      solve_boundary_contact(pair, placed.u, state.groups[at.group].open_at + turned, place1, place2, 0);
  if (result.status != ContactStatus::kOk || result.contact.gap_q == 0) {
    return Closing::kNone;
  }
  const BoundaryContact& found = result.contact;
  const double shift = std::abs(found.q - state.groups[at.group].open_at - turned) * lever_of_follower(pair);
  if (!(shift <= kFarthestShift * run.plan().size)) {
    return Closing::kFar;
  }
  ContactMotion& motion = state.contacts[touching.contact];
  const double phi = motion.phi;
  motion = {};
  move_contact(touching, found, phi, motion);
  state.bodies[follower.body] = motion_at(pair.motion2, found.q, 0, 0);
  GroupState& group = state.groups[at.group];
  group.open = false;
  group.mode = found.gap_q < 0 ? -1 : 1;
  return Closing::kClosed;
}

const std::string& follower_name(const Run& run, const TouchingBody& touching) {
  return run.mechanism().bodies[touching.follower.body].name;
}

// Continues run.at.state, which is at s, with the contact open, though the bodies overlap.
void report_strike(Run& run, const Path& path, double s, const TouchingBody& touching) {
  const auto contact = static_cast<std::size_t>(touching.contact);
  run.at.watches[contact].overlaps = true;
  const char* how =
      contact_of(run, touching).both_sides
          ? "come together through a wall beside the curve, not at its end"
          : "strike each other at the end of a curve, beside the edge there or where it has none";
  report_contact(run, EventType::kOverlap, path, s, contact,
                 fmt::format("the bodies {}: the contact cannot hold {}", how, follower_name(run, touching)));
}

// The coordinate at which a follower stays when its contact opens in run.at.state. At the end of its joint
// that end itself: the search leaves it a rounding away, where the joint might no longer carry it.
double rest_of(const Run& run, std::size_t g) {
  const CarriedBody& follower = touching_of(run, g).follower;
  const auto end = joint_at_end(model_of(run), g, run.at.state);
  if (!end) {
    return carried_coordinate(follower, run.at.state.bodies);
  }
  const Joint& joint = run.mechanism().joints[end->joint];
  return follower.sign * (end->upper ? *joint.to : *joint.from);
}

// Whether the bodies of a contact come together on the path in a state where it is open.
// \param at  the contact before it was opened
bool pushes_on(const Run& run, const Path& path, const TouchingBody& touching, const CommonNormal& at,
               const State& open) {
  const Contact& contact = contact_of(run, touching);
  const Vector2d v1 = motion_at_place(open.bodies[contact.first.body], at.p1_W).v_W;
  const Vector2d v2 = motion_at_place(open.bodies[contact.second.body], at.p2_W).v_W;
  const double sense = path.length < 0 ? -1 : 1;
  return sense * at.n_W.dot(v2 - v1) < -kPushes * (v1.norm() + v2.norm());
}

// The part of an event's sentence that names the curve which touches with the edge at its end.
std::string edge_text(const Run& run, const TouchingBody& touching) {
  const Contact& contact = contact_of(run, touching);
  const auto& places = run.at.state.contacts[touching.contact].place;
  for (std::size_t side = 0; side < 2; ++side) {
    const CurveRef& ref = ref_of(contact, side);
    if (is_edge(boundary_of(run.mechanism(), ref), places[side].span)) {
      return fmt::format(" at the edge at the end of the curve of {}", run.mechanism().bodies[ref.body].name);
    }
  }
  return "";
}

}  // namespace

bool has_open_contact(const State& state) {
  return std::any_of(state.groups.begin(), state.groups.end(),
                     [](const GroupState& group) { return group.open; });
}

std::optional<Engagement> engagement_within(Run& run, const Path& path, double s, double h) {
  std::optional<Engagement> first;
  const auto take = [&](std::optional<Engagement> found) {
    if (found && (!first || std::abs(found->x) < std::abs(first->x))) {
      first = found;
    }
  };
  for (std::size_t g = 0; g < run.plan().groups.size(); ++g) {
    if (!run.at.state.groups[g].open) {
      continue;
    }
    const Contact& contact = contact_of(run, touching_of(run, g));
    for (const Passing& passing : passings_of(run, contact)) {
      for (const BoundaryPlace& near : facing_places(run, passing)) {
        take(entry(run, path, g, s, h, passing, near));
      }
    }
    const auto index = static_cast<std::size_t>(touching_of(run, g).contact);
    if (!run.at.watches[index].overlaps) {
      const auto closing = meeting_within(run, path, index, s, h).first;
      if (closing) {
        take(Engagement{g,
                        closing->x,
                        {closing->place.place1, closing->place.place2},
                        contact.both_sides || closing->place.end != 0});
      }
    }
  }
  return first;
}

std::optional<double> engage(Run& run, const Path& path, double s, const Engagement& engagement) {
  const TouchingBody& touching = touching_of(run, engagement.group);
  double nudge = 0;
  for (int i = 0; i < kMostNudges; ++i, nudge = nudge == 0 ? kFirstNudge : 4 * nudge) {
    const double x = engagement.x + nudge * (path.length > 0 ? 1 : -1) * unit_of(run, path);
    if (!solve_at(run, path, s, x)) {
      return std::nullopt;
    }
    State closed = run.work.trial;
    const Closing closing = engagement.strikes ? Closing::kFar : close_contact(run, engagement, closed);
    if (closing == Closing::kNone) {
      continue;
    }
    if (closing == Closing::kClosed) {
      const StateAside aside(run.work.trial);
      if (!solve_from(run, closed, path, s + x, 0)) {
        continue;  // by a rounding the follower would still be at its stop
      }
      closed = run.work.trial;
    }
    note_events(run, path, s, x);
    if (closing == Closing::kFar) {
      std::swap(run.at.state, run.work.trial);
      report_strike(run, path, s + x, touching);
      return x;
    }
    run.at.state = std::move(closed);
    const auto contact = static_cast<std::size_t>(touching.contact);
    run.at.watches[contact].interrupt();
    RunEvent& event = report_contact(run, EventType::kEngage, path, s + x, contact,
                                     "the two bodies begin to touch" + edge_text(run, touching));
    add_rate_jump(run, path, touching.follower, {0, follower_rate(run.at.state, touching.follower)}, event);
    return x;
  }
  return std::nullopt;
}

std::optional<Parting> why_parting(const Run& run, std::size_t g) {
  const auto* touching = std::get_if<TouchingBody>(&run.plan().groups[g].kind);
  if (touching == nullptr || contact_of(run, *touching).keep != Keep::kGap || run.at.state.groups[g].open) {
    return std::nullopt;
  }
  if (end_reached(run, g)) {
    return Parting{"the contact leaves the end of a curve"};
  }
  const bool one_sided = !contact_of(run, *touching).both_sides;
  if (one_sided && joint_at_end(model_of(run), g, run.at.state)) {
    return Parting{fmt::format("{} comes to the end of its guide", follower_name(run, *touching)), true};
  }
  if (slipped_off(run, g)) {
    return Parting{"the contact slips off the edge at the end of a curve", one_sided};
  }
  return std::nullopt;
}

bool release(Run& run, const Path& path, double s, std::size_t g, const Parting& parting, bool has_rates) {
  const TouchingBody& touching = touching_of(run, g);
  const double before = has_rates ? follower_rate(run.at.state, touching.follower) : kNoValue;
  State open = run.at.state;
  GroupState& group = open.groups[g];
  group.open = true;
  group.open_at = rest_of(run, g);
  const auto contact = static_cast<std::size_t>(touching.contact);
  const CommonNormal at = run.at.state.contacts[contact].at;
  if (!solve_from(run, open, path, s, 0) ||
      (parting.may_jam && pushes_on(run, path, touching, at, run.work.trial))) {
    return false;
  }
  run.at.state = run.work.trial;
  run.at.watches[contact].overlaps = false;
  RunEvent& event = report_contact(run, EventType::kRelease, path, s, contact,
                                   fmt::format("{}: the bodies part and {} stays where it is", parting.reason,
                                               follower_name(run, touching)));
  if (has_rates) {
    add_rate_jump(run, path, touching.follower, {before, 0}, event);
  }
  return true;
}

bool starts_open(const BoundaryPair& pair, double u, double posed, std::optional<double> nearest,
                 const Bounds& guide, const Contact& contact, double size) {
  if (contact.both_sides || !nearest) {
    return !nearest;  // between two walls a body always touches one
  }
  const bool apart = std::abs(*nearest - posed) * (lever_of_follower(pair) / size) > kStartsApart;
  return (apart || !guide.contains(*nearest)) &&
         !bodies_overlap(*pair.boundary1, pose_at(pair.motion1, u), *pair.boundary2,
                         pose_at(pair.motion2, posed), kOverlapOfBoundaries * size);
}

}  // namespace higherpair
