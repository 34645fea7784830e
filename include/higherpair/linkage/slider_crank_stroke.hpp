#pragma once

#include "higherpair/linkage/slider_crank.hpp"

#include <optional>

namespace higherpair {

/// Where the slider turns back: crank and coupler are in line.
struct DeadCentre {
  double theta2 = 0;  ///< crank angle [rad], in (-π, π]
  double r1 = 0;      ///< the slider's coordinate [m]
};

/// What a turn of the crank does to the slider.
struct SliderCrankStroke {
  DeadCentre outer;       ///< crank and coupler stretched: the slider at r2 + r3 from O2
  DeadCentre inner;       ///< folded upon each other: at r3 - r2 from O2
  double length = 0;      ///< distance between the two [m]; more than 2 r2 if there is an offset
  double turn_in = 0;     ///< crank angle, counter-clockwise, from outer to inner [rad]; π without offset
  double time_ratio = 1;  ///< of the slower to the faster of the two ways at constant speed, >= 1
};

/// The stroke in a mode of `slider_crank_by_crank`. Empty unless the crank turns fully and never passes a
/// change point: r3 > r2 + |r4|.
///     r1² + r4² = (r3 ± r2)²,   length = 4 r2 r3/(|r1_outer| + |r1_inner|).
/// \pre r2, r3 > 0.
[[nodiscard]] std::optional<SliderCrankStroke> slider_crank_stroke(const SliderCrank& linkage,
                                                                   AssemblyMode mode);

}  // namespace higherpair
