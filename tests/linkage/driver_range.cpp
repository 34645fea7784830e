#include "linkage/driver_range.hpp"

namespace higherpair {

LinkageStatus status_at_angle(Reach<double> reach, double theta, double theta1) {
  reach.noise *= 1 + (std::abs(theta) + std::abs(theta1)) / kReachRoundings;
  return status_of(reach);
}

namespace {

DriverInterval interval_from(double begin, double width) {
  const double principal = principal_angle(begin);
  return {principal, principal + width};
}

}  // namespace

DriverRange angle_range(const CosineLine<double>& stretch, const CosineLine<double>& fold, double centre) {
  if (!(stretch.at_0 >= 0 && fold.at_pi >= 0)) return {};

  const bool over_0 = fold.at_0 >= 0;
  const bool over_pi = stretch.at_pi >= 0;
  if (over_0 && over_pi) return {DriverReach::kFullTurn, 0, {}};

  const double inner = over_0 ? 0 : root_angle(fold);
  const double outer = over_pi ? kPi : root_angle(stretch);
  if (over_0) return {DriverReach::kRanges, 1, {interval_from(centre - outer, 2 * outer)}};
  if (over_pi) return {DriverReach::kRanges, 1, {interval_from(centre + inner, 2 * (kPi - inner))}};
  return {DriverReach::kRanges,
          2,
          {interval_from(centre - outer, outer - inner), interval_from(centre + inner, outer - inner)}};
}

DriverRange slide_range(double inner, double outer) {
  if (!(outer >= 0)) return {};
  const double end = std::sqrt(outer);
  if (!(inner > 0)) return {DriverReach::kRanges, 1, {DriverInterval{-end, end}}};
  const double begin = std::sqrt(inner);
  return {DriverReach::kRanges, 2, {DriverInterval{-end, -begin}, DriverInterval{begin, end}}};
}

}  // namespace higherpair
