#include "first_position.hpp"

#include "analysis/boundaries/gap_contacts.hpp"
#include "analysis/follow/inputs.hpp"
#include "analysis/follow/step.hpp"
#include "analysis/groups/coupled_bodies.hpp"
#include "analysis/groups/group_kinds.hpp"
#include "analysis/tolerances.hpp"
#include "assembly.hpp"
#include "higherpair/contact/finder.hpp"
#include "higherpair/contact/separation.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/tolerances.hpp"
#include "higherpair/numeric/contains.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "start_failures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace higherpair {
namespace {

// The sense in which the follower's coordinate moves to the first contact.
int first_sense(Approach approach, double sign) {
  return (approach == Approach::kPositive) == (sign > 0) ? 1 : -1;
}

FindResult first_contact(const ContactPair& pair, Approach approach, double u, double q, double sign) {
  if (approach == Approach::kNearest) {
    return find_nearest_contact(pair, u, q);
  }
  return find_contact(pair, u, q, first_sense(approach, sign));
}

// Of all contacts at which the bodies do not overlap, the nearest, or the first in the sense of `approach`;
// none once the run has been stopped. Of several that are made at the same time, as by the teeth of gears,
// those that stop the follower in that sense come first, then the first along curve 1: rounding must not
// decide.
std::optional<BoundaryContact> first_boundary_contact(const Run& run, const BoundaryPair& pair,
                                                      const Contact& contact, double u, double q,
                                                      double sign) {
  const int sense = contact.approach == Approach::kNearest ? 0 : first_sense(contact.approach, sign);
  const double size = run.plan().size;
  const double unit = pair.motion2.turns ? 1 : size;
  std::vector<BoundaryContact> contacts = find_boundary_contacts(pair, u);
  const auto distance = [&](const BoundaryContact& found) {
    return sense == 0 ? std::abs(found.q - q)
                      : distance_ahead(pair.motion2, q, sense, found.q, kTouchAtStart * unit);
  };
  for (BoundaryContact& found : contacts) {
    if (pair.motion2.turns) {
      found.q = nearest_turn(found.q, q);
      found.q = nearest_turn(found.q, q + sense * distance(found));
    }
  }
  std::sort(contacts.begin(), contacts.end(),
            [&](const BoundaryContact& a, const BoundaryContact& b) { return distance(a) < distance(b); });
  const auto rank = [&](const BoundaryContact& found) {
    return std::tuple(sense * found.gap_q > 0, found.place1.span, found.place1.t);
  };
  std::optional<BoundaryContact> first;
  double last = kInf;  // the greatest distance at which a contact is made at the same time as the first
  for (const BoundaryContact& found : contacts) {
    if (is_stopped(run)) {
      return std::nullopt;
    }
    if (!(distance(found) <= last)) {
      break;
    }
    if ((!first || rank(found) < rank(*first)) && distance(found) >= 0 && found.gap_q != 0 &&
        (contact.both_sides || !bodies_overlap(*pair.boundary1, pose_at(pair.motion1, u), *pair.boundary2,
                                               pose_at(pair.motion2, found.q), kOverlapDepth * size))) {
      if (!first) last = distance(found) + kTouchAtOnce * unit;
      first = found;
    }
  }
  return first;
}

bool starts_rolling(const Mechanism& mechanism, const Group& group) {
  return traits_of(group).coupled &&
         std::any_of(group.contacts.begin(), group.contacts.end(),
                     [&](int contact) { return mechanism.contacts[contact].rolling; });
}

// The coordinates of a follower between the ends of its joint, to within rounding.
Bounds guide_of(const Planned& model, const TouchingBody& touching, std::size_t g) {
  Bounds guide{-kInf, kInf};
  const double rounding = kBeyondJointEnd * model.plan.size;
  for (const int index : model.plan.groups[g].ended_joints) {
    const Joint& joint = model.mechanism.joints[index];
    guide = {joint.from.value_or(-kInf) - rounding, joint.to.value_or(kInf) + rounding};
  }
  return touching.follower.sign < 0 ? -guide : guide;
}

}  // namespace

FirstPosition::FirstPosition(const Run& run)
    : run_(run), model_(model_of(run)), posed_(run.at.state), state_(run.at.state) {
  set_unit_motions(run, run.at.inputs, drivers_);
}

