#pragma once

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

/// What a contact says beyond its position: the equivalent linkage and the angles that judge it.
struct ContactDetails {
  ContactSide side1;
  ContactSide side2;
  std::string_view linkage;                      ///< four-bar, slider-crank, …
  std::array<std::optional<double>, 4> lengths;  ///< r1 … r4 [m]; none where a link has an infinite end
  double pressure1 = 0;  ///< angle between n and the direction body 1's joint lets p move in [rad], 0 … π/2
  double pressure2 = 0;  ///< the same for body 2
  std::optional<double>
      transmission1;  ///< angle between n and O1C1 [rad], 0 … π/2; none where body 1 slides or is flat
  std::optional<double> transmission2;  ///< the same for body 2
};

/// \param phi  angle of at.n_W, continuous over the run [rad]: the arc coordinates follow it over whole turns
/// Lengths: r1 = O1O2, or the offset of the pivot from the path of the sliding body's centre (positive on the
/// side of the slide's direction turned +90°); r2, r4 the arms O1C1, O2C2 (of a slider-crank r2 is the
/// crank); r3 = |ρ1 + ρ2|.
[[nodiscard]] ContactDetails details_of(const ContactPair& pair, const ContactPosition& at, double phi);

}  // namespace higherpair
