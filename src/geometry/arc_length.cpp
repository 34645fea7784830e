#include "higherpair/geometry/arc_length.hpp"

namespace higherpair {

double arc_length(const Curve& curve, double psi) {
  return is_conic(curve) ? conic_arc_length(curve.semi_latus, curve.q, psi) : 0;
}

double vertex_normal_angle(const Curve& curve) {
  return angle_of(-curve.axis_B);
}

}  // namespace higherpair
