#pragma once

#include "span_ends.hpp"

#include <cstddef>

// What happens where a contact passes a joint of spans; span_joints.hpp finds such joints.

namespace higherpair {

/// A joint of two spans that a contact passes.
struct JointPassage {
  std::size_t contact = 0;
  std::size_t side = 0;         ///< 0: the contact's first body, 1: its second
  BoundaryPlace before, after;  ///< the two places that meet there
  double x = 0;                 ///< distance beyond run.at.state on the path
  bool solved = false;          ///< run.work.trial is at the joint
};

/// How the two spans join there.
[[nodiscard]] SpanJoint joint_of(const Run& run, const JointPassage& passage);

/// Whether the span beyond a joint lies flat on the other curve there.
/// \param state  at the joint
[[nodiscard]] bool lies_flat_behind(const Run& run, const JointPassage& passage, const State& state);
[[nodiscard]] inline bool lies_flat_behind(const Run& run, const JointPassage& passage) {
  return lies_flat_behind(run, passage, run.at.state);
}

/// Sets a contact to a place of one of its boundaries exactly, whatever rounding has left.
void set_place_of(const Run& run, std::size_t contact, std::size_t side, const BoundaryPlace& place,
                  State& state);

/// The same, also for the point at which this body is touched.
void set_point_of(const Run& run, std::size_t contact, std::size_t side, const BoundaryPlace& place,
                  State& state);

/// Places run.work.trial at the joint, still on the span before it, with its rates; false if it cannot be
/// placed.
[[nodiscard]] bool place_at_joint(Run& run, const Path& path, double s, const JointPassage& passage);

/// Moves the contact of run.at.state, which is at the joint at s, on to the span after it. Adds an event if
/// something jumps.
void go_over_joint(Run& run, const Path& path, double s, const JointPassage& passage);

}  // namespace higherpair
