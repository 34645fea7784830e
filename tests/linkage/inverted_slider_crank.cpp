#include "linkage/inverted_slider_crank.hpp"

#include <cassert>

namespace higherpair {
namespace {

SlotLoop<double> crank_loop(const InvertedSliderCrank& linkage) {
  assert(linkage.r1 >= 0 && linkage.r2 >= 0);
  return make_slot_loop(linkage.r1, linkage.r2, linkage.r4);
}

RrpLoop<double> slot_loop(const InvertedSliderCrank& linkage) {
  assert(linkage.r1 >= 0 && linkage.r2 > 0);
  return make_rrp_loop(linkage.r1, linkage.r2, linkage.r4);
}

}  // namespace

InvertedSliderCrankMotion inverted_slider_crank_by_crank(const InvertedSliderCrank& linkage,
                                                         const AngleMotion& link2, AssemblyMode mode) {
  const SlotLoop<double> loop = crank_loop(linkage);
  const Rotation<double> u2 = Rotation<double>::from_angle(link2.theta - linkage.theta1);
  const RprPosition<double> position = slot_position(loop, u2, sign(mode));

  InvertedSliderCrankMotion motion;
  motion.status = status_at_angle(position.reach, link2.theta, linkage.theta1);
  motion.theta2 = link2.theta;
  if (motion.status == LinkageStatus::kNotAssemblable) return motion;
  motion.theta3 = absolute_angle(position.u, linkage.theta1);
  motion.r3 = position.s;
  if (motion.status == LinkageStatus::kOk) {
    const RprRates<double> rates = slot_rates(loop, position, u2, link2.omega, link2.alpha);
    motion.rates = {link2.omega, rates.omega, rates.s_dot, link2.alpha, rates.alpha, rates.s_ddot};
  }
  return motion;
}

InvertedSliderCrankMotion inverted_slider_crank_by_slot(const InvertedSliderCrank& linkage,
                                                        const AngleMotion& link3, AssemblyMode mode) {
  // Relative to the slot, ground turns backwards: the arm leads from O2 to O1, and the crank is the leg.
  const RrpLoop<double> loop = slot_loop(linkage);
  const Rotation<double> u3 = Rotation<double>::from_angle(link3.theta - linkage.theta1);
  const Rotation<double> u_arm{-u3.cos, u3.sin};
  const RrpPosition<double> position = rrp_position(loop, u_arm, sign(mode));

  InvertedSliderCrankMotion motion;
  motion.status = status_at_angle(position.reach, link3.theta, linkage.theta1);
  motion.theta3 = link3.theta;
  if (motion.status == LinkageStatus::kNotAssemblable) return motion;
  motion.theta2 = absolute_angle(u3 * position.u_leg, linkage.theta1);
  motion.r3 = position.along;
  if (motion.status == LinkageStatus::kOk) {
    const RrpRates<double> rates = rrp_rates(loop, position, u_arm, -link3.omega, -link3.alpha);
    motion.rates = {link3.omega + rates.omega_leg, link3.omega, rates.along_dot,
                    link3.alpha + rates.alpha_leg, link3.alpha, rates.along_ddot};
  }
  return motion;
}

DriverRange inverted_slider_crank_crank_range(const InvertedSliderCrank& linkage) {
  const CosineLine<double> always{1, 1, 1, 0};
  return angle_range(always, crank_loop(linkage).square, linkage.theta1);
}

DriverRange inverted_slider_crank_slot_range(const InvertedSliderCrank& linkage) {
  const RrpLoop<double> loop = slot_loop(linkage);
  return angle_range(loop.stretch, loop.fold, linkage.theta1 + kPi / 2);
}

}  // namespace higherpair
