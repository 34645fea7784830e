#include "higherpair/linkage/prp_dyad.hpp"

namespace higherpair {
namespace {

LinkageStatus status_of_lines(double sine, double apart, double extent) {
  constexpr double kNoise = kReachRoundings * std::numeric_limits<double>::epsilon();
  if (std::abs(sine) > kNoise) return LinkageStatus::kOk;
  return std::abs(apart) <= kNoise * extent ? LinkageStatus::kSingular : LinkageStatus::kNotAssemblable;
}

}  // namespace

PrpMotion prp_dyad(const GuideMotion& guide1, const GuideMotion& guide2) {
  const Vector2d u1(guide1.u.cos, guide1.u.sin);
  const Vector2d u2(guide2.u.cos, guide2.u.sin);
  const Vector2d D = guide2.P.p_W - guide1.P.p_W;

  PrpMotion motion;
  motion.sine = cross(u1, u2);
  motion.sine_rate = (guide2.omega - guide1.omega) * u1.dot(u2);
  motion.status = status_of_lines(motion.sine, cross(u1, D), extent_of(guide1.P.p_W, guide2.P.p_W));
  if (motion.status == LinkageStatus::kNotAssemblable) return motion;
  if (motion.status == LinkageStatus::kSingular) {
    motion.s1 = D.dot(u1);
    motion.p_WC = guide2.P.p_W;
    return motion;
  }

  const GuideSplit<double> s = split_along(guide1.u, guide2.u, D);
  motion.s1 = s.s1;
  motion.s2 = s.s2;

  const Vector2d v = slide_motion(guide2, s.s2, 0, 0).v_W - slide_motion(guide1, s.s1, 0, 0).v_W;
  const GuideSplit<double> rate = split_along(guide1.u, guide2.u, v);
  const Vector2d a = slide_motion(guide2, s.s2, rate.s2, 0).a_W - slide_motion(guide1, s.s1, rate.s1, 0).a_W;
  const GuideSplit<double> rate2 = split_along(guide1.u, guide2.u, a);
  const PointMotion C = slide_motion(guide1, s.s1, rate.s1, rate2.s1);
  motion.p_WC = C.p_W;
  motion.rates = {rate.s1, rate.s2, rate2.s1, rate2.s2, C.v_W, C.a_W};
  return motion;
}

}  // namespace higherpair
