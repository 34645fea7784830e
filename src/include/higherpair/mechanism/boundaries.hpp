#pragma once

#include "higherpair/mechanism/description.hpp"

namespace higherpair {

/// Prepares the contacts in which a curve of several spans, or with ends, takes part, or several curves of a
/// body (NamedCurve::parts), and those that may part: both of their curves become boundaries, each contact's
/// own (further curves without a name; open ones end in edges, see with_edges, but for a contact of
/// both_sides), and the contact is marked as found by them. Nothing is done to other
/// contacts, nor twice. To be called before a mechanism is planned.
/// \pre no curve by its support that becomes a boundary has cusps
void use_boundaries(Mechanism& mechanism);

/// Whether use_boundaries() would prepare this contact.
[[nodiscard]] bool needs_boundaries(const Mechanism& mechanism, const Contact& contact);

}  // namespace higherpair
