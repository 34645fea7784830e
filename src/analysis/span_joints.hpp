#pragma once

#include "straight_path.hpp"

#include <array>
#include <optional>

namespace higherpair {

/// The curve of a contact on side 0 or 1.
[[nodiscard]] inline const CurveRef& ref_of(const Contact& contact, std::size_t side) {
  return side == 0 ? contact.first : contact.second;
}

/// A joint of two spans over which a contact goes.
struct JointPassage {
  std::size_t contact = 0;
  std::size_t side = 0;         ///< 0: the contact's first body, 1: its second
  BoundaryPlace before, after;  ///< the two places that meet there
  double x = 0;                 ///< beyond run.at.state on the path
  bool solved = false;          ///< run.work.trial is there
};

/// Sets the contacts of run.work.trial onto the places of run.at.state, so that a step shows which have left
/// theirs.
void mark_places(Run& run);

/// The first joint over which a contact goes between run.at.state, which is at s, and run.work.trial, the
/// positions a step of h tried; none if all contacts stay on their spans. run.work.trial is left somewhere
/// between.
[[nodiscard]] std::optional<JointPassage> joint_within(Run& run, const Path& path, double s, double h);

/// Holds the contact of a passage at a place of its boundary, whatever rounding has made of it.
void set_place_of(const Run& run, const JointPassage& passage, const BoundaryPlace& place, State& state);

/// Places run.work.trial at the joint, still on the span before it, with its rates; false if it cannot be
/// placed.
[[nodiscard]] bool place_at_joint(Run& run, const Path& path, double s, const JointPassage& passage);

/// Lets run.at.state, which is at the joint at s, go on with the span after it. An event says what jumps.
void go_over_joint(Run& run, const Path& path, double s, const JointPassage& passage);

/// Whether the contact of group g is at an end or a concave corner of a boundary, beyond which it cannot go;
/// the sentence that says so.
[[nodiscard]] std::optional<std::string> end_reached(const Run& run, std::size_t g);

/// Whether it is where a curve goes over into the edge at its end.
[[nodiscard]] bool is_at_edge(const Run& run, std::size_t g);

/// Whether a place of a contact's curve on side 0 or 1 is on the edge at its end.
[[nodiscard]] bool is_on_edge(const Run& run, std::size_t contact, std::size_t side,
                              const BoundaryPlace& place);

/// Where a contact has gone over to another place at s, in run.at.state: an event if that is on the edge at
/// an end of a curve, and the place before it was not.
void note_edge(Run& run, const Path& path, double s, std::size_t contact,
               const std::array<BoundaryPlace, 2>& before);

/// Where the motion cannot go on with the contact of group g: whether it is on the edge at an end of a curve;
/// the sentence that says so.
[[nodiscard]] std::optional<std::string> slipped_off(const Run& run, std::size_t g);

/// The name of a contact's first body (side 0) or second one.
[[nodiscard]] const std::string& body_of_side(const Run& run, std::size_t contact, std::size_t side);

/// Gives the curves of contacts by_boundary the shape that they have where the row's contact is.
void set_local_curves(Run& run);

}  // namespace higherpair
