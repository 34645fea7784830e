#pragma once

#include <string_view>

namespace higherpair {

/// Highest order of time derivative that is computed.
inline constexpr int kHighestDerivative = 6;

enum class RowStatus {
  kOk,
  kNotAssemblable,  ///< the mechanism cannot be put together at this driver position on its branch
  kSingular,  ///< the closure conditions have lost rank to within rounding: positions are valid, some rates
              ///< are undefined
  kOverlap,   ///< two bodies in contact overlap elsewhere
  kNotConverged,  ///< the closure residual exceeds the tolerance by more than the rounding of distant bodies
  kContactOpen,   ///< a contact would have to pull; only in rows with forces
};

enum class EventType {
  kLimitPosition,  ///< the drivers cannot go further on this branch
  kDeadPoint,      ///< a change point, where branches cross; the motion passes straight through it
  kStrokeEnd,      ///< an output (a joint to ground that is not driven) reverses
  kConforming,     ///< κ1 + κ2 = 0: beyond it the bodies penetrate each other at the contact
  kSecondContact,  ///< the motion continues with a second contact of the same two bodies
  kOverlap,        ///< two bodies in contact begin to overlap elsewhere
  kContactOpen,    ///< a contact would have to pull from here on; only in runs with forces
  kCurvatureJump,  ///< the contact crosses a joint of two spans with different curvatures: accelerations jump
  kCorner,         ///< the contact moves onto a corner or off it
  kEnd,     ///< a contact reaches the end of its curve, where it is lost or continues on the edge; or a joint
            ///< reaches the end of its line
  kEngage,  ///< a contact that may part closes; or two bodies in contact begin to touch at a further place
  kRelease,  ///< a contact that may part opens, and its body then stays where it is; or one of several places
             ///< of contact parts
  kLawJump,  ///< velocity or acceleration of a driver's law jumps
};

/// Whether the motion cannot go on beyond such an event, or only in another way.
[[nodiscard]] constexpr bool loses_motion(EventType type) {
  return type == EventType::kLimitPosition || type == EventType::kEnd;
}

/// Whether motion or forces may be less smooth at such an event of a run: rates may jump, or grow without
/// bounds towards it.
[[nodiscard]] constexpr bool breaks_motion(EventType type) {
  return type != EventType::kStrokeEnd && type != EventType::kOverlap;
}

/// Whether the mechanism as described ends its path with such an event: the motion is lost, bodies overlap,
/// or a contact would have to pull.
[[nodiscard]] constexpr bool ends_path(EventType type) {
  return loses_motion(type) || type == EventType::kOverlap || type == EventType::kContactOpen;
}

/// The name as results print it: "not_assemblable", "limit_position".
[[nodiscard]] std::string_view name_of(RowStatus status);
[[nodiscard]] std::string_view name_of(EventType type);

}  // namespace higherpair
