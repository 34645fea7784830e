#pragma once

#include "higherpair/contact/rolling.hpp"
#include "higherpair/contact/standing_contact.hpp"
#include "higherpair/contact/tracker.hpp"
#include "higherpair/geometry/known_rotation.hpp"
#include "higherpair/mechanism/constraint_rows.hpp"
#include "higherpair/mechanism/plan.hpp"

#include <array>
#include <variant>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// What a group remembers between positions.
struct GroupState {
  int mode = 1;     ///< assembly mode σ, or the sign of ∂gap/∂q of a contact: the branch
  double sine = 1;  ///< goes through 0, with its sign, where branches cross; 0 to within rounding: singular
  double sine_rate = 0;  ///< per unit of the path
  double lever = 1;      ///< what `sine` is of the order of, away from there
  double noise = 0;      ///< |sine| up to which it says nothing but 0
  bool held = false;     ///< of a contact that may part (Keep::kGap): it is open, the body stays on its joint
  double held_at = 0;    ///< there, at this coordinate of its freedom [rad or m]
};

using PairTrack = std::variant<std::monostate, ContactTrack, RollingTrack, StandingContact>;

/// A position of a whole mechanism and its rates.
struct State {
  std::vector<BodyMotion> bodies;       ///< of Mechanism::bodies
  std::vector<KnownRotation> turns;     ///< of bodies: near where each was turned last
  std::vector<ContactMotion> contacts;  ///< of Mechanism::contacts
  std::vector<GroupState> groups;       ///< of Plan::groups
  std::vector<PairTrack> tracks;        ///< of Plan::groups; none where the group is no tracked pair
};

/// How coupled bodies are led from a limit to where they can be assembled again, on the way of the least
/// violation of their conditions F = 0: where that is not 0 their derivative J is singular. The sign of the
/// determinant of J, bordered by its singular vectors, changes where another part of them turns over.
struct LeastViolation {
  Eigen::VectorXd left, right;  ///< singular vectors of J, continuous on the way; empty: J is not square
  int sign = 0;                 ///< of the bordered determinant where the way began; 0: unknown
};

/// A driver's coordinate and its rates.
struct DriverMotion {
  double position = 0;  ///< [rad or m]
  double velocity = 0;
  double acceleration = 0;
};

/// The third to the sixth time derivative of a driver's coordinate [rad/s³ or m/s³, …].
using HigherRates = std::array<double, 4>;

}  // namespace higherpair
