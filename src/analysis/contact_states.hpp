#pragma once

#include "group_kinds.hpp"
#include "higherpair/contact/gap_scale.hpp"

#include <cmath>

// What contacts are told of by a state, of either kind of group.

namespace higherpair {

/// Seen from the first body of the file.
[[nodiscard]] inline ContactMotion contact_motion(const ContactPosition& at, double phi,
                                                  bool first_is_first) {
  ContactMotion motion;
  if (first_is_first) {
    motion.at = at;
    motion.phi = phi;
  } else {
    motion.at = at.exchanged();
    motion.phi = phi + kPi;
  }
  return motion;
}

/// The group is singular where the follower's joint does not change the gap.
inline void set_sine(const ContactPair& pair, const ContactPosition& at, GroupState& group) {
  group.sine = at.gap_q;
  group.lever = std::sqrt(gap_q_scale2(pair, at));
  group.noise = kGapQIsZero * group.lever;
}

[[nodiscard]] inline GroupStatus status_of(ContactStatus status) {
  return status == ContactStatus::kNoContact ? GroupStatus::kOutOfReach : GroupStatus::kNotConverged;
}

}  // namespace higherpair
