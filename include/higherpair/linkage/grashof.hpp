#pragma once

#include "higherpair/linkage/four_bar.hpp"

#include <optional>
#include <string_view>

namespace higherpair {

/// Which links of a four-bar turn fully. s, l: shortest and longest length, p, q: the others.
enum class GrashofClass {
  kCannotClose,   ///< l > s + p + q: there is no such linkage
  kChangePoint,   ///< s + l = p + q to rounding: all links can be in line (also l = s + p + q)
  kCrankRocker,   ///< s + l < p + q, link 2 is the shortest and turns fully
  kRockerCrank,   ///< s + l < p + q, link 4 is the shortest and turns fully
  kDoubleCrank,   ///< s + l < p + q, ground is the shortest: 2, 3 and 4 turn fully
  kDoubleRocker,  ///< s + l < p + q, the coupler is the shortest: only it turns fully
  kTripleRocker,  ///< s + l > p + q: no link turns fully against another
};

/// "crank-rocker" and so on.
[[nodiscard]] std::string_view name_of(GrashofClass grashof);

[[nodiscard]] GrashofClass classify_grashof(const FourBar& linkage);

/// The transmission angle, between the lines of coupler and rocker, at crank angle θ2: 0 to π/2 [rad]; the
/// same in both modes; 0 at a dead point; empty where the linkage cannot be assembled.
[[nodiscard]] std::optional<double> transmission_angle(const FourBar& linkage, double theta2);

struct TransmissionRange {
  double smallest = 0;  ///< [rad]
  double largest = 0;   ///< [rad], at most π/2
};

/// Extremes of the transmission angle over all angles of the crank that can be assembled: at the crank in
/// line with the ground link, or 0 at a limit position. Empty if there are none.
[[nodiscard]] std::optional<TransmissionRange> transmission_range(const FourBar& linkage);

}  // namespace higherpair
