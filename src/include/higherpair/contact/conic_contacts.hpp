#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <string_view>
#include <vector>

namespace higherpair {

/// One position of the follower at which the two curves are tangent; its q lies in (-π, π], or is a
/// displacement [m].
struct CurveContact : TangentPosition {
  /// The outward normals are opposed: the bodies lie on different sides (always for a point).
  bool opposed = false;
  bool free = false;        ///< opposed, and the interiors of the two bodies are disjoint
  int branch = 0;           ///< of an opposed contact: sign of ∂gap/∂q, 0 at a limit
  bool at_limit = false;    ///< two contacts merge here: ∂gap/∂q = 0 to within rounding
  bool conforming = false;  ///< the curves have the same curvature here, to within rounding
  /// The two curves coincide here and touch everywhere; p is any of their points.
  bool coincident = false;
};

/// How far a list of contacts can be relied on.
enum class ContactsStatus {
  kComplete,           ///< the list holds every tangency
  kTouchesEverywhere,  ///< the distance of the curves does not depend on q, and they touch; the list is empty
  kTouchesNowhere,     ///< the distance does not depend on q, and they do not touch; the list is empty
  kTangentAtInfinity,  ///< hyperbolas that share an asymptote at every q: the condition decides nothing; no
                       ///< list
  kUndecided,  ///< curves given by support functions: there may be more contacts, where they nearly touch
  kNoPair,     ///< two lines or two points
};

struct CurveContacts {
  ContactsStatus status = ContactsStatus::kNoPair;
  std::vector<CurveContact> contacts;  ///< by rising q
};

/// All positions q of the follower at which its curve is tangent to the driver's, the driver being held at u.
///
/// The pencil λ Q1 + Q2(q) of two conics holds a tangency iff the cubic det(λ Q1 + Q2) has a double root: its
/// discriminant, a trigonometric polynomial of degree 8 in a turning q, a polynomial of degree 8 in a sliding
/// one, vanishes. A line and a conic touch where lᵀ adj(Q) l = 0, a point lies on a conic where pᵀQp = 0. The
/// roots are computed with 100 digits, and for each root within 1e-4 of a real position the contact point
/// (the kernel of λ₀Q1 + Q2) is determined; points that are complex, at infinity or on the other branch of a
/// hyperbola are dropped. The answer is therefore correct for the given doubles to their last digits, also
/// for contacts 1e-12 apart or levers a million times longer than the bodies; contacts that rounding of the
/// input can create or destroy are one entry with `at_limit` or `conforming` set.
/// Curves given by support functions are searched by subdivision instead (boundary_enumeration.hpp), as
/// chains of spans: κ1 + κ2 of either sign, opposed and equal normals.
/// Cost: some 10 ms (two conics); not meant for inner loops.
[[nodiscard]] CurveContacts find_curve_contacts(const ContactPair& pair, double u);

/// The same list as far as contacts are free. Some times faster for two convex conics whose contacts are not
/// close to each other: then roots to the precision of doubles are sufficient.
[[nodiscard]] CurveContacts find_free_contacts(const ContactPair& pair, double u);

/// The status as a sentence.
[[nodiscard]] std::string_view describe(ContactsStatus status);

}  // namespace higherpair
