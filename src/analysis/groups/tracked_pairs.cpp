#include "contact_states.hpp"
#include "higherpair/contact/finder.hpp"

namespace higherpair {
namespace {

const ContactPosition& position_of(const PairTrack& track) {
  if (const auto* rolling = std::get_if<RollingTrack>(&track)) {
    return rolling->at;
  }
  if (const auto* dwell = std::get_if<DwellContact>(&track)) {
    return dwell->at;
  }
  return std::get<ContactTrack>(track).at;
}

// Sets the follower and the contact to the present position of the group's track.
void place_follower(const TrackedPair& tracked, const ContactPosition& at, double phi, const State& from,
                    State& to) {
  place_at(tracked.follower.freedom, at.q, tracked.follower.body, from, to);
  to.contacts[tracked.contact] = contact_motion(at, phi, tracked.driver_is_first);
}

double coordinate_of(const TrackedPair& tracked, const std::vector<DriverMotion>& drivers) {
  return tracked.driver_sign * drivers[tracked.driver].position;
}

}  // namespace

GroupStatus place_tracked(const TrackedPair& tracked, std::size_t g, const State& from,
                          const std::vector<DriverMotion>& drivers, State& to) {
  const double u = coordinate_of(tracked, drivers);
  to.tracks[g] = from.tracks[g];
  GroupState& group = to.groups[g];
  if (auto* rolling = std::get_if<RollingTrack>(&to.tracks[g])) {
    if (!roll_to(*rolling, u).converged) {
      return GroupStatus::kNotConverged;
    }
    group.sine = 1;
    place_follower(tracked, rolling->at, rolling->phi, from, to);
    return GroupStatus::kOk;
  }
  if (const auto* dwell = std::get_if<DwellContact>(&to.tracks[g])) {
    set_sine(tracked.pair, dwell->at, group);
    place_follower(tracked, dwell->at, angle_of(dwell->at.n_W), from, to);
    return GroupStatus::kOk;
  }
  auto& track = std::get<ContactTrack>(to.tracks[g]);
  if (u != track.at.u || group.mode != track.branch) {
    const ContactStatus status = step_to(track, u, group.mode);
    if (status != ContactStatus::kOk) {
      return status_of(status);
    }
  }
  set_sine(tracked.pair, track.at, group);
  place_follower(tracked, track.at, track.phi, from, to);
  return GroupStatus::kOk;
}

GroupStatus place_tracked_anew(const TrackedPair& tracked, std::size_t g, const State& from,
                               const std::vector<DriverMotion>& drivers, State& to) {
  const auto* lost = std::get_if<ContactTrack>(&from.tracks[g]);
  if (lost == nullptr) {
    return place_tracked(tracked, g, from, drivers, to);
  }
  const FindResult found =
      find_nearest_contact(tracked.pair, coordinate_of(tracked, drivers), lost->at.q, to.groups[g].mode);
  if (found.status != FindStatus::kFound) {
    return GroupStatus::kOutOfReach;
  }
  ContactTrack track = start_track(tracked.pair, found.at, to.groups[g].mode);
  track.phi = nearest_turn(track.phi, lost->phi);
  set_sine(tracked.pair, track.at, to.groups[g]);
  place_follower(tracked, track.at, track.phi, from, to);
  to.tracks[g] = track;
  return GroupStatus::kOk;
}

void move_tracked(const Planned& model, const TrackedPair& tracked, std::size_t g,
                  const std::vector<DriverMotion>& drivers, State& state) {
  const ContactPosition& at = position_of(state.tracks[g]);
  const DriverMotion& driver = drivers[tracked.driver];
  const double u_dot = tracked.driver_sign * driver.velocity;
  const double u_ddot = tracked.driver_sign * driver.acceleration;
  const double q_ddot = at.d2q * u_dot * u_dot + at.dq * u_ddot;
  state.groups[g].sine_rate = at.dgap_q * u_dot;
  set_rates_at(tracked.follower.freedom, at.dq * u_dot, q_ddot, state.bodies[tracked.follower.body]);
  set_contact_rates(model, tracked.contact, state);
}

double tracked_sine(const TrackedPair& tracked, const State& state) {
  const CommonNormal& at = state.contacts[tracked.contact].at;
  const Vector2d n = (tracked.driver_is_first ? 1 : -1) * at.n_W;
  return n.dot(velocity_per_q(tracked.pair.motion2, at.p_W()));
}

}  // namespace higherpair
