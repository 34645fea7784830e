#pragma once

#include "higherpair/contact/contact_pair.hpp"
#include "higherpair/geometry/known_rotation.hpp"

#include <optional>

namespace higherpair {

/// A contact that is followed while the driver moves.
struct ContactTrack {
  ContactPair pair;
  int branch = 0;                 ///< sign of ∂gap/∂q; changes only where branches cross
  ContactPosition at;             ///< where it was held last
  double phi = 0;                 ///< angle of at.n_W, continuous [rad]
  bool interpolated = false;      ///< `at` is next to a crossing of branches, and not solved for
  bool assembled = true;          ///< false: lost at a limit; `at` is the last position before it
  double size = 0;                ///< of the mechanism where the track began [m]: one unit of a displacement
  double least_gap_q_scale2 = 0;  ///< see gap_scale.hpp; where the track began
  double d3q = 0;  ///< d³q/du³, d²φ/du² and d³φ/du³ from the last step: they only serve to predict the next
  double d2phi = 0;
  double d3phi = 0;
  double last_step = 0;    ///< of u: the one that they are from
  KnownRotation driver;    ///< of body 1, if it turns: at a position near by, if steps are short
  KnownRotation follower;  ///< the same of body 2
};

/// A position beyond which the driver cannot go on this branch: gap = ∂gap/∂φ = ∂gap/∂q = 0, or a conforming
/// contact (see events.hpp), or where the contact runs off to infinity along an open curve.
struct LimitPosition {
  double u = 0;
  double q = 0;
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

/// Starts to follow a contact. \pre `at` solves the pair and branch = ±1.
[[nodiscard]] ContactTrack start_track(const ContactPair& pair, const ContactPosition& at, int branch);

/// One step to u, predicted to third order, on the given branch. The caller has to judge whether it is the
/// same motion: a long step may arrive at another contact. The track changes with kOk only.
[[nodiscard]] ContactStatus step_to(ContactTrack& track, double u, int branch);

/// Moves the track along the straight path of the driver to u, in as many inner steps as it takes: each is
/// predicted to third order and accepted only if the solution agrees with the prediction. At a limit
/// position the driver position is located by Newton's method on the extended system; beyond it later calls
/// look for the branch again.
[[nodiscard]] TrackResult follow_to(ContactTrack& track, double u);

}  // namespace higherpair
