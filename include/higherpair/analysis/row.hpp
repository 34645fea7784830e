#pragma once

#include "higherpair/contact/common_normal.hpp"
#include "higherpair/geometry/pose.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// Time derivatives are worked out up to this one.
inline constexpr int kHighestDerivative = 6;

enum class RowStatus {
  kOk,
  kNotAssemblable,  ///< the mechanism cannot be put together at this driver position on its branch
  kSingular,  ///< the closure has lost rank to within rounding: positions hold, some rates are not defined
  kOverlap,   ///< touching bodies overlap elsewhere
  kNotConverged,  ///< the closure residual exceeds the tolerance
  kContactOpen,   ///< a contact would have to pull; of rows with forces only
};

/// Everything that one row of a motion table shows; SI units, ground frame.
struct MotionRow {
  RowStatus status = RowStatus::kNotConverged;
  double residual = 0;  ///< largest closure error, and disagreement of velocities times size/speed [m]
  std::vector<BodyMotion> bodies;       ///< of Mechanism::bodies; meaningless where not assemblable
  std::vector<bool> has_rates;          ///< whether the body's rates are defined
  bool all_rates = true;                ///< whether those of all bodies are
  std::vector<ContactMotion> contacts;  ///< of Mechanism::contacts
  std::vector<bool> arcs_hold;          ///< whether the contact has been one and the same since the first row
};

enum class EventType {
  kLimitPosition,  ///< the drivers cannot go further on this branch
  kDeadPoint,      ///< passed through: a change point, where branches cross, or the output loses the input
  kStrokeEnd,      ///< the output reverses
  kConforming,     ///< κ1 + κ2 = 0: beyond, the bodies cut into each other at the contact
  kSecondContact,  ///< of the same two bodies, with which the motion goes on
  kOverlap,        ///< touching bodies begin to overlap elsewhere
  kContactOpen,    ///< a contact begins to pull; of runs with forces only
  kCurvatureJump,  ///< the contact goes over a joint of two spans with different curvatures: accelerations
                   ///< jump
  kCorner,         ///< the contact goes onto a corner, or leaves it
  kEnd,            ///< of a curve that a contact comes to: it is lost, or on the edge there
  kEngage,         ///< a contact that may part begins to touch
  kRelease,        ///< a contact that may part ends: its body is held from there on
  kLawJump,        ///< velocity or acceleration of a driver's law jumps
};

struct RunEvent {
  EventType type = EventType::kLimitPosition;
  double driver = 0;         ///< coordinate of the first driven joint [rad or m]
  double share = 0;          ///< of the drivers' path from the row before to this one
  std::optional<int> joint;  ///< what it happens at, if one can be named
  std::optional<int> contact;
  std::string cause;            ///< a sentence
  std::string effect;           ///< what follows on it, "; ..."; or empty
  std::optional<double> value;  ///< of what reverses: the joint's coordinate there [rad or m]
  std::optional<std::array<double, 2>> curvature;  ///< where it jumps: before and after [1/m]
};

}  // namespace higherpair
