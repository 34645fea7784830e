#include "higherpair/linkage/rrp_dyad.hpp"

#include <cassert>

namespace higherpair {

RrpMotion rrp_dyad(const PointMotion& A, const GuideMotion& guide, double r, AssemblyMode mode) {
  assert(r > 0);
  const SeenMotion seen = seen_from(guide, A);
  const double noise =
      kReachRoundings * std::numeric_limits<double>::epsilon() * (r + extent_of(A.p_W, guide.P.p_W));

  RrpMotion motion;
  motion.reach = {r + seen.p.y(), r - seen.p.y(), noise};
  motion.status = status_of(motion.reach);
  if (motion.status == LinkageStatus::kNotAssemblable) return motion;

  const RrpPosition<double> position = rrp_position(seen.p.x(), r, motion.reach, sign(mode));
  motion.u_link = guide.u * position.u_leg;
  const Vector2d u(motion.u_link.cos, motion.u_link.sin);
  motion.s = position.along;
  motion.p_WC = A.p_W + r * u;
  if (motion.status == LinkageStatus::kSingular) return motion;

  const RrpRates<double> rates = rrp_rates(position, r, seen.v, seen.a);
  const double omega = guide.omega + rates.omega_leg;
  const double alpha = guide.alpha + rates.alpha_leg;
  motion.rates = {omega,
                  alpha,
                  rates.along_dot,
                  rates.along_ddot,
                  A.v_W + r * omega * perp(u),
                  A.a_W + r * alpha * perp(u) - r * omega * omega * u};
  return motion;
}

}  // namespace higherpair
