#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <vector>

namespace higherpair {

/// A tangency of two curves at which the contact cannot be written as a smooth function of the driver.
enum class CriticalType {
  kFold,        ///< ∂gap/∂q = 0: two contacts merge, the driver cannot go on on either
  kCrossing,    ///< ∂gap/∂q = ∂gap/∂u = 0 to within rounding: branches cross, or an isolated point
  kConforming,  ///< κ1 + κ2 = 0 for opposed normals, κ1 = κ2 for equal ones: two contacts merge in a cusp
};

/// Its coordinates are angles in (-π, π], or displacements [m].
struct CriticalPosition : TangentPosition {
  CriticalType type = CriticalType::kFold;
  bool opposed = true;
};

struct CriticalPositions {
  std::vector<CriticalPosition> found;
  bool everywhere = false;  ///< the contact is at a limit at every driver position
};

/// All folds of a pair over all driver positions.
///
/// A fold is a contact whose common normal passes through the follower's pivot O2 (for a sliding follower: is
/// perpendicular to its direction d). The points of curve 2 with such a normal, at most four on a conic, do
/// not depend on u and q (roots of a quartic; the foot of O2 on a line). Curve 2 may therefore be replaced by
/// the circle about O2 through such a point (or the line along d through it), which is at rest: the folds are
/// the contacts of curve 1, moved by u, with it, which find_curve_contacts lists completely. Two lines, two
/// points and a sliding face have no folds.
[[nodiscard]] CriticalPositions find_folds(const ContactPair& pair);

/// All conforming contacts of two conics.
///
/// Points of equal radius ℓ/w³ on both curves satisfy, with S = sin² of the angle between normal and axis,
///     1 - (1-q2) S2 = c² (1 - (1-q1) S1),   c³ = ℓ2/ℓ1:
/// a segment in the unit square, on which one condition remains: that the joints permit the pose. Its roots
/// are bracketed by 256 samples of each of the 16 mirror images, and between samples by the extremes of its
/// absolute value. Two circles have none, or coincide.
[[nodiscard]] std::vector<CriticalPosition> find_conforming(const ContactPair& pair);

/// Driver coordinates at which a contact can run off to infinity along open curves: where an asymptotic
/// direction of curve 1 is parallel to the direction of a sliding follower or to an asymptotic direction of
/// its curve, and where asymptotes (or faces) of both curves coincide.
[[nodiscard]] std::vector<double> runaway_positions(const ContactPair& pair);

/// A direction in which a curve goes to infinity, in the body's frame, with its asymptote if it has one. A
/// line is its own asymptote.
struct Opening {
  Vector2d direction_B = Vector2d::UnitX();
  bool has_asymptote = false;
  Vector2d point_B = Vector2d::Zero();  ///< of the asymptote
};

/// Empty for a closed curve; for a line one direction represents both.
[[nodiscard]] std::vector<Opening> openings_of(const Curve& curve);

/// The pair with curve 2 replaced by its other side: its contacts are opposed where those of `pair` are not.
[[nodiscard]] ContactPair with_other_side(ContactPair pair);

}  // namespace higherpair