bool FirstPosition::place(std::size_t g, int mode) {
  const Group& group = run_.plan().groups[g];
  state_.groups[g].mode = mode;
  // Earlier tries must not affect the result, not even in its last digit.
  for (const int body : group.bodies) {
    state_.turns[body] = {};
  }
  if (const auto* tracked = std::get_if<TrackedPair>(&group.kind)) {
    return start_tracked(*tracked, g);
  }
  const auto* touching = std::get_if<TouchingBody>(&group.kind);
  if (touching != nullptr && !start_touching(*touching, g)) {
    return false;
  }
  if (traits_of(group).coupled) {
    start_coupled(group);
  }
  const State& from = touching != nullptr ? touching_start_ : posed_;
  const GroupStatus status = starts_rolling(run_.mechanism(), group)
                                 ? start_rolling_bodies(g)
                                 : place_group(model_, g, from, 0, drivers_, state_);
  if (status != GroupStatus::kOk) {
    fail(g, why_unplaced(run_, state_, g),
         distance_from_poses(run_.mechanism(), group, state_.bodies, posed_.bodies));
    return false;
  }
  return true;
}

void FirstPosition::fail(std::size_t g, std::string reason, double distance) {
  // Keep the reason of the last group that was reached, and of its assemblies that of the nearest to the
  // poses.
  if (g > failed_group_ || (g == failed_group_ && !(distance > failed_distance_))) {
    failed_group_ = g;
    failed_distance_ = distance;
    failure_ = {std::move(reason), std::nullopt};
  }
}

// At the start there are no arcs yet: rolling bodies only have to touch, and bodies that only rolling turns
// keep their angles. Rolling is measured from there.
GroupStatus FirstPosition::start_rolling_bodies(std::size_t g) {
  const Group& group = run_.plan().groups[g];
  Mechanism slipping = run_.mechanism();
  for (const int contact : group.contacts) {
    slipping.contacts[contact].rolling = false;
  }
  const GroupStatus status = place_coupled({slipping, run_.plan()}, g, posed_, 0, drivers_, state_,
                                           phase_bodies_of(run_.plan(), group));
  for (const int contact : group.contacts) {
    start_arcs(run_.mechanism(), run_.mechanism().contacts[contact], state_.bodies, state_.contacts[contact]);
  }
  judge_coupled(model_, g, state_);
  return status;
}

bool FirstPosition::start_tracked(const TrackedPair& tracked, std::size_t g) {
  const Contact& contact = run_.mechanism().contacts[tracked.contact];
  const double u = tracked.driver_sign * run_.at.inputs[tracked.driver];
  const double q = carried_coordinate(tracked.follower, posed_.bodies);
  const FindResult found = first_contact(tracked.pair, contact.approach, u, q, tracked.follower.sign);
  const bool anywhere = moves_in_itself(tracked.pair.curve2, tracked.pair.motion2);
  const double touching = found.status == FindStatus::kFound && !anywhere ? found.at.q : q;
  if (contact.rolling) {
    if (!start_rolling_pair(tracked, g, u, q, found)) {
      return false;
    }
  } else if (const auto dwell = dwell_contact(tracked.pair, u, touching, run_.tolerance * run_.plan().size)) {
    state_.tracks[g] = *dwell;
  } else if (found.status != FindStatus::kFound) {
    fail(g, why_no_contact(found.status, contact));
    return false;
  } else {
    state_.groups[g].mode = found.branch == 0 ? 1 : found.branch;
    state_.tracks[g] = start_track(tracked.pair, found.at, state_.groups[g].mode);
  }
  const State from = state_;
  if (place_group(model_, g, from, 0, drivers_, state_) != GroupStatus::kOk) {
    fail(g, why_unplaced(run_, state_, g));
    return false;
  }
  return true;
}

