#pragma once

#include "higherpair/contact/contact_pair.hpp"

namespace higherpair {

/// First and second derivatives of the gap g(φ, q) at a contact; φ drops out where a body is a line.
struct GapDerivatives {
  double g_q = 0;
  double g_phiphi = 0, g_phiq = 0, g_qq = 0;
};

[[nodiscard]] inline GapDerivatives gap_derivatives(const ContactPair& pair, const ContactPosition& at) {
  const Vector2d n = at.n_W;
  const Vector2d t = perp(n);
  const Vector2d v2 = velocity_per_q(pair.motion2, at.p2_W);
  const double turns2 = pair.motion2.turns ? 1 : 0;
  const double g = (at.p2_W - at.p1_W).dot(n);
  GapDerivatives d;
  d.g_q = n.dot(v2);
  if (is_line(pair.curve2)) {
    // n turns with q; p2 is the foot of p1.
    d.g_qq = turns2 * (t.dot(v2) + g - at.rho1);
    return d;
  }
  d.g_phiq = t.dot(v2) + turns2 * at.rho2;
  d.g_qq = -turns2 * d.g_phiq;
  if (is_line(pair.curve1)) {
    // n turns with u; p1 is the foot of p2.
    d.g_phiq = 0;
    return d;
  }
  d.g_phiphi = -(at.rho1 + at.rho2) - g;
  return d;
}

}  // namespace higherpair
