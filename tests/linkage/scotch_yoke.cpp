#include "linkage/scotch_yoke.hpp"

#include <cassert>

namespace higherpair {

ScotchYokeMotion scotch_yoke_by_crank(const ScotchYoke& linkage, const AngleMotion& link2) {
  assert(linkage.r2 >= 0 && linkage.slot.sin != 0);
  const double angle = link2.theta - linkage.theta1;
  if (!std::isfinite(angle)) return {};

  const Rotation<double> u2 = Rotation<double>::from_angle(angle);
  const Vector2d p = linkage.r2 * Vector2d(u2.cos, u2.sin);
  const Vector2d v = link2.omega * perp(p);
  const Vector2d a = link2.alpha * perp(p) - link2.omega * link2.omega * p;
  const YokePosition<double> position = yoke_components(linkage.slot, p);
  const YokePosition<double> velocity = yoke_components(linkage.slot, v);
  const YokePosition<double> acceleration = yoke_components(linkage.slot, a);
  return {
      LinkageStatus::kOk, link2.theta, position.r1, position.r3,
      ScotchYokeRates{link2.omega, velocity.r1, velocity.r3, link2.alpha, acceleration.r1, acceleration.r3}};
}

ScotchYokeMotion scotch_yoke_by_yoke(const ScotchYoke& linkage, const SlideMotion& yoke, AssemblyMode mode) {
  assert(linkage.r2 > 0 && linkage.slot.sin != 0);
  const YokeDrivenPosition<double> position =
      yoke_driven_position(linkage.r2, linkage.slot, yoke.r, sign(mode));

  ScotchYokeMotion motion;
  motion.status = status_of(position.reach);
  motion.r1 = yoke.r;
  if (motion.status == LinkageStatus::kNotAssemblable) return motion;
  motion.theta2 = absolute_angle(linkage.slot * position.u2_slot, linkage.theta1);
  motion.r3 = position.r3;
  if (motion.status == LinkageStatus::kOk) {
    const YokeDrivenRates<double> rates =
        yoke_driven_rates(linkage.r2, linkage.slot, position, yoke.r_dot, yoke.r_ddot);
    motion.rates = {rates.omega2, yoke.r_dot, rates.r3_dot, rates.alpha2, yoke.r_ddot, rates.r3_ddot};
  }
  return motion;
}

DriverRange scotch_yoke_crank_range(const ScotchYoke&) {
  return {DriverReach::kFullTurn, 0, {}};
}

DriverRange scotch_yoke_yoke_range(const ScotchYoke& linkage) {
  assert(linkage.r2 >= 0 && linkage.slot.sin != 0);
  const double end = linkage.r2 / std::abs(linkage.slot.sin);
  return {DriverReach::kRanges, 1, {DriverInterval{-end, end}}};
}

}  // namespace higherpair
