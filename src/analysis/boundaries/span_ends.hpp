#pragma once

#include "analysis/follow/path_events.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/joint_sides.hpp"

#include <array>
#include <optional>
#include <string>

namespace higherpair {

/// The boundary of a contact on side 0 or 1. \pre the contact is by_boundary
[[nodiscard]] inline const Boundary& boundary_at(const Run& run, std::size_t contact, std::size_t side) {
  return boundary_of(run.mechanism(), ref_of(run.mechanism().contacts[contact], side));
}

/// The name of its body.
[[nodiscard]] inline const std::string& body_of_side(const Run& run, std::size_t contact, std::size_t side) {
  const CurveRef& ref = ref_of(run.mechanism().contacts[contact], side);
  return run.mechanism().bodies[ref.body].name;
}

/// A contact that cannot go on, and the sentence that says why.
struct ContactEnd {
  std::size_t contact = 0;
  std::string cause;
};

/// The contact of group g that is at an end or a concave corner of a boundary, beyond which it cannot go.
[[nodiscard]] std::optional<ContactEnd> end_reached(const Run& run, std::size_t g);

/// Whether the contact of group g is where a curve continues into the edge at its end.
[[nodiscard]] bool is_at_edge(const Run& run, std::size_t g);

/// Whether a contact of group g is where spans of both its curves end, as where two corners meet.
[[nodiscard]] bool is_at_ends_of_both(const Run& run, std::size_t g);

/// Whether a place of a contact's curve on side 0 or 1 is on the edge at its end.
[[nodiscard]] bool is_on_edge(const Run& run, std::size_t contact, std::size_t side,
                              const BoundaryPlace& place);

/// The sentence of an event that the contact comes there along the curve.
[[nodiscard]] std::string onto_edge_text(const Run& run, std::size_t contact, std::size_t side);

/// After a contact has gone over to another place at s, in run.at.state: adds an event if that place is on
/// the edge at an end of a curve and the place before was not.
void note_edge(Run& run, const Path& path, double s, std::size_t contact,
               const std::array<BoundaryPlace, 2>& before);

/// Where the motion of group g cannot go on: the contact that is on the edge at an end of a curve; of
/// several, one that is at an end of the edge's normals.
[[nodiscard]] std::optional<ContactEnd> slipped_off(const Run& run, std::size_t g);

/// Replaces the curves of contacts by_boundary in run.local by curves that agree with their boundaries at the
/// row's contacts.
void set_local_curves(Run& run);

}  // namespace higherpair
