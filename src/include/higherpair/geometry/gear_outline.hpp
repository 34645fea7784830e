#pragma once

#include "higherpair/geometry/involute_span.hpp"

#include <vector>

namespace higherpair {

/// An external spur gear.
struct GearShape {
  InvoluteTooth tooth;
  Vector2d center_B = Vector2d::Zero();
  double angle = 0;  ///< of the centre line of its first tooth [rad]
  /// Depth of the tooth spaces below the pitch circle, in modules, before the profile shift is subtracted.
  double dedendum = 1.25;
};

/// Half the angle subtended by a tooth at the roll φ of its flanks, half_angle_at_base - (φ - atan φ) [rad];
/// < 0 at the tip where the flanks meet inside the tip circle.
[[nodiscard]] double half_angle_at_roll(const InvoluteTooth& tooth, double roll);

/// The outline, counter-clockwise, tooth after tooth: radial from the root circle to where the straight part
/// of the rack begins to cut, involute, tip circle, involute, radial, root circle. The fillets that the tip
/// of a rack leaves are omitted; the room gained is out of reach of any meshing tooth. \pre 0 < roll_at_root
/// < roll_at_tip; half_angle_at_roll > 0 at both, < π/z at the root; the root circle has a radius > 0
[[nodiscard]] std::vector<SpanPtr> gear_outline(const GearShape& gear);

}  // namespace higherpair
