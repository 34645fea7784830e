#include "higherpair/geometry/arc_length.hpp"

#include <cmath>

#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

namespace higherpair {
namespace {

// |ψ| <= π/2.
double arc_from_vertex(const Curve& curve, double psi) {
  const double c = std::cos(psi);
  const double s = std::sin(psi);
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
    return arc_from_vertex(curve, psi);
  }
  const double half_turns = std::round(psi / kPi);
  const double rest = arc_from_vertex(curve, psi - half_turns * kPi);
  return half_turns == 0 ? rest : rest + 2 * half_turns * arc_from_vertex(curve, kPi / 2);
}

double vertex_normal_angle(const Curve& curve) {
  return angle_of(-curve.axis_B);
}

}  // namespace higherpair
