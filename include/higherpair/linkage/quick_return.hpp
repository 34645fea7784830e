#pragma once

#include "higherpair/linkage/inverted_slider_crank.hpp"

#include <optional>

namespace higherpair {

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
