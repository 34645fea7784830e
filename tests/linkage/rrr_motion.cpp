#include "linkage/rrr_motion.hpp"

#include "higherpair/linkage/moving_guide.hpp"

#include <cassert>

namespace higherpair {

RrrMotion rrr_dyad(const PointMotion& A, const PointMotion& B, double a, double b, AssemblyMode mode) {
  assert(a > 0 && b > 0);
  const Vector2d D = B.p_W - A.p_W;
  const Vector2d D_dot = B.v_W - A.v_W;

  RrrMotion motion;
  motion.reach = rrr_reach(D, a, b, extent_of(A.p_W, B.p_W));
  motion.status = status_of(motion.reach);
  if (motion.status == LinkageStatus::kNotAssemblable) return motion;

  const RrrPosition<double> position = rrr_position(D, a, b, motion.reach, sign(mode));
  const Vector2d u_a(position.u_a.cos, position.u_a.sin);
  motion.u_a = position.u_a;
  motion.u_b = position.u_b;
  motion.p_WC = A.p_W + a * u_a;
  if (motion.status == LinkageStatus::kSingular) return motion;

  const RrrRates<double> rates = rrr_rates<double>(position, a, b, D_dot, B.a_W - A.a_W);
  motion.rates = {rates.omega_a,
                  rates.omega_b,
                  rates.alpha_a,
                  rates.alpha_b,
                  A.v_W + a * rates.omega_a * perp(u_a),
                  A.a_W + a * rates.alpha_a * perp(u_a) - a * rates.omega_a * rates.omega_a * u_a};
  return motion;
}

}  // namespace higherpair
