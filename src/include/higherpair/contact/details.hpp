#pragma once

#include "higherpair/contact/common_normal.hpp"
#include "higherpair/contact/contact_pair.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace higherpair {

/// One side of a contact, in ground W.
struct ContactSide {
  std::optional<double> rho;         ///< radius of curvature [m]; none for a line
  std::optional<Vector2d> center_W;  ///< centre of curvature [m]; none for a line
  double arc = 0;  ///< arc coordinate of the contact point on the curve, growing along t of body 1 [m]
};

/// The equivalent linkage at a contact, and the angles by which its force transmission is judged.
struct ContactDetails {
  ContactSide side1;
  ContactSide side2;
  std::string_view linkage;  ///< four-bar, slider-crank, …; "link" where a body has no joint to ground
  std::array<std::optional<double>, 4> lengths;  ///< r1 … r4 [m]; none for a link with an end at infinity
  /// Angle between n and the direction in which body 2's joint lets p move [rad], 0 … π/2; none for a body at
  /// rest without such a joint.
  std::optional<double> pressure;
  /// Angle between n and O2C2 [rad], 0 … π/2; none where body 2 is flat or has no pivot on ground.
  std::optional<double> transmission;
};

/// One body of a contact, at its present position.
struct ContactBody {
  const Curve& curve;
  const BodyMotion& motion;
  const OneFreedom* grounded = nullptr;  ///< its joint to ground, if it has one
};

/// Angle between n_W and the direction in which the joint of a body to ground lets a point p_W of it move; of
/// its velocity where `grounded` is null [rad], 0 … π/2. None for a body at rest without such a joint, and
/// for a point at the pivot.
[[nodiscard]] std::optional<double> pressure_angle(const BodyMotion& body, const OneFreedom* grounded,
                                                   const Vector2d& p_W, const Vector2d& n_W);

/// \param phi  angle of at.n_W, continuous over the run [rad]: the arc coordinates follow it over whole turns
/// Lengths: r1 = O1O2, or the offset of the pivot from the path of the sliding body's centre (positive on the
/// side of the slide's direction turned +90°); r2, r4 the arms O1C1, O2C2 (of a slider-crank r2 is the
/// crank); r3 = |ρ1 + ρ2|.
[[nodiscard]] ContactDetails details_of(const ContactBody& body1, const ContactBody& body2,
                                        const CommonNormal& at, double phi);

/// The same for a driver and a follower on ground.
[[nodiscard]] ContactDetails details_of(const ContactPair& pair, const ContactPosition& at, double phi);

/// Arc of the contact point on the first curve less that on the second, both along t of body 1; constant
/// where the bodies roll [m].
/// \param phi  as for details_of
[[nodiscard]] double arc_difference(const Curve& curve1, const BodyMotion& body1, const Curve& curve2,
                                    const BodyMotion& body2, const CommonNormal& at, double phi);

}  // namespace higherpair
