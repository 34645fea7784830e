#pragma once

#include "higherpair/contact/contact_pair.hpp"
#include "higherpair/geometry/known_rotation.hpp"

namespace higherpair {

/// A contact that is followed while the driver moves.
struct ContactTrack {
  ContactPair pair;
  int branch = 0;      ///< sign of ∂gap/∂q; changes only where branches cross
  ContactPosition at;  ///< the last position reached
  double phi = 0;      ///< angle of at.n_W, continuous [rad]
  double size = 0;     ///< of the mechanism where the track began [m]: the unit of displacements
  /// d³q/du³, d²φ/du² and d³φ/du³ estimated over the last step: they only serve to predict the next.
  double d3q = 0;
  double d2phi = 0;
  double d3phi = 0;
  double last_step = 0;  ///< step of u over which they were estimated
  KnownRotation driver;  ///< rotation of body 1, if it turns, known at a position near by if steps are short
  KnownRotation follower;  ///< the same of body 2
};

/// Starts to follow a contact. \pre `at` solves the pair and branch = ±1.
[[nodiscard]] ContactTrack start_track(const ContactPair& pair, const ContactPosition& at, int branch);

/// One step to u, predicted to third order, on the given branch. The caller has to judge whether the result
/// belongs to the same motion: a long step may arrive at another contact. The track changes with kOk only.
[[nodiscard]] ContactStatus step_to(ContactTrack& track, double u, int branch);

/// Follows a contact to the driver coordinate u, within a range in which it is known to be smooth: neither
/// limits nor jumps are looked for on the path. False where it cannot be followed; the track then stays at
/// the last position reached. \param may_cross  branches may cross on the path: ∂gap/∂q may change its sign
[[nodiscard]] bool walk_to(ContactTrack& track, double u, bool may_cross = false);

}  // namespace higherpair
