#pragma once

#include "higherpair/geometry/boundary.hpp"

namespace higherpair {

/// Which flank of a tooth, seen outwards from the centre: the left one has the material on its right.
enum class Hand { kLeft, kRight };

/// The involute of a circle: the path of the end of a taut string that is unwound from it. With the angle φ >
/// 0 through which the string has rolled off and e(ψ) the unit vector at ψ,
///     p = center + r (e(ψ) ∓ φ e′(ψ)),    ψ = start ± φ,    κ = 1/(r φ),
/// the upper signs for a right flank. It is the flank of a gear tooth: convex, with its material on the side
/// of the string.
struct Involute {
  Vector2d center_B = Vector2d::Zero();
  double base_radius = 1;  ///< r [m]
  double start = 0;        ///< angle at which it leaves the base circle, in a cusp [rad]
  Hand hand = Hand::kLeft;
  Bounds roll = {0.1, 1};  ///< the values of φ at its ends [rad]; both > 0
};

/// \pre base_radius > 0, 0 < roll.low < roll.high
[[nodiscard]] SpanPtr involute_span(const Involute& involute);

/// The involute that a span represents; null for other spans.
[[nodiscard]] const Involute* involute_of(const Span& span);

/// A tooth of a spur gear with involute flanks, as cut by a rack of this module.
struct InvoluteTooth {
  double module = 1;  ///< [m]
  double teeth = 20;
  double pressure_angle = 20 * kPi / 180;
  double profile_shift = 0;  ///< in modules
  double backlash = 0;  ///< reduction of its thickness along the pitch circle, half of it on each flank [m]
};

/// m z cos α / 2 [m].
[[nodiscard]] double base_radius(const InvoluteTooth& tooth);
/// Angle from the centre line of the tooth to the start of its flanks on the base circle [rad]; the thickness
/// at the pitch circle is m (π/2 + 2 x tan α) - backlash.
[[nodiscard]] double half_angle_at_base(const InvoluteTooth& tooth);
/// Roll at which the straight part of the rack's edge begins to cut; < 0: undercut.
[[nodiscard]] double roll_at_root(const InvoluteTooth& tooth);
/// Roll at the tip circle, one module plus the profile shift outside the pitch circle.
[[nodiscard]] double roll_at_tip(const InvoluteTooth& tooth);

}  // namespace higherpair
