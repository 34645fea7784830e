#pragma once

#include <optional>

namespace higherpair {

/// An inverted slider-crank: crank 2 about O1 carries a pin C, and the pin runs in a straight slot (or
/// touches as a flat face's contact does) of a body 3 that turns about O2,
///     r2 e^{iθ2} = r1 e^{iθ1} + r3 e^{iθ3} + r4 e^{i(θ3 + 90°)}.
/// θ1 from O1 to O2, θ3 the slot's direction; r3 the pin's coordinate along the slot from the foot of O2 on
/// it; the offset r4 of the slot from O2 has a sign, positive where the slot lies left of θ3.
///
/// Mode σ = +1, driven by
/// - the crank: the pin is ahead of the foot of O2: r3 > 0;
/// - the slot: cos(θ2 - θ3) > 0: of the two points in which the pin's circle meets the slot the one ahead.
///
/// \pre r1, r2 finite and >= 0; driven by the slot r2 > 0.
struct InvertedSliderCrank {
  double r1 = 0;      ///< [m]
  double r2 = 0;      ///< [m]
  double r4 = 0;      ///< offset [m], with sign
  double theta1 = 0;  ///< direction of the ground link [rad]
};

/// What a full turn of the crank does to the slotted lever of an inverted slider-crank.
struct QuickReturn {
  bool lever_turns = false;  ///< fully (Whitworth's, the crank longer than the frame); else it swings
  double swing = 0;          ///< of a lever that swings: angle between its two limits [rad]
  double time_ratio = 1;     ///< of the slow stroke to the fast one at constant speed of the crank, >= 1
};

/// Empty where the crank does not turn fully without coming to a change point. With s the shorter and l the
/// longer of frame r1 and crank r2, and e = |r4| the offset, it does if l > s + e. With
///     σ = acos((e - s)/l) - acos((e + s)/l),   2 asin(s/l) without offset,
/// the crank turns π + σ in the slow stroke and π - σ in the fast one, a time ratio of (π + σ)/(π - σ).
/// - The crank shorter than the frame: σ is the swing, and the lever is at its limits where the crank
///   is square to the slot.
/// - The crank longer: the strokes are the half turns of the lever between the two positions in which its
///   slot is square to the frame, as of a ram that runs square to the frame.
/// \pre r1, r2 > 0
[[nodiscard]] std::optional<QuickReturn> quick_return(const InvertedSliderCrank& linkage);

}  // namespace higherpair
