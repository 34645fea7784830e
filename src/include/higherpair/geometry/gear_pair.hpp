#pragma once

#include "higherpair/geometry/involute_span.hpp"

#include <array>

namespace higherpair {

/// The involute function inv α = tan α - α [rad]: the polar angle of an involute from its start on the base
/// circle to the point at which its pressure angle is α.
[[nodiscard]] double involute_function(double pressure_angle);

/// The inverse of the involute function in [0, π/2), by Newton's method. \pre value >= 0
[[nodiscard]] double inverse_involute(double value);

/// Number of teeth (not rounded) below which a rack with an addendum of one module undercuts the root:
/// 2/sin² α; with a profile shift of x modules 1 - x times as many (Litvin and Fuentes, Gear Geometry and
/// Applied Theory, section 10.5).
[[nodiscard]] double least_teeth(double pressure_angle);

/// Two external spur gears in mesh. Both are cut by the same rack: same module and pressure angle; their tips
/// are one module plus the profile shift outside their pitch circles.
struct GearPair {
  InvoluteTooth first;
  InvoluteTooth second;
  double distance = 0;  ///< of their centres [m]
};

/// The pair at the centre distance without backlash: α_w from inv α_w = inv α + 2 tan α (x₁ + x₂)/(z₁ + z₂),
/// and the centre distance from it; without profile shift m (z₁ + z₂)/2. \pre same module and pressure angle
[[nodiscard]] GearPair close_pair(const InvoluteTooth& first, const InvoluteTooth& second);

/// Working pressure angle, cos α_w = (r_b1 + r_b2)/distance [rad].
/// \pre the distance is larger than the sum of the base radii
[[nodiscard]] double working_pressure_angle(const GearPair& pair);

/// How teeth meet along the line of action, the common tangent of both base circles, while the first wheel
/// drives. Lengths along it are counted from the pitch point in the sense of the motion [m]: the contact goes
/// from -approach, where the tip of the second wheel comes in, to +recess, where that of the first leaves.
struct PathOfContact {
  double approach = 0;  ///< √(r_a2² - r_b2²) - r_w2 sin α_w
  double recess = 0;    ///< √(r_a1² - r_b1²) - r_w1 sin α_w
  double ratio = 0;  ///< contact ratio: (approach + recess)/(π m cos α), pairs of teeth in mesh on average
  /// How far the path extends beyond the points at which the line of action touches the base circles of the
  /// first and second wheel, beyond which there is no involute [m]: > 0: the tip of the other wheel
  /// interferes with its root.
  std::array<double, 2> past_base = {};

  [[nodiscard]] double length() const { return approach + recess; }
};

/// (ISO 21771, sections 5 and 6; Litvin and Fuentes, section 10.7.)
[[nodiscard]] PathOfContact path_of_contact(const GearPair& pair);

/// Backlash: play between the non-working flanks, along the working pitch circles [m]: the pitch less the
/// thickness of both teeth there. Divided by the working pitch radius of a wheel it is the angle through
/// which that wheel can be turned while the other is held. < 0: the teeth are too thick for the centre
/// distance.
[[nodiscard]] double backlash(const GearPair& pair);

/// Numbers of teeth of two gears that mesh at this centre distance without profile shift.
struct PairTeeth {
  double first = 0;  ///< 2 r/m, of the pitch circles
  double second = 0;
  bool are_whole = false;  ///< to within 1e-6 of a tooth
};

/// \param turning_ratio  as Joint::turning_ratio, not 1
[[nodiscard]] PairTeeth teeth_of_pair(double turning_ratio, double distance, double module);

}  // namespace higherpair
