#pragma once

#include "arc_bounds.hpp"
#include "box_search.hpp"
#include "higherpair/contact/subdivision.hpp"

namespace higherpair {

/// What is the same for all pieces of two curves: the driver's place, and either opposed or equal normals.
struct Arrangement {
  const SupportCurve& curve1;
  const SupportCurve& curve2;
  bool turns = true;      ///< the follower
  double sigma = -1;      ///< -1: n2 = -n1; +1: n2 = n1
  Interval theta1;        ///< angle of the driver: φ = ψ1 + θ1
  Interval turn;          ///< ψ2 = ψ1 + turn, less q of a turning follower
  IntervalVector about1;  ///< follower's joint (at q = 0) in the driver's frame [m]
  IntervalVector about2;  ///< follower's joint in its own frame [m]
  IntervalVector slide1;  ///< sliding: direction in the driver's frame
};

/// A length that is typical of the pair: of each curve, the least sum of distance from the follower's joint
/// and radius of curvature that is met on a walk along it; the larger of the two.
[[nodiscard]] double size_of(const Arrangement& arrangement);

[[nodiscard]] Arrangement make_arrangement(const SupportPair& pair, double u, bool opposed);

/// A piece of each curve.
struct PiecePair {
  std::size_t first = 0;
  std::size_t second = 0;
};

/// Intervals of at most 45° that cover the normals of a piece, with common ends; all round for a closed
/// curve.
[[nodiscard]] std::vector<Interval> tiles_of(const SupportPiece& piece);
[[nodiscard]] std::vector<Interval> tiles_of(const Interval& psi);

/// F1 = H1 - σ H2 = 0, F2 = H1′ - σ H2′ = 0 in (ψ1, ψ2): two arcs, turning follower.
[[nodiscard]] BoxExpansion<2> expand_arcs(const Arrangement& a, const PiecePair& pieces, const Box<2>& X);

/// The same of two closed curves, in (ψ1, q), ψ2 = ψ1 + turn - q. With
///     ∂F1/∂ψ1 = F2,   ∂F2/∂ψ1 = ρ1 - σ ρ2 - F1,   ∂F1/∂q = σ H2′,   ∂F2/∂q = σ (ρ2 - H2)
/// the bounds do not grow with the lever, which turns both curves' normals alike: long levers with small
/// bodies need few boxes. (Next to the ends of an unbounded curve's normals the other form is the better
/// one.)
[[nodiscard]] BoxExpansion<2> expand_closed(const Arrangement& a, const PiecePair& pieces, const Box<2>& X);

/// H1 - σ H2 = 0 in the normal of the one piece that is not a face: turning follower.
[[nodiscard]] BoxExpansion<1> expand_face(const Arrangement& a, const PiecePair& pieces, bool face_is_first,
                                          const Box<1>& X);

/// B d·t - B′ d·n = 0 in ψ1, B = σ H2 - H1: two arcs, sliding follower. Its derivative is (ρ1 - σ ρ2) d·n.
/// \param turn  ψ2 - ψ1, with whole turns such that ψ2 falls on the piece
[[nodiscard]] BoxExpansion<1> expand_slide(const Arrangement& a, const PiecePair& pieces,
                                           const Interval& turn, const Box<1>& X);

/// Normals at which pieces may touch, and the follower's coordinate there.
struct PieceContact {
  PiecePair pieces;
  Interval psi1;
  Interval psi2;
  Interval q;
};

/// The follower's normal angle, or its turning coordinate if that is given instead: ψ1 + turn - x.
[[nodiscard]] Interval turning_partner(const Arrangement& a, const Interval& psi1, const Interval& x);

/// -(B d·n + B′ d·t) over an interval of normals: from its middle and the derivative (ρ1 - σ ρ2) d·t.
[[nodiscard]] Interval sliding_coordinate(const Arrangement& a, const PiecePair& pieces, const Interval& turn,
                                          const Interval& psi1);

/// -B/d·n, of a face; all numbers where d·n may be 0.
[[nodiscard]] Interval sliding_coordinate_of_face(const Arrangement& a, const PiecePair& pieces,
                                                  const Interval& psi1, const Interval& psi2);

/// The turning coordinate next to a root in doubles that makes the gap 0 for the normal given: errors of the
/// normal count by their squares only.
[[nodiscard]] double polished_turning_coordinate(const Arrangement& a, const PiecePair& pieces, double psi1,
                                                 double q);

/// Whether two normals may have supports that agree: H1 - σ H2 may be 0.
[[nodiscard]] bool may_touch(const Arrangement& a, const PiecePair& pieces, const Interval& psi1,
                             const Interval& psi2);

enum class Within { kNo, kUnclear, kYes };

/// Whether the common point lies between the ends of the faces, and q in the range.
[[nodiscard]] Within is_within(const Arrangement& a, const PieceContact& place, const Bounds& range);

}  // namespace higherpair
