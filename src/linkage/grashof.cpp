#include "higherpair/linkage/grashof.hpp"

#include "higherpair/linkage/angles.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace higherpair {
namespace {

/// Transmission angle from the angle γ between links 3 and 4: tan²(γ/2) = fold/stretch.
double transmission_from(double stretch, double fold) {
  const double half = std::atan2(std::sqrt(std::max(fold, 0.0)), std::sqrt(std::max(stretch, 0.0)));
  return std::min(2 * half, kPi - 2 * half);
}

FourBarLoop<double> loop_of(const FourBar& linkage) {
  assert(linkage.r1 >= 0 && linkage.r2 >= 0 && linkage.r3 > 0 && linkage.r4 > 0);
  return make_four_bar_loop(linkage.r1, linkage.r2, linkage.r3, linkage.r4);
}

std::array<double, 4> lengths_of(const FourBar& linkage) {
  return {linkage.r1, linkage.r2, linkage.r3, linkage.r4};
}

std::array<double, 4> sorted_lengths(const FourBar& linkage) {
  std::array<double, 4> sorted = lengths_of(linkage);
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

}  // namespace

std::string_view name_of(GrashofClass grashof) {
  switch (grashof) {
    case GrashofClass::kCannotClose:
      return "cannot be closed";
    case GrashofClass::kChangePoint:
      return "change point";
    case GrashofClass::kCrankRocker:
      return "crank-rocker";
    case GrashofClass::kRockerCrank:
      return "rocker-crank";
    case GrashofClass::kDoubleCrank:
      return "double crank";
    case GrashofClass::kDoubleRocker:
      return "double rocker";
    case GrashofClass::kTripleRocker:
      return "triple rocker";
  }
  return "";
}

GrashofClass classify_grashof(const FourBar& linkage) {
  const std::array<double, 4> sorted = sorted_lengths(linkage);
  const double closing = balance(sorted[0], sorted[1], sorted[2], -sorted[3]);
  if (closing < 0) return GrashofClass::kCannotClose;
  const double margin = grashof_margin(linkage);
  if (closing == 0 || margin == 0) return GrashofClass::kChangePoint;
  if (margin < 0) return GrashofClass::kTripleRocker;

  // The shortest link is unique here: with two shortest lengths s + l >= p + q.
  constexpr std::array<GrashofClass, 4> by_shortest{GrashofClass::kDoubleCrank, GrashofClass::kCrankRocker,
                                                    GrashofClass::kDoubleRocker, GrashofClass::kRockerCrank};
  const std::array<double, 4> lengths = lengths_of(linkage);
  const auto shortest = std::min_element(lengths.begin(), lengths.end());
  return by_shortest[shortest - lengths.begin()];
}

double grashof_margin(const FourBar& linkage) {
  const std::array<double, 4> sorted = sorted_lengths(linkage);
  return balance(sorted[1], sorted[2], -sorted[0], -sorted[3]);
}

bool turns_fully(const FourBar& linkage, FourBarLink link) {
  assert(link != FourBarLink::kFrame);
  switch (classify_grashof(linkage)) {
    case GrashofClass::kDoubleCrank:
      return true;
    case GrashofClass::kCrankRocker:
      return link == FourBarLink::kCrank;
    case GrashofClass::kDoubleRocker:
      return link == FourBarLink::kCoupler;
    case GrashofClass::kRockerCrank:
      return link == FourBarLink::kRocker;
    default:
      return false;
  }
}

std::optional<TransmissionRange> transmission_range(const FourBar& linkage) {
  const FourBarLoop<double> loop = loop_of(linkage);
  if (!(loop.stretch.at_0 >= 0 && loop.fold.at_pi >= 0)) return std::nullopt;

  // γ grows with the diagonal, so its extremes are at crank angles 0 and π, or are 0 and π themselves at a
  // limit.
  const double first = transmission_from(loop.stretch.at_0, loop.fold.at_0);
  const double last = transmission_from(loop.stretch.at_pi, loop.fold.at_pi);
  const double psi_first = loop.fold.at_0 >= 0 ? 0 : root_angle(loop.fold);
  const double psi_last = loop.stretch.at_pi >= 0 ? kPi : root_angle(loop.stretch);
  const auto theta2 = [&](double psi) { return principal_angle(linkage.theta1 + psi); };
  TransmissionRange range{first, last, theta2(psi_first), theta2(psi_last)};
  if (first > last) range = {last, first, range.at_largest, range.at_smallest};

  // γ - 90° has the sign of fold - stretch, which is also linear in the cosine.
  const CosineLine<double> obtuse =
      make_cosine_line(loop.fold.at_0 - loop.stretch.at_0, loop.fold.at_pi - loop.stretch.at_pi,
                       loop.fold.half_swing - loop.stretch.half_swing);
  if (obtuse.at_0 < 0 && obtuse.at_pi > 0) {
    range.largest = kPi / 2;
    range.at_largest = theta2(root_angle(obtuse));
  }
  return range;
}

}  // namespace higherpair