bool FirstPosition::start_rolling_pair(const TrackedPair& tracked, std::size_t g, double u, double q,
                                       const FindResult& found) {
  const ContactPair& pair = tracked.pair;
  const Separation here = separation(pair.curve1, pose_at(pair.motion1, u), pair.curve2,
                                     pose_at(pair.motion2, q), kRoughNormal * run_.plan().size);
  RollingTrack track;
  const RollingResult start = start_rolling(track, pair, u, q, here.n_W);
  if (start.converged && start.mismatch <= run_.tolerance * run_.plan().size) {
    state_.tracks[g] = track;
    return true;
  }
  const Contact& contact = run_.mechanism().contacts[tracked.contact];
  if (found.status != FindStatus::kFound) {
    fail(g, why_no_contact(found.status, contact));
    return false;
  }
  fail(g, "contacts." + contact.name +
              ": this pair cannot roll; set rolling = false, or choose curves and joints whose contact point "
              "stays at the instant centre");
  failure_.slip = Slip{run_.at.inputs[tracked.driver], found.at.sliding, tracked.contact};
  return false;
}

// Finds the contact of a body that depends on bodies placed before; place_group then starts from it.
bool FirstPosition::start_touching(const TouchingBody& touching, std::size_t g) {
  const Contact& contact = run_.mechanism().contacts[touching.contact];
  const CarriedBody& follower = touching.follower;
  touching_start_ = state_;
  const FrozenPair placed = frozen_pair(model_, touching, state_);
  const double posed = carried_coordinate(follower, posed_.bodies) + carrier_angle(follower, state_.bodies);
  if (contact.by_boundary) {
    return start_on_boundaries(touching, g, placed, posed);
  }
  const FindResult found = first_contact(placed.pair, contact.approach, placed.u, posed, follower.sign);
  if (found.status != FindStatus::kFound) {
    fail(g, why_no_contact(found.status, contact));
    return false;
  }
  if (found.branch == 0) {
    fail(g, "contacts." + contact.name + ": " + kTouchesAtLimit);
    return false;
  }
  state_.groups[g].mode = found.branch;
  touching_start_.bodies[follower.body] = motion_at(placed.pair.motion2, found.at.q, 0, 0);
  ContactMotion& motion = touching_start_.contacts[touching.contact];
  motion.at.n_W = touching.follower_is_second ? found.at.n_W : Vector2d(-found.at.n_W);
  motion.phi = angle_of(motion.at.n_W);
  return true;
}

bool FirstPosition::start_on_boundaries(const TouchingBody& touching, std::size_t g, const FrozenPair& placed,
                                        double posed) {
  const Contact& contact = run_.mechanism().contacts[touching.contact];
  const BoundaryPair pair = frozen_boundaries(model_, touching, placed);
  const double size = run_.plan().size;
  if (contact.approach != Approach::kNearest && !contact.both_sides &&
      bodies_overlap(*pair.boundary1, pose_at(pair.motion1, placed.u), *pair.boundary2,
                     pose_at(pair.motion2, posed), kOverlapDepth * size)) {
    fail(g, why_no_contact(FindStatus::kOverlapAtStart, contact));
    return false;
  }
  const auto found = first_boundary_contact(run_, pair, contact, placed.u, posed, touching.follower.sign);
  GroupState& group = touching_start_.groups[g];
  group.open = contact.keep == Keep::kGap &&
               starts_open(pair, placed.u, posed, found ? std::optional(found->q) : std::nullopt,
                           guide_of(model_, touching, g), contact, size);
  if (group.open) {
    group.open_at = carried_coordinate(touching.follower, posed_.bodies);
    return true;
  }
  if (!found) {
    fail(g, why_no_contact(FindStatus::kNoContact, contact));
    return false;
  }
  state_.groups[g].mode = found->gap_q < 0 ? -1 : 1;
  touching_start_.bodies[touching.follower.body] = motion_at(pair.motion2, found->q, 0, 0);
  ContactMotion& motion = touching_start_.contacts[touching.contact];
  move_contact(touching, *found, 0, motion);
  motion.phi = angle_of(motion.at.n_W);
  return true;
}

// Newton's method starts from the common normal of the bodies in their poses.
void FirstPosition::start_coupled(const Group& group) {
  for (const int index : group.contacts) {
    const Contact& contact = run_.mechanism().contacts[index];
    const auto pose = [&](const CurveRef& ref) {
      const auto body = static_cast<std::size_t>(ref.body);
      const bool placed = !contains(group.bodies, ref.body);
      return (placed ? state_ : posed_).bodies[body].X_WB;
    };
    posed_.contacts[index] =
        facing_motion(run_.mechanism(), contact, pose(contact.first), pose(contact.second), run_.plan().size);
  }
}

}  // namespace higherpair
