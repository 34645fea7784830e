#pragma once

#include "higherpair/contact/boundary_contact.hpp"

namespace higherpair {

/// Every contact of two boundaries, and where completeness is not proven.
struct BoundaryContacts {
  /// As from find_boundary_contacts(), including those that are very close together.
  std::vector<BoundaryContact> contacts;
  /// Where further contacts may be [rad, within (-2π, 2π), or m], rising and disjoint: at limit positions,
  /// where contacts merge; where curves coincide along a stretch, or two corners meet. Empty: `contacts` is
  /// complete.
  std::vector<Bounds> undecided;
  bool has_bounds = true;  ///< false: a span gives no bounds, and nothing is proven
};

struct TangencySearch {
  /// Also contacts with κ1 + κ2 < 0, at which the bodies intersect; two contacts are merged only if proven to
  /// be one.
  bool every = false;
  double error = 0;  ///< how far points may be from their true positions, beyond rounding [m]
};

/// All contacts of opposed normals and κ1 + κ2 > 0, the driver being held at u. Common points of the plane
/// curves of find_boundary_contacts() are enclosed: over an interval of its parameter the normal's angle and
/// the point of a span follow from those at its middle and the bounds of dφ/dt and ds/dt, and with n, t and
/// p about the follower's pivot
///     dh = h′ dφ,   dh′ = ds - h dφ,   d(p·d⊥) = t·d⊥ ds.
/// Pairs of intervals are halved until the two curves are shown to be apart on them, or Newton's method finds
/// a contact around which the determinant of the two tangents has one sign, also on both sides of a joint of
/// spans: it is then the only one there. Points and normals are taken to be accurate to 8 units in the last
/// place of the size. Cost: about 1 µs per interval, some hundred intervals for two smooth curves.
[[nodiscard]] BoundaryContacts enumerate_boundary_contacts(const BoundaryPair& pair, double u,
                                                           const TangencySearch& search = {});

}  // namespace higherpair
