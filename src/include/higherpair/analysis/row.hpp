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

struct RunEvent {
  EventType type = EventType::kLimitPosition;
  double driver = 0;         ///< coordinate of the first driven joint [rad or m]
  double share = 0;          ///< fraction of the drivers' path from the previous row to this one
  std::optional<int> joint;  ///< where it happens, if one can be named
  std::optional<int> contact;
  std::string cause;            ///< a sentence
  std::string effect;           ///< its consequence, "; ..."; or empty
  std::optional<double> value;  ///< for a reversal: the joint's coordinate there [rad or m]
  std::optional<std::array<double, 2>> curvature;  ///< for a jump of curvature: before and after [1/m]
};

}  // namespace higherpair
