#pragma once

#include "box_search.hpp"
#include "higherpair/contact/subdivision.hpp"

namespace higherpair {

/// What is the same for all pieces of two curves: the driver's place, and either opposed or equal normals.
struct Arrangement {
  const SupportCurve& curve1;
  const SupportCurve& curve2;
  bool turns = true;      ///< the follower
  double sigma = -1;      ///< -1: n2 = -n1; +1: n2 = n1
  Interval theta1;        ///< angle of the driver
  Interval turn;          ///< φ + turn - ψ2 = q; sliding: ψ2 = ψ1 + turn
  IntervalVector about1;  ///< follower's joint (at q = 0) in the driver's frame [m]
  IntervalVector about2;  ///< follower's joint in its own frame [m]
  IntervalVector slide1;  ///< sliding: direction in the driver's frame
};

/// A length that is typical of the pair: of each curve, the least sum of distance from the follower's joint and
/// radius of curvature that is met on a walk along it; the larger of the two.
[[nodiscard]] double size_of(const Arrangement& arrangement);

[[nodiscard]] Arrangement make_arrangement(const SupportPair& pair, double u, bool opposed);

/// A piece of each curve.
struct PiecePair {
  std::size_t first = 0;
  std::size_t second = 0;
};

/// Intervals of at most 45° that cover the normals of a piece, with common ends; all round for a closed curve.
[[nodiscard]] std::vector<Interval> tiles_of(const SupportPiece& piece);
[[nodiscard]] std::vector<Interval> tiles_of(const Interval& psi);

/// H1 - σ H2 = 0, H1′ - σ H2′ = 0 in (ψ1, ψ2): two arcs, turning follower.
[[nodiscard]] Expansion<2> expand_arcs(const Arrangement& a, const PiecePair& pieces, const Box<2>& X);

/// H1 - σ H2 = 0 in the normal of the one piece that is not a face: turning follower.
[[nodiscard]] Expansion<1> expand_face(const Arrangement& a, const PiecePair& pieces, bool face_is_first,
                                       const Box<1>& X);

/// B d·t - B′ d·n = 0 in ψ1, B = σ H2 - H1: two arcs, sliding follower. Its derivative is (ρ1 - σ ρ2) d·n.
/// \param turn  ψ2 - ψ1, with whole turns such that ψ2 falls on the piece
[[nodiscard]] Expansion<1> expand_slide(const Arrangement& a, const PiecePair& pieces, const Interval& turn,
                                        const Box<1>& X);

/// Normals at which pieces may touch, and the follower's coordinate there.
struct Place {
  PiecePair pieces;
  Interval psi1;
  Interval psi2;
  Interval q;
};

/// φ (+ π) - ψ2
[[nodiscard]] Interval turning_coordinate(const Arrangement& a, const Interval& psi1, const Interval& psi2);

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

enum class Verdict { kNo, kUnclear, kYes };

/// Whether the common point lies between the ends of the faces, and q in the range.
[[nodiscard]] Verdict is_within(const Arrangement& a, const Place& place, const Bounds& range);

}  // namespace higherpair
