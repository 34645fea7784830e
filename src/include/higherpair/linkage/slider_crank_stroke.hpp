#pragma once

#include "higherpair/linkage/status.hpp"

#include <optional>

namespace higherpair {

/// A slider-crank: crank 2 about O2, coupler 3, and a slider on a line at a distance r4 from O2,
///     r2 e^{iθ2} + r3 e^{iθ3} = r1 e^{iθ1} + r4 e^{i(θ1 + 90°)}.
/// r1 is the slider's coordinate along θ1 from the foot of O2 on the line; the offset r4 has a sign, positive
/// where the line lies left of θ1. (A text that measures r4 along another θ4: the offset is r4 sin(θ4 - θ1),
/// and r4 cos(θ4 - θ1) adds to r1.)
///
/// Mode σ = +1, driven by
/// - the crank: the slider is ahead (along θ1) of the crank's end: cos(θ3 - θ1) > 0, the larger r1;
/// - the coupler: the same with 2 and 3 exchanged: cos(θ2 - θ1) > 0;
/// - the slider: the crank is counter-clockwise of the line from O2 to the slider.
///
/// \pre r2, r3 finite and > 0 (driven by the crank r2 = 0, by the coupler r3 = 0 is allowed: then nothing
/// moves).
struct SliderCrank {
  double r2 = 0;      ///< [m]
  double r3 = 0;      ///< [m]
  double r4 = 0;      ///< offset [m], with sign
  double theta1 = 0;  ///< direction of sliding [rad]
};

/// Where the slider reverses: crank and coupler are in line.
struct DeadCentre {
  double theta2 = 0;  ///< crank angle [rad], in (-π, π]
  double r1 = 0;      ///< the slider's coordinate [m]
};

/// Effect of a turn of the crank on the slider.
struct SliderCrankStroke {
  DeadCentre outer;       ///< crank and coupler stretched: the slider is at distance r2 + r3 from O2
  DeadCentre inner;       ///< folded onto each other: at distance r3 - r2 from O2
  double length = 0;      ///< distance between the two [m]; more than 2 r2 if there is an offset
  double turn_in = 0;     ///< crank angle, counter-clockwise, from outer to inner [rad]; π without offset
  double time_ratio = 1;  ///< of the slower to the faster stroke at constant speed, >= 1
};

/// The stroke of a slider-crank driven by its crank, in one mode. Empty unless the crank turns fully and
/// never passes a change point: r3 > r2 + |r4|.
///     r1² + r4² = (r3 ± r2)²,   length = 4 r2 r3/(|r1_outer| + |r1_inner|).
/// \pre r2, r3 > 0.
[[nodiscard]] std::optional<SliderCrankStroke> slider_crank_stroke(const SliderCrank& linkage,
                                                                   AssemblyMode mode);

}  // namespace higherpair
