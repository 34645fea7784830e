#pragma once

#include "higherpair/contact/tracker.hpp"

#include <optional>

// Places where the conditions of a contact have lost their rank, so that a track cannot come to them by a
// step: crossings of branches, and limits.

namespace higherpair {

/// Of the driver's scale: how near a crossing is interpolated over.
inline constexpr double kNearCrossing = 5e-3;

/// Rests where branches cross, or next to it, at u. The position is interpolated between a place before and
/// one just beyond; its rates are those of the smooth motion. False where branches do not cross there.
[[nodiscard]] bool stop_at_crossing(ContactTrack& track, double u);

/// Where branches cross all conditions of a limit hold as well, but the motion goes on beyond. It is taken as
/// far beyond as it is still before; false where it does not go on.
[[nodiscard]] bool pass_crossing(ContactTrack& track, const LimitPosition& limit);

/// Rests at a limit that is at u. The position is the last of the branch and has no rates. False where the
/// limit is not at u.
[[nodiscard]] bool stop_at_limit(ContactTrack& track, double u, const LimitPosition& limit);

/// The same where a step has come so near to a limit that its rates are noise; sets the limit.
[[nodiscard]] bool has_come_to_limit(ContactTrack& track, std::optional<LimitPosition>& limit);

}  // namespace higherpair
