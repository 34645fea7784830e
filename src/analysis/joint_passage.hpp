#pragma once

#include "span_ends.hpp"

#include <cstddef>

// What happens where a contact goes over a joint of spans; span_joints.hpp finds it.

namespace higherpair {

/// A joint of two spans over which a contact goes.
struct JointPassage {
  std::size_t contact = 0;
  std::size_t side = 0;         ///< 0: the contact's first body, 1: its second
  BoundaryPlace before, after;  ///< the two places that meet there
  double x = 0;                 ///< beyond run.at.state on the path
  bool solved = false;          ///< run.work.trial is there
};

/// Holds the contact of a passage at a place of its boundary, whatever rounding has made of it.
void set_place_of(const Run& run, const JointPassage& passage, const BoundaryPlace& place, State& state);

/// Places run.work.trial at the joint, still on the span before it, with its rates; false if it cannot be
/// placed.
[[nodiscard]] bool place_at_joint(Run& run, const Path& path, double s, const JointPassage& passage);

/// Lets run.at.state, which is at the joint at s, go on with the span after it. An event says what jumps.
void go_over_joint(Run& run, const Path& path, double s, const JointPassage& passage);

}  // namespace higherpair
