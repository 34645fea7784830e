#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <optional>

// The jerk of a follower by contact_jerk(), where both bodies of a pair are on joints to ground.

namespace higherpair {

/// Third derivative of the follower's coordinate by the driver's.
struct PairJerk {
  double d3q = 0;                     ///< d³q/du³ of the two curves
  std::optional<double> linkage_d3q;  ///< of the equivalent linkage frozen at this position; none where n
                                      ///< lets the follower move freely (its joint's pivot on the normal)
};

/// \pre `at` solves the pair with its rates; for `slipping_jerk` gap_q is not 0 (it is at a limit position
/// and where branches cross: none is given there).
[[nodiscard]] std::optional<PairJerk> slipping_jerk(const ContactPair& pair, const ContactPosition& at);

/// The same for a pair that rolls (RollingTrack::at); no singular positions.
[[nodiscard]] PairJerk rolling_jerk(const ContactPair& pair, const ContactPosition& at);

}  // namespace higherpair
