#pragma once

#include "higherpair/analysis/status.hpp"
#include "higherpair/contact/common_normal.hpp"
#include "higherpair/geometry/pose.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// The contents of one row of a motion table; SI units, ground frame.
struct MotionRow {
  RowStatus status = RowStatus::kNotConverged;
  double residual = 0;             ///< largest closure error, and mismatch of velocities times size/speed [m]
  std::vector<BodyMotion> bodies;  ///< of Mechanism::bodies; meaningless where not assemblable
  std::vector<bool> has_rates;     ///< whether the body's rates are defined
  bool all_rates = true;           ///< whether those of all bodies are
  std::vector<ContactMotion> contacts;  ///< of Mechanism::contacts
  std::vector<bool> arcs_hold;  ///< whether it has been the same contact without a jump since the first row
};

/// A rate that jumps at an event, for a unit rate of a driver with which the others keep pace.
struct EventJump {
  std::string of;     ///< "the acceleration of joint slide"
  bool turns = true;  ///< whether it is that of an angle or of a length
  int order = 1;      ///< 1: a velocity, 2: an acceleration
  int driver = 0;     ///< index of Mechanism::drivers
  double before = 0;  ///< [rad or m per rad or m^order of the driver]
  double after = 0;
};

struct RunEvent {
  EventType type = EventType::kLimitPosition;
  double driver = 0;  ///< coordinate of the first driven joint [rad or m]
  /// Fraction of the drivers' path from the previous row to this one; above 1 at a limit at infinity so near
  /// behind the row that the row cannot be computed.
  double share = 0;
  std::optional<int> joint;  ///< where it happens, if one can be named
  std::optional<int> contact;
  std::string cause;  ///< a sentence
  std::optional<EventJump> jump;
  std::optional<double> value;  ///< for a reversal: the joint's coordinate there [rad or m]
  std::optional<std::array<double, 2>> curvature;  ///< for a jump of curvature: before and after [1/m]
  std::vector<double> further_drivers;  ///< coordinates of the other ones, in their order [rad or m]
};

}  // namespace higherpair
