#pragma once

#include "contact/inner_step.hpp"
#include "contact/pair_follower.hpp"
#include "higherpair/contact/gap_scale.hpp"

#include <optional>

// Places where the conditions of a contact have lost their rank, so that a track cannot come to them by a
// step: crossings of branches, and limits.

namespace higherpair {

/// As accept() of a track.
inline void accept(FollowedContact& track, const ContactPosition& at, int branch) {
  accept(static_cast<ContactTrack&>(track), at, branch);
  track.interpolated = false;
}

/// Of the driver's scale: how near a crossing is interpolated over.
inline constexpr double kNearCrossing = 5e-3;

// ∂gap/∂q that may be that of a crossing: of its scale, and of its present value.
inline constexpr double kAtCrossing = 1e-3;
inline constexpr double kFallsToCrossing = 1e-3;

// Whether a ∂gap/∂q to come is small enough for a crossing: against its scale, or against what it is now.
[[nodiscard]] inline bool vanishes(const ContactTrack& track, double gap_q) {
  if (std::abs(gap_q) <= kFallsToCrossing * std::abs(track.at.gap_q)) {
    return true;
  }
  const double scale2 =
      velocity_per_q(track.pair.motion2, track.at.p2_W).squaredNorm() + track.least_gap_q_scale2;
  return gap_q * gap_q <= kAtCrossing * kAtCrossing * scale2;
}

/// Rests where branches cross, or next to it, at u. The position is interpolated between a place before and
/// one just beyond; its rates are those of the smooth motion. False where branches do not cross there.
[[nodiscard]] bool stop_at_crossing(FollowedContact& track, double u);

/// Where branches cross all conditions of a limit hold as well, but the motion goes on beyond. It is taken as
/// far beyond as it is still before; false where it does not go on.
[[nodiscard]] bool pass_crossing(FollowedContact& track, const LimitPosition& limit);

/// Rests at a limit that is at u. The position is the last of the branch and has no rates. False where the
/// limit is not at u.
[[nodiscard]] bool stop_at_limit(FollowedContact& track, double u, const LimitPosition& limit);

/// The same where a step has come so near to a limit that its rates are noise; sets the limit.
[[nodiscard]] bool has_come_to_limit(FollowedContact& track, std::optional<LimitPosition>& limit);

}  // namespace higherpair
