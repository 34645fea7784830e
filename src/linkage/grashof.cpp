#include "higherpair/linkage/grashof.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace higherpair {
namespace {

/// From the angle γ between links 3 and 4: tan²(γ/2) = fold/stretch.
double transmission_from(double stretch, double fold) {
  const double half = std::atan2(std::sqrt(std::max(fold, 0.0)), std::sqrt(std::max(stretch, 0.0)));
  return std::min(2 * half, kPi - 2 * half);
}

FourBarLoop<double> loop_of(const FourBar& linkage) {
  assert(linkage.r1 >= 0 && linkage.r2 >= 0 && linkage.r3 > 0 && linkage.r4 > 0);
  return make_four_bar_loop(linkage.r1, linkage.r2, linkage.r3, linkage.r4);
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
  const std::array<double, 4> lengths{linkage.r1, linkage.r2, linkage.r3, linkage.r4};
  std::array<double, 4> sorted = lengths;
  std::sort(sorted.begin(), sorted.end());

  const double closing = balance(sorted[0], sorted[1], sorted[2], -sorted[3]);
  if (closing < 0) return GrashofClass::kCannotClose;
  const double excess = balance(sorted[0], sorted[3], -sorted[1], -sorted[2]);
  if (closing == 0 || excess == 0) return GrashofClass::kChangePoint;
  if (excess > 0) return GrashofClass::kTripleRocker;

  // The shortest is unique here: two shortest lengths have s + l >= p + q.
  constexpr std::array<GrashofClass, 4> by_shortest{GrashofClass::kDoubleCrank, GrashofClass::kCrankRocker,
                                                    GrashofClass::kDoubleRocker, GrashofClass::kRockerCrank};
  const auto shortest = std::min_element(lengths.begin(), lengths.end());
  return by_shortest[static_cast<std::size_t>(shortest - lengths.begin())];
}

std::optional<double> transmission_angle(const FourBar& linkage, double theta2) {
  const FourBarLoop<double> loop = loop_of(linkage);
  const Reach<double> reach =
      reach_at(loop.stretch, loop.fold, Rotation<double>::from_angle(theta2 - linkage.theta1));
  if (status_at_angle(reach, theta2, linkage.theta1) == LinkageStatus::kNotAssemblable) return std::nullopt;
  return transmission_from(reach.stretch, reach.fold);
}

std::optional<TransmissionRange> transmission_range(const FourBar& linkage) {
  const FourBarLoop<double> loop = loop_of(linkage);
  if (!(loop.stretch.at_0 >= 0 && loop.fold.at_pi >= 0)) return std::nullopt;

  // γ grows with the diagonal, so its ends are at crank angles 0 and π, or 0 and π itself at a limit.
  const double first = transmission_from(loop.stretch.at_0, loop.fold.at_0);
  const double last = transmission_from(loop.stretch.at_pi, loop.fold.at_pi);
  const bool first_obtuse = loop.fold.at_0 > loop.stretch.at_0;
  const bool last_obtuse = loop.fold.at_pi > loop.stretch.at_pi;
  const double largest = first_obtuse != last_obtuse ? kPi / 2 : std::max(first, last);
  return TransmissionRange{std::min(first, last), largest};
}

}  // namespace higherpair
