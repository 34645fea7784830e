#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace higherpair {

/// Two curves given by their supports, of driver (1) and follower (2), and their joints to ground.
struct SupportPair {
  const SupportCurve& curve1;
  OneFreedom motion1;
  const SupportCurve& curve2;
  OneFreedom motion2;
};

struct SubdivisionOptions {
  /// Normals and turning coordinates are told apart down to this angle [rad], points of the curves down to
  /// this part of the pair's size, > 0. Where two contacts merge, rounding hides what is closer than 1e-8 or
  /// so.
  double tolerance = 1e-6;
  std::size_t max_boxes = 40000;  ///< boxes looked at, > 0: bounds the work
  /// The follower's coordinates of interest [m] where it slides; a turning one is looked for all round.
  Bounds range = {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
};

/// A position of the follower at which the curves are tangent. Proven: exactly one tangency exists with q in
/// `q_bounds` next to this normal; q in (-π, π] [rad], or a displacement [m].
struct CertifiedContact : TangentPosition {
  Bounds q_bounds;  ///< encloses it, for the given numbers; its width says how well the position is defined
  bool opposed = false;                ///< the outward normals are opposed: the bodies lie on different sides
  int branch = 0;                      ///< of an opposed contact: sign of ∂gap/∂q; else 0
  double rho1 = 0, rho2 = 0;           ///< radii of curvature [m]; of a face 0, without meaning
  std::size_t piece1 = 0, piece2 = 0;  ///< of the curves
};

/// What is not decided: none, one or several contacts with q and the angle φ of the normal n_W in these
/// bounds. So appear limit positions (two contacts merge), conforming contacts, curves that touch along a
/// stretch, contacts at a seam of two pieces.
struct PossibleContact {
  Bounds q;    ///< [rad or m]; turning: `low` in [-π, π]; sliding: ±infinity where nothing bounds it
  Bounds phi;  ///< [rad], at most a turn wide
  bool opposed = false;
  std::size_t piece1 = 0, piece2 = 0;  ///< of one of its boxes
  std::size_t boxes = 0;               ///< how many boxes of the search it consists of
};

enum class SubdivisionStatus {
  kComplete,   ///< `contacts` are all there are; `possible` is empty
  kUndecided,  ///< every other contact is in `possible`, whose boxes are as small as the tolerance
  kExhausted,  ///< the same, but max_boxes was too small to narrow them down to the tolerance
};

struct SubdivisionContacts {
  SubdivisionStatus status = SubdivisionStatus::kExhausted;
  std::vector<CertifiedContact> contacts;  ///< by rising q
  std::vector<PossibleContact> possible;   ///< by rising q.low
  std::size_t boxes = 0;                   ///< boxes looked at
};

/// All positions of the follower at which the curves are tangent, the driver being held at u; none is missed.
///
/// About the follower's joint, with H the supports and σ = -1 for opposed normals, +1 for equal ones, the gap
/// is
///     g = σ H2(ψ2) - H1(ψ1) + q d·n,       ψ the normal's angle in either body,
/// d = 0 for a turning follower, ψ2 = ψ1 + θ1 (+ π) - θ2 with the bodies' angles θ. g = ∂g/∂φ = 0 says,
/// turning: H1 = σ H2 and H1′ = σ H2′, in the unknowns ψ1 and q = θ2 for two closed curves, else ψ1 and ψ2;
/// sliding, q eliminated: B d·t = B′ d·n with B = σ H2 - H1, in ψ1. A face gives one ψ and one equation g =
/// 0. Boxes of the unknowns are halved until the equations are seen to have no root in them (interval
/// enclosures, Krawczyk's operator) or exactly one (the same operator), or until they are as small as the
/// tolerance. The rounding of every step, also of u and the joints, is inside the bounds. A corner (ρ = 0)
/// has all normals of its cone, so that at a point only opposed normals are taken. Cost: 1-2 µs a box, some
/// hundred boxes for two conics. \pre u and all numbers are finite; options.range.low <= options.range.high
[[nodiscard]] SubdivisionContacts find_contacts_by_subdivision(const SupportPair& pair, double u,
                                                               const SubdivisionOptions& options = {});

/// What encloses h, h′ and ρ over an interval of normals.
struct SupportBounds {
  Bounds h;
  Bounds dh;
  Bounds rho;
};

/// Bounds of a piece over at most a half turn of normals, rounded outwards: from h and h′ at the
/// middle and the bounds of ρ, h + h″ = ρ integrated. Their width beyond the change of h and h′ falls with
/// the square of the interval.
[[nodiscard]] SupportBounds bounds_over(const SupportCurve& curve, std::size_t piece, const Bounds& phi);

/// A conic, line or point as a curve by its support, its errors those of an evaluation in intervals. Of a
/// parabola or a branch of a hyperbola, on which h grows without bound towards the ends of the cone of
/// normals, the part is taken that is no farther across from its axis than `reach` [m], > 0: it holds every
/// point within that distance of the vertex. Beyond 1e5 semi-latera recta (for a narrow hyperbola: semi-axes
/// across) it ends in any case, since there angles of normals have too few digits left.
/// \pre curve.support is not set: that is such a curve
[[nodiscard]] std::unique_ptr<SupportCurve> make_support_curve(const Curve& curve, double reach);

/// The same for curves of any kind; of a curve by its support all pieces are looked at.
/// \param reach  of parabolas and hyperbolas, see make_support_curve [m]: contacts at points farther than
///   this from their vertices are not looked for
[[nodiscard]] SubdivisionContacts find_contacts_by_subdivision(const ContactPair& pair, double u,
                                                               double reach,
                                                               const SubdivisionOptions& options = {});

}  // namespace higherpair
