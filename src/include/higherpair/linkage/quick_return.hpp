#pragma once

#include <optional>

namespace higherpair {

/// An inverted slider-crank: crank 2 about O1 carries a pin C that runs in a straight slot of a body 3 (or
/// touches it as a flat face's contact does), which turns about O2,
///     r2 e^{iθ2} = r1 e^{iθ1} + r3 e^{iθ3} + r4 e^{i(θ3 + 90°)}.
/// θ1 from O1 to O2, θ3 the slot's direction; r3 the pin's coordinate along the slot from the foot of O2 on
/// it; the offset r4 of the slot from O2 has a sign, positive where the slot lies left of θ3.
///
/// Mode σ = +1, driven by
/// - the crank: the pin is ahead of the foot of O2 on the slot: r3 > 0;
/// - the slot: cos(θ2 - θ3) > 0: the one ahead of the two points in which the pin's circle meets the slot.
///
/// \pre r1, r2 finite and >= 0; driven by the slot r2 > 0.
struct InvertedSliderCrank {
  double r1 = 0;      ///< [m]
  double r2 = 0;      ///< [m]
  double r4 = 0;      ///< offset [m], with sign
  double theta1 = 0;  ///< direction of the ground link [rad]
};

/// Effect of a full turn of the crank on the slotted lever of an inverted slider-crank.
struct QuickReturn {
  bool lever_turns = false;  ///< fully (Whitworth's, the crank longer than the frame); else it swings
  double swing = 0;          ///< for an oscillating lever: angle between its two limits [rad]
  double time_ratio = 1;     ///< of the slow stroke to the fast one at constant speed of the crank, >= 1
};

/// Empty unless the crank turns fully without reaching a change point. With s the shorter and l the longer of
/// frame r1 and crank r2, and e = |r4| the offset, it does so if l > s + e. With
///     σ = acos((e - s)/l) - acos((e + s)/l),   2 asin(s/l) without offset,
/// the crank turns π + σ in the slow stroke and π - σ in the fast one, a time ratio of (π + σ)/(π - σ).
/// - Crank shorter than the frame: σ is the swing, and the lever is at its limits where the crank is
/// perpendicular to the slot.
/// - Crank longer than the frame: the strokes are the half turns of the lever between the two positions in
/// which its slot is perpendicular to the frame, as for a ram that moves perpendicular to the frame.
/// \pre r1, r2 > 0
[[nodiscard]] std::optional<QuickReturn> quick_return(const InvertedSliderCrank& linkage);

}  // namespace higherpair
