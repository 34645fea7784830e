#include "higherpair/linkage/rpr_dyad.hpp"

#include "higherpair/linkage/moving_guide.hpp"

namespace higherpair {

RprMotion rpr_dyad(const PointMotion& A, const PointMotion& B, double e, AssemblyMode mode) {
  const Vector2d D = B.p_W - A.p_W;
  const Vector2d D_dot = B.v_W - A.v_W;

  RprMotion motion;
  motion.reach = rpr_reach(D, e, extent_of(A.p_W, B.p_W));
  motion.status = status_of(motion.reach);
  if (motion.status == LinkageStatus::kNotAssemblable) return motion;

  const RprPosition<double> position = rpr_position(D, e, motion.reach, sign(mode));
  motion.u = position.u;
  motion.s = position.s;
  if (motion.status == LinkageStatus::kSingular) return motion;

  const RprRates<double> rates = rpr_rates<double>(position, e, D_dot, B.a_W - A.a_W);
  motion.rates = {rates.omega, rates.alpha, rates.s_dot, rates.s_ddot};
  return motion;
}

}  // namespace higherpair
