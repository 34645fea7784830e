#pragma once

#include "contact/pair_follower.hpp"
#include "contact/touch/inner_step.hpp"
#include "higherpair/contact/gap_scale.hpp"

#include <optional>

// Positions where the conditions of a contact lose rank, so that a track cannot reach them by an ordinary
// step: crossings of branches, and limits.

namespace higherpair {

/// Like accept() of a ContactTrack.
inline void accept(FollowedContact& track, const ContactPosition& at, int branch) {
  accept(static_cast<ContactTrack&>(track), at, branch);
  track.interpolated = false;
}

/// Fraction of the driver's unit within which a crossing is interpolated over.
inline constexpr double kNearCrossing = 5e-3;

// Largest ∂gap/∂q that may be that of a crossing, relative to its scale and to its present value.
inline constexpr double kAtCrossing = 1e-3;
inline constexpr double kFallsToCrossing = 1e-3;

// Whether a predicted ∂gap/∂q is small enough for a crossing, relative to its scale or to its present value.
[[nodiscard]] inline bool vanishes(const ContactTrack& track, double gap_q) {
  if (std::abs(gap_q) <= kFallsToCrossing * std::abs(track.at.gap_q)) {
    return true;
  }
  return gap_q * gap_q <= kAtCrossing * kAtCrossing * gap_q_scale2(track.pair, track.at);
}

/// Ends a path at u, where branches cross, or next to it. The position is interpolated between one before the
/// crossing and one just beyond it; its rates are those of the smooth motion. False where branches do not
/// cross there.
[[nodiscard]] bool stop_at_crossing(FollowedContact& track, double u);

/// At a crossing of branches all conditions of a limit hold too, but the motion continues. The track is moved
/// beyond it, as far as it is now before it; false where the motion does not continue.
[[nodiscard]] bool pass_crossing(FollowedContact& track, const LimitPosition& limit);

/// Ends a path at a limit that coincides with u. The position is the last of the branch and has no rates.
/// False where the limit is not at u.
[[nodiscard]] bool stop_at_limit(FollowedContact& track, double u, const LimitPosition& limit);

/// The same where a step has ended so near to a limit that its rates are noise; sets the limit.
[[nodiscard]] bool has_come_to_limit(FollowedContact& track, std::optional<LimitPosition>& limit);

}  // namespace higherpair
