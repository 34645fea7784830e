#include "linkage/slider_crank.hpp"

#include <cassert>

namespace higherpair {
namespace {

struct SliderChain {
  LinkageStatus status = LinkageStatus::kNotAssemblable;
  double theta_leg = 0;
  double r1 = 0;
  RrpRates<double> rates;
};

RrpLoop<double> crank_loop(const SliderCrank& linkage) {
  assert(linkage.r2 >= 0 && linkage.r3 > 0);
  return make_rrp_loop(linkage.r2, linkage.r3, linkage.r4);
}

RrpLoop<double> coupler_loop(const SliderCrank& linkage) {
  assert(linkage.r3 >= 0 && linkage.r2 > 0);
  return make_rrp_loop(linkage.r3, linkage.r2, linkage.r4);
}

SliderLoop<double> slider_loop(const SliderCrank& linkage) {
  assert(linkage.r2 > 0 && linkage.r3 > 0);
  return make_slider_loop(linkage.r2, linkage.r3, linkage.r4);
}

SliderChain solve(const RrpLoop<double>& loop, double theta1, const AngleMotion& arm, AssemblyMode mode) {
  const Rotation<double> u_arm = Rotation<double>::from_angle(arm.theta - theta1);
  const RrpPosition<double> position = rrp_position(loop, u_arm, sign(mode));

  SliderChain chain;
  chain.status = status_at_angle(position.reach, arm.theta, theta1);
  if (chain.status == LinkageStatus::kNotAssemblable) return chain;
  chain.theta_leg = absolute_angle(position.u_leg, theta1);
  chain.r1 = position.along;
  chain.rates = rrp_rates(loop, position, u_arm, arm.omega, arm.alpha);
  return chain;
}

/// The range of the arm, whose reach is measured from the direction at 90° to the line.
DriverRange range_of(const RrpLoop<double>& loop, double theta1) {
  return angle_range(loop.stretch, loop.fold, theta1 + kPi / 2);
}

}  // namespace

SliderCrankMotion slider_crank_by_crank(const SliderCrank& linkage, const AngleMotion& link2,
                                        AssemblyMode mode) {
  const SliderChain chain = solve(crank_loop(linkage), linkage.theta1, link2, mode);
  SliderCrankMotion motion{chain.status, link2.theta, chain.theta_leg, chain.r1, std::nullopt};
  if (chain.status == LinkageStatus::kOk) {
    const RrpRates<double>& rates = chain.rates;
    motion.rates = {link2.omega, rates.omega_leg, rates.along_dot,
                    link2.alpha, rates.alpha_leg, rates.along_ddot};
  }
  return motion;
}

SliderCrankMotion slider_crank_by_coupler(const SliderCrank& linkage, const AngleMotion& link3,
                                          AssemblyMode mode) {
  const SliderChain chain = solve(coupler_loop(linkage), linkage.theta1, link3, mode);
  SliderCrankMotion motion{chain.status, chain.theta_leg, link3.theta, chain.r1, std::nullopt};
  if (chain.status == LinkageStatus::kOk) {
    const RrpRates<double>& rates = chain.rates;
    motion.rates = {rates.omega_leg, link3.omega, rates.along_dot,
                    rates.alpha_leg, link3.alpha, rates.along_ddot};
  }
  return motion;
}

SliderCrankMotion slider_crank_by_slider(const SliderCrank& linkage, const SlideMotion& slider,
                                         AssemblyMode mode) {
  const SliderLoop<double> loop = slider_loop(linkage);
  const SliderPosition<double> position = slider_position(loop, slider.r, sign(mode));

  SliderCrankMotion motion;
  motion.status = status_of(position.reach);
  motion.r1 = slider.r;
  if (motion.status == LinkageStatus::kNotAssemblable) return motion;
  const Rotation<double> u3{-position.links.u_b.cos, -position.links.u_b.sin};
  motion.theta2 = absolute_angle(position.links.u_a, linkage.theta1);
  motion.theta3 = absolute_angle(u3, linkage.theta1);
  if (motion.status == LinkageStatus::kOk) {
    const RrrRates<double> rates = slider_rates(loop, position, slider.r_dot, slider.r_ddot);
    motion.rates = {rates.omega_a, rates.omega_b, slider.r_dot, rates.alpha_a, rates.alpha_b, slider.r_ddot};
  }
  return motion;
}

DriverRange slider_crank_crank_range(const SliderCrank& linkage) {
  return range_of(crank_loop(linkage), linkage.theta1);
}

DriverRange slider_crank_coupler_range(const SliderCrank& linkage) {
  return range_of(coupler_loop(linkage), linkage.theta1);
}

DriverRange slider_crank_slider_range(const SliderCrank& linkage) {
  const SliderLoop<double> loop = slider_loop(linkage);
  return slide_range(-loop.fold_0, loop.stretch_0);
}

}  // namespace higherpair
