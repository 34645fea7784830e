#pragma once

#include "higherpair/contact/conic_contacts.hpp"

namespace higherpair {

/// The same list as find_curve_contacts(), of curves that may be given by their supports, of which all pieces
/// count: by enumeration (boundary_enumeration.hpp) over chains of spans. Tangencies with equal normals are
/// those with the second curve turned inside out; at corners only opposed normals are taken. Undecided where
/// contacts merge, curves lie on each other, or one of them has cusps: then it bounds no body.
[[nodiscard]] CurveContacts list_support_contacts(const ContactPair& pair, double u);

}  // namespace higherpair
