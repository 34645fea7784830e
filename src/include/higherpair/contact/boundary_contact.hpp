#pragma once

#include "higherpair/contact/contact_pair.hpp"
#include "higherpair/geometry/boundary.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace higherpair {

/// Two boundaries that touch, each on a body with one freedom against ground; coordinates u and q.
struct BoundaryPair {
  const Boundary* boundary1 = nullptr;
  OneFreedom motion1;
  const Boundary* boundary2 = nullptr;
  OneFreedom motion2;
};

/// Where two boundaries touch.
struct BoundaryContact {
  CommonNormal at;  ///< ρ: +∞ on a face, 0 at a corner
  double q = 0;     ///< follower's coordinate [rad or m]
  BoundaryPlace place1, place2;
  double gap_q = 0;  ///< ∂gap/∂q = n·(velocity of body 2 at p per q)
};

struct BoundaryResult {
  ContactStatus status = ContactStatus::kNotConverged;
  BoundaryContact contact;  ///< with kOk, kOtherBranch
};

/// The equivalent link of a contact, from its radii; +∞ means flat.
[[nodiscard]] inline EquivalentLink link_at(const CommonNormal& at) {
  return equivalent_link(std::isinf(at.rho1), at.rho1, std::isinf(at.rho2), at.rho2);
}

/// The contact near a guess, by Newton's method in the follower's coordinate and the places along both
/// boundaries. With t = n turned +90°, ε the angle from n1 to -n2, g and σ the parts of p2 - p1 along n and
/// t, c the velocity per q at p2 and ω = 1 for a turning follower, else 0:
///     δq = -g/c·n,   E = ε + ω δq,   Σ = σ + c·t δq,
///     δs1 = z E + w2 Σ,   δs2 = z E - w1 Σ     (both along t),
/// the equivalent link's own equations, finite for faces and corners. Steps continue across joints of spans.
/// Unlike an iteration in the normal's angle it passes inflections without trouble.
/// \param branch  sign of ∂gap/∂q wanted; 0: either
[[nodiscard]] BoundaryResult solve_boundary_contact(const BoundaryPair& pair, double u, double q,
                                                    const BoundaryPlace& place1, const BoundaryPlace& place2,
                                                    int branch);

/// Places along both boundaries with a common normal near a guess, the bodies held at their poses; the gap is
/// that of the result. None where the iteration finds none or is stopped by an end.
[[nodiscard]] std::optional<BoundaryContact> find_boundary_normal(
    const Boundary& boundary1, const Pose<double>& X_W1, const Boundary& boundary2, const Pose<double>& X_W2,
    const BoundaryPlace& place1, const BoundaryPlace& place2);

/// Every contact with opposed normals and κ1 + κ2 > 0, by rising q (turning: in (-π, π]). With the supports h
/// = p·n and h′ = p·t about the follower's pivot, a contact is a common point of the plane curves (h1, h1′)
/// and (-h2, -h2′); for a follower that slides along d, of the curves (angle of n, p·d⊥) of both. Crossings
/// of their polylines are refined by Newton's method: two contacts closer than the samples of the boundaries
/// may be missed.
[[nodiscard]] std::vector<BoundaryContact> find_boundary_contacts(const BoundaryPair& pair, double u);

/// The place with the given outward normal, by Newton's method from another place; none where an end or a
/// face is in between, or no place near has this normal.
[[nodiscard]] std::optional<BoundaryPlace> place_with_normal(const Boundary& boundary,
                                                             const BoundaryPlace& from, const Vector2d& n_B);

/// The places of both boundaries that face each other best: close, with normals opposed. Between neighbouring
/// samples points and normals are interpolated.
[[nodiscard]] std::array<BoundaryPlace, 2> nearest_places(const Boundary& boundary1, const Pose<double>& X_W1,
                                                          const Boundary& boundary2,
                                                          const Pose<double>& X_W2);

/// Depth of overlap of two bodies [m], near the deepest of the samples of their outlines and of points
/// between their crossings; 0 where the overlap is within `tolerance`.
[[nodiscard]] double deepest_penetration(const Boundary& boundary1, const Pose<double>& X_W1,
                                         const Boundary& boundary2, const Pose<double>& X_W2,
                                         double tolerance);

/// Whether the depth of overlap exceeds `tolerance` [m]. Looks first where the outlines cross: if the bodies
/// overlap widely it is much faster than deepest_penetration().
[[nodiscard]] bool bodies_overlap(const Boundary& boundary1, const Pose<double>& X_W1,
                                  const Boundary& boundary2, const Pose<double>& X_W2, double tolerance);

}  // namespace higherpair
