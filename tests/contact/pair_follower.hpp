#pragma once

#include "contact/pair_limits.hpp"
#include "higherpair/contact/tracker.hpp"

#include <optional>

// Follows one contact by itself, over crossings of branches and up to limits: other conditions and another
// way than those by which mechanisms are followed, to hold them against.

namespace higherpair {

/// A contact that is followed by follow_to().
struct FollowedContact : ContactTrack {
  FollowedContact() = default;
  FollowedContact(const ContactTrack& track) : ContactTrack(track) {}

  bool interpolated = false;  ///< `at` is next to a crossing of branches, and not solved for
  bool assembled = true;      ///< false: lost at a limit; `at` is the last position before it
};

enum class TrackStatus {
  kOk,              ///< the track is at the driver position asked for
  kNotAssemblable,  ///< no contact of this branch there; the track waits for a position where there is one
};

struct TrackResult {
  TrackStatus status = TrackStatus::kNotAssemblable;
  /// Passed on the way, if any. Where u itself is one, the track is there with ∂gap/∂q = 0, and its
  /// rates, which are not defined, are 0.
  std::optional<LimitPosition> limit;
};

/// Moves the track along the straight path of the driver to u, in as many inner steps as it takes: each is
/// predicted to third order and accepted only if the solution agrees with the prediction. At a limit
/// position the driver position is located by Newton's method on the extended system; beyond it later calls
/// look for the branch again.
[[nodiscard]] TrackResult follow_to(FollowedContact& track, double u);

}  // namespace higherpair
