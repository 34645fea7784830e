#pragma once

#include "group_kinds.hpp"
#include "higherpair/contact/gap_scale.hpp"

#include <cmath>

// Sets the part of a state that describes a contact, for both kinds of groups that place a body by one.

namespace higherpair {

/// The contact as seen from the first body of its description.
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

/// Sets the sine of a group, which is singular where the follower's coordinate does not change the gap.
inline void set_sine(const ContactPair& pair, const ContactPosition& at, GroupState& group) {
  group.sine = at.gap_q;
  group.lever = std::sqrt(gap_q_scale2(pair, at));
  group.noise = kGapQIsZero * group.lever;
}

[[nodiscard]] inline GroupStatus status_of(ContactStatus status) {
  return status == ContactStatus::kNoContact ? GroupStatus::kOutOfReach : GroupStatus::kNotConverged;
}

}  // namespace higherpair
