#include "linkage/four_bar_motion.hpp"

#include <cassert>

namespace higherpair {
namespace {

struct Chain {
  LinkageStatus status = LinkageStatus::kNotAssemblable;
  double theta_J = 0;
  double theta4 = 0;
  RrrRates<double> rates;
};

FourBarLoop<double> crank_loop(const FourBar& linkage) {
  assert(linkage.r1 >= 0 && linkage.r2 >= 0 && linkage.r3 > 0 && linkage.r4 > 0);
  return make_four_bar_loop(linkage.r1, linkage.r2, linkage.r3, linkage.r4);
}

FourBarLoop<double> coupler_loop(const FourBar& linkage) {
  assert(linkage.r1 >= 0 && linkage.r3 >= 0 && linkage.r2 > 0 && linkage.r4 > 0);
  return make_four_bar_loop(linkage.r1, linkage.r3, linkage.r2, linkage.r4);
}

Chain solve(const FourBarLoop<double>& loop, double theta1, const AngleMotion& link_M, AssemblyMode mode) {
  const Rotation<double> u_M = Rotation<double>::from_angle(link_M.theta - theta1);
  const FourBarPosition<double> position = four_bar_position(loop, u_M, sign(mode));

  Chain chain;
  chain.status = status_at_angle(position.reach, link_M.theta, theta1);
  if (chain.status == LinkageStatus::kNotAssemblable) return chain;
  chain.theta_J = absolute_angle(position.links.u_a, theta1);
  chain.theta4 = absolute_angle(position.links.u_b, theta1);
  chain.rates = four_bar_rates(loop, position, u_M, link_M.omega, link_M.alpha);
  return chain;
}

}  // namespace

FourBarMotion four_bar_by_crank(const FourBar& linkage, const AngleMotion& link2, AssemblyMode mode) {
  const Chain chain = solve(crank_loop(linkage), linkage.theta1, link2, mode);
  FourBarMotion motion{chain.status, link2.theta, chain.theta_J, chain.theta4, std::nullopt};
  if (chain.status == LinkageStatus::kOk) {
    const RrrRates<double>& rates = chain.rates;
    motion.rates = {link2.omega, rates.omega_a, rates.omega_b, link2.alpha, rates.alpha_a, rates.alpha_b};
  }
  return motion;
}

FourBarMotion four_bar_by_coupler(const FourBar& linkage, const AngleMotion& link3, AssemblyMode mode) {
  const Chain chain = solve(coupler_loop(linkage), linkage.theta1, link3, mode);
  FourBarMotion motion{chain.status, chain.theta_J, link3.theta, chain.theta4, std::nullopt};
  if (chain.status == LinkageStatus::kOk) {
    const RrrRates<double>& rates = chain.rates;
    motion.rates = {rates.omega_a, link3.omega, rates.omega_b, rates.alpha_a, link3.alpha, rates.alpha_b};
  }
  return motion;
}

DriverRange four_bar_crank_range(const FourBar& linkage) {
  const FourBarLoop<double> loop = crank_loop(linkage);
  return angle_range(loop.stretch, loop.fold, linkage.theta1);
}

DriverRange four_bar_coupler_range(const FourBar& linkage) {
  const FourBarLoop<double> loop = coupler_loop(linkage);
  return angle_range(loop.stretch, loop.fold, linkage.theta1);
}

}  // namespace higherpair
