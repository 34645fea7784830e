#include "higherpair/geometry/arc_length.hpp"

#include <cmath>

#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

namespace higherpair {
namespace {

// To the normal turned by the angle of cosine c and sine s, |angle| <= π/2.
double arc_from_vertex(const Curve& curve, double c, double s) {
  const double c2 = c * c;
  const double w2 = c2 + curve.q * s * s;
  const double rf = boost::math::ellint_rf(c2, w2, 1.0);
  const double rd = boost::math::ellint_rd(c2, 1.0, w2);
  return curve.semi_latus * s * (rf + (1 - curve.q) / 3 * s * s * rd);
}

}  // namespace

double arc_length(const Curve& curve, double psi) {
  if (!is_conic(curve)) {
    return 0;
  }
  if (curve.kind == CurveKind::kCircle) {
    return curve.semi_latus * psi;
  }
  if (curve.q <= 0) {
    return arc_from_vertex(curve, std::cos(psi), std::sin(psi));
  }
  // Half turns are left to cos and sin, which know all digits of π: at its tips a thin ellipse makes a length
  // of a rounding of the angle.
  double half_turns = std::round(psi / kPi);
  const double sign = std::fmod(half_turns, 2) == 0 ? 1 : -1;
  const double c = sign * std::cos(psi);
  double s = sign * std::sin(psi);
  if (c < 0) {
    half_turns += s > 0 ? 1 : -1;
    s = -s;
  }
  const double arc = arc_from_vertex(curve, c, s);
  return half_turns == 0 ? arc : arc + 2 * half_turns * arc_from_vertex(curve, 0, 1);
}

double vertex_normal_angle(const Curve& curve) {
  return angle_of(-curve.axis_B);
}

}  // namespace higherpair
