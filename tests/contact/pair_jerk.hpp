#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <optional>

// The jerk of a follower by contact_jerk() for a pair whose bodies are both on ground joints.

namespace higherpair {

/// Third derivative of the follower's coordinate with respect to the driver's.
struct PairJerk {
  double d3q = 0;                     ///< d³q/du³ of the two curves
  std::optional<double> linkage_d3q;  ///< of the equivalent linkage frozen at this position; none where n
                                      ///< lets the follower move freely (its joint's pivot on the normal)
};

/// \pre `at` solves the pair and has its rates. For `slipping_jerk` gap_q must not be 0, as it is at limits
/// and change points: none is returned there.
[[nodiscard]] std::optional<PairJerk> slipping_jerk(const ContactPair& pair, const ContactPosition& at);

/// The same for a pair that rolls (RollingTrack::at), which has no singular positions.
[[nodiscard]] PairJerk rolling_jerk(const ContactPair& pair, const ContactPosition& at);

}  // namespace higherpair
