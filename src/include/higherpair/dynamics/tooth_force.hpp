#pragma once

#include "higherpair/mechanism/constraint_rows.hpp"

#include <vector>

namespace higherpair {

/// Where the pitch circles of two gears touch, in ground. With c₁, c₂ the centres of the wheels, a their
/// distance, u from c₁ to c₂ and k the turning ratio, the pitch point
///     c₁ + k a/(k - 1) u
/// has the same velocity in both wheels: it lies between the centres of external gears, beyond that of the
/// smaller one of internal gears.
struct PitchPoint {
  Vector2d p_W = Vector2d::Zero();
  Vector2d u_W = Vector2d::UnitX();  ///< from the centre of the first wheel to that of the second
  double distance = 1;               ///< a [m]
};

/// \pre joint.type == kGears, its wheels have two centres, and k != 1
[[nodiscard]] PitchPoint pitch_point(const Mechanism& mechanism, const Joint& joint,
                                     const std::vector<BodyMotion>& bodies);

/// The condition of gears with teeth, as the teeth impose it: the wheels' points at the pitch point have the
/// same velocity along the line of action. Together with the pins it is equivalent to the condition of the
/// angles, with the same multiplier, so that the torque on the second wheel is M = λ size; but it loads both
/// wheels with a single force through the pitch point,
///     F = M (k - 1)/a t ± |M (k - 1)/a| tan α u,    t = u turned +90°,
/// with + for external and - for internal gears: flanks only press, so the radial part of the force pushes
/// the second wheel away from the teeth whichever flank carries (Norton, Design of Machinery, section 11.9;
/// any textbook of machine elements). The carrier has its share through the pins.
/// \param flank  +1 or -1, the sign of M: which flank carries
/// \pre as pitch_point, and joint.teeth
[[nodiscard]] ConstraintRow tooth_row(const Mechanism& mechanism, const Joint& joint, int flank,
                                      const std::vector<BodyMotion>& bodies, double size);

}  // namespace higherpair
