#pragma once

#include "higherpair/geometry/involute_span.hpp"

#include <vector>

namespace higherpair {

/// An outer spur gear.
struct GearShape {
  InvoluteTooth tooth;
  Vector2d center_B = Vector2d::Zero();
  double angle = 0;        ///< of the centre line of its first tooth [rad]
  double dedendum = 1.25;  ///< depth of the spaces below the pitch circle, in modules less the profile shift
};

/// Half the angle that a tooth takes up at the roll φ of its flanks, half_angle_at_base - (φ - atan φ) [rad];
/// at the tip < 0 where the flanks meet inside the tip circle.
[[nodiscard]] double half_angle_at_roll(const InvoluteTooth& tooth, double roll);

/// Its outline, run through counter-clockwise, tooth after tooth: radial from the root circle to where the
/// rack's straight part begins to cut, involute, tip circle, involute, radial, root circle. In place of the
/// fillets that the tip of a rack leaves there is more room, which nothing that meshes reaches. \pre 0 <
/// roll_at_root < roll_at_tip; half_angle_at_roll > 0 at both, < π/z at the root; the root circle has a
/// radius > 0
[[nodiscard]] std::vector<SpanPtr> gear_outline(const GearShape& gear);

}  // namespace higherpair
