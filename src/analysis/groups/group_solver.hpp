#pragma once

#include "higherpair/analysis/state.hpp"
#include "higherpair/contact/boundary_contact.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace higherpair {

/// A mechanism and its plan; both must outlive this object.
struct Planned {
  const Mechanism& mechanism;
  const Plan& plan;
};

enum class GroupStatus {
  kOk,
  kOutOfReach,    ///< the conditions have no solution at this position of the known bodies
  kNotConverged,  ///< an iteration did not find one, or a tracked contact has left its branch
};

/// Places the bodies of group `g` in `to`, whose earlier groups are placed: near where `from` and its rates
/// lead after `h` of the path, in mode to.groups[g].mode. \param drivers  of Mechanism::drivers; only their
/// positions count
[[nodiscard]] GroupStatus place_group(const Planned& model, std::size_t g, const State& from, double h,
                                      const std::vector<DriverMotion>& drivers, State& to);

/// The same however far the drivers have moved from `from`: on the branch held last.
[[nodiscard]] GroupStatus place_group_anew(const Planned& model, std::size_t g, const State& from,
                                           const std::vector<DriverMotion>& drivers, State& to);

/// Sets velocities and accelerations of the bodies of group `g`; those of earlier groups must be set. Where
/// the group is singular they are set to 0 and groups[g].sine is within its noise.
void set_group_rates(const Planned& model, std::size_t g, const std::vector<DriverMotion>& drivers,
                     State& state);

/// How far group `g`, whose earlier groups are placed, is inside its reach [m, m²]: < 0 where it cannot be
/// placed, 0 at its limit, continuous in the positions of the earlier groups; +inf where it can always be
/// placed, -inf where no such number is known, i.e. for contacts and coupled bodies.
[[nodiscard]] double reach_of(const Planned& model, std::size_t g, const State& state);

/// GroupState::sine of a group that can cross over to another branch, at the present poses of its bodies.
[[nodiscard]] double sine_of(const Planned& model, std::size_t g, const State& state);

/// The motion of a carried body for its coordinate q and the rates of q.
[[nodiscard]] BodyMotion carried_motion(const CarriedBody& carried, const BodyMotion& carrier, double q,
                                        double q_dot, double q_ddot);

/// The coordinate of a carried body at its present position; continuous.
/// \param bodies  motions of Mechanism::bodies
[[nodiscard]] double carried_coordinate(const CarriedBody& carried, const std::vector<BodyMotion>& bodies);

/// What is added to this coordinate in ground: the carrier's angle for a body that turns, 0 for one that
/// slides.
[[nodiscard]] double carrier_angle(const CarriedBody& carried, const std::vector<BodyMotion>& bodies);

/// Sliding, rolling and normal rates of a contact from the velocities of its bodies.
void set_contact_rates(const Planned& model, int contact, State& state);

/// The contact of a touching body as a pair with its known bodies frozen: body 1 at its present position
/// (coordinate u), body 2 the follower, on its carrier at the carrier's present position.
struct FrozenPair {
  ContactPair pair;
  double u = 0;
};
[[nodiscard]] FrozenPair frozen_pair(const Planned& model, const TouchingBody& touching, const State& state);

/// The same for a contact by_boundary.
[[nodiscard]] BoundaryPair frozen_boundaries(const Planned& model, const TouchingBody& touching,
                                             const FrozenPair& frozen);

}  // namespace higherpair
