#pragma once

#include "higherpair/mechanism/description.hpp"

#include <algorithm>
#include <vector>

namespace higherpair {

/// Prepares contacts that are found by boundaries: those in which one of the curves has several spans or
/// ends, or represents several curves of a body (NamedCurve::parts), and those that may separate. Both curves
/// of such a contact become boundaries of its own (added as unnamed curves; open ones end in edges, see
/// with_edges, except for a contact of both_sides), and the contact is marked accordingly. Other contacts are
/// left alone; a second call has no effect. To be called before a mechanism is planned.
/// \pre no curve given by its support function that becomes a boundary has cusps
void use_boundaries(Mechanism& mechanism);

/// Takes back what use_boundaries() has done to a description: contacts refer to the curves that their copies
/// were made of, the copies are dropped, and curves of several parts are not joined yet. Indices that refer
/// to nothing stay so.
void undo_boundaries(Mechanism& mechanism);

/// Whether use_boundaries() would prepare this contact.
[[nodiscard]] bool needs_boundaries(const Mechanism& mechanism, const Contact& contact);

/// Whether curve `index` of a body is curve `other`, or has it as a part.
[[nodiscard]] inline bool is_or_has(const std::vector<NamedCurve>& curves, int index, int other) {
  const std::vector<int>& parts = curves[static_cast<std::size_t>(index)].parts;
  return index == other || std::find(parts.begin(), parts.end(), other) != parts.end();
}

}  // namespace higherpair
