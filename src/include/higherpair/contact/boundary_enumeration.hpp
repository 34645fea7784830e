#pragma once

#include "higherpair/contact/boundary_contact.hpp"

namespace higherpair {

/// Every contact of two boundaries, and what is not proven.
struct BoundaryContacts {
  std::vector<BoundaryContact> contacts;  ///< as of find_boundary_contacts(), also those nearer to each other
  /// Where further contacts may be [rad, within (-2π, 2π), or m], rising and apart: at limit positions, where
  /// contacts merge; where curves lie on each other along a stretch, or two corners do. None: `contacts` are
  /// all there are.
  std::vector<Bounds> undecided;
  bool has_bounds = true;  ///< false: a span gives no bounds, and nothing is proven
};

struct TangencySearch {
  /// Those with κ1 + κ2 < 0 too, at which the bodies cut each other; only what is proven to be one contact.
  bool every = false;
  double error = 0;  ///< how far points may be from the truth, beyond rounding [m]
};

/// All contacts of opposed normals and κ1 + κ2 > 0, the driver being held at u. Common points of the plane
/// curves of find_boundary_contacts() are enclosed: over an interval of its parameter the normal's angle and
/// the point of a span follow from those at its middle and the bounds of dφ/dt and ds/dt, and with n, t and
/// p about the follower's pivot
///     dh = h′ dφ,   dh′ = ds - h dφ,   d(p·d⊥) = t·d⊥ ds.
/// Pairs of intervals are halved until the two curves are seen to be apart on them, or a contact is found by
/// Newton's method around which the determinant of the two tangents has one sign, on both sides of a joint of
/// spans too: there it is the only one. Points and normals are taken to be right to 8 units in the last
/// place of the size. Cost: about 1 µs an interval, some hundred for two smooth curves.
[[nodiscard]] BoundaryContacts enumerate_boundary_contacts(const BoundaryPair& pair, double u,
                                                           const TangencySearch& search = {});

}  // namespace higherpair
