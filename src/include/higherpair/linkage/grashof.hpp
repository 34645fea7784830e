#pragma once

#include "higherpair/linkage/four_bar.hpp"

#include <optional>
#include <string_view>

namespace higherpair {

/// Which links of a four-bar turn fully. s, l: shortest and longest length, p, q: the others.
enum class GrashofClass {
  kCannotClose,   ///< l > s + p + q: there is no such linkage
  kChangePoint,   ///< s + l = p + q to within rounding: all links can be in line (also l = s + p + q)
  kCrankRocker,   ///< s + l < p + q, link 2 is the shortest and turns fully
  kRockerCrank,   ///< s + l < p + q, link 4 is the shortest and turns fully
  kDoubleCrank,   ///< s + l < p + q, ground is the shortest: 2, 3 and 4 turn fully
  kDoubleRocker,  ///< s + l < p + q, the coupler is the shortest: only it turns fully
  kTripleRocker,  ///< s + l > p + q: no link turns fully against another
};

/// "crank-rocker" and so on.
[[nodiscard]] std::string_view name_of(GrashofClass grashof);

/// By Grashof's law; lengths in any unit. A balance of four lengths to within rounding counts as exact.
[[nodiscard]] GrashofClass classify_grashof(const FourBar& linkage);

/// p + q - s - l [m]: positive if some link turns fully against another and never passes a change point, 0 if
/// the lengths balance to within rounding.
[[nodiscard]] double grashof_margin(const FourBar& linkage);

/// Whether a link turns fully against ground without passing a change point: the margin is positive and the
/// shortest link is this one or ground. A coupler of length 2a between equal arms c on a frame of length 2d >
/// 2a turns fully iff a + d < c.
///
/// \pre `link` is not ground.
[[nodiscard]] bool turns_fully(const FourBar& linkage, FourBarLink link);

/// The transmission angle is the one between the lines of coupler and rocker, 0 to π/2 [rad]: the same in
/// both modes and at crank angles mirrored at the ground link.
struct TransmissionRange {
  double smallest = 0;     ///< [rad]
  double largest = 0;      ///< [rad], at most π/2
  double at_smallest = 0;  ///< crank angle θ2 there [rad], in (-π, π]
  double at_largest = 0;
};

/// Extremes of the transmission angle over all crank angles at which the linkage can be assembled: with the
/// crank in line with the ground link, or 0 at a limit position, or π/2 in between. Empty if there are no
/// such angles.
[[nodiscard]] std::optional<TransmissionRange> transmission_range(const FourBar& linkage);

}  // namespace higherpair
