#pragma once

#include "contact/pair_limits.hpp"
#include "higherpair/contact/tracker.hpp"

#include <optional>

// Follows a single contact over crossings of branches and up to limits. Its conditions and method differ from
// those by which whole mechanisms are followed, so that the two can be compared.

namespace higherpair {

/// A contact that is followed by follow_to().
struct FollowedContact : ContactTrack {
  FollowedContact() = default;
  FollowedContact(const ContactTrack& track) : ContactTrack(track) {}

  bool interpolated = false;  ///< `at` is interpolated next to a crossing, not solved for
  bool assembled = true;      ///< false: lost at a limit; `at` is the last position before it
};

enum class TrackStatus {
  kOk,              ///< the track is at the driver position asked for
  kNotAssemblable,  ///< no contact of this branch there; the track waits for a position where there is one
};

struct TrackResult {
  TrackStatus status = TrackStatus::kNotAssemblable;
  /// A limit that was passed on the way, if any. Where u itself is a limit, the track ends there with ∂gap/∂q
  /// = 0; its rates are undefined and set to 0.
  std::optional<LimitPosition> limit;
};

/// Moves the track along the straight path of the driver to u in as many inner steps as needed: each is
/// predicted to third order and accepted only if the solution agrees with the prediction. A limit is located
/// by Newton's method on the extended system; after a limit, later calls look for the branch again.
[[nodiscard]] TrackResult follow_to(FollowedContact& track, double u);

}  // namespace higherpair
