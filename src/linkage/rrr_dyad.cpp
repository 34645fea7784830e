#include "higherpair/linkage/rrr_dyad.hpp"

#include <cassert>

namespace higherpair {

RrrMotion rrr_dyad(const PointMotion& A, const PointMotion& B, double a, double b, AssemblyMode mode) {
  assert(a > 0 && b > 0);
  const Vector2d D = B.p_W - A.p_W;
  const double extent = std::max(A.p_W.cwiseAbs().maxCoeff(), B.p_W.cwiseAbs().maxCoeff());
  const Reach<double> reach = rrr_reach(D, a, b, extent);

  RrrMotion motion;
  motion.status = status_of(reach);
  if (motion.status == LinkageStatus::kNotAssemblable) return motion;

  const RrrPosition<double> position = rrr_position(D, a, b, reach, sign(mode));
  const Vector2d u_a(position.u_a.cos, position.u_a.sin);
  motion.theta_a = absolute_angle(position.u_a, 0);
  motion.theta_b = absolute_angle(position.u_b, 0);
  motion.p_WC = A.p_W + a * u_a;
  if (motion.status == LinkageStatus::kSingular) return motion;

  const RrrRates<double> rates = rrr_rates<double>(position, a, b, B.v_W - A.v_W, B.a_W - A.a_W);
  motion.rates = {rates.omega_a,
                  rates.omega_b,
                  rates.alpha_a,
                  rates.alpha_b,
                  A.v_W + a * rates.omega_a * perp(u_a),
                  A.a_W + a * rates.alpha_a * perp(u_a) - a * rates.omega_a * rates.omega_a * u_a};
  return motion;
}

}  // namespace higherpair
