#pragma once

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

}  // namespace higherpair
