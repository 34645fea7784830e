#include "contact_equations.hpp"

#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace higherpair {
namespace {

using boost::numeric::hull;
using boost::numeric::intersect;
using boost::numeric::median;
using boost::numeric::overlap;

// Of a sliding body angle and rotation are given, equal to within rounding: the bounds hold both.
Interval angle_of_body(const OneFreedom& motion, double q) {
  if (motion.turns) {
    return q;
  }
  const double from_rotation = nearest_turn(std::atan2(motion.R_WB.sin, motion.R_WB.cos), motion.theta);
  const double error = 4e-16 * (1 + std::abs(motion.theta));
  return hull(around(motion.theta, error), around(from_rotation, error));
}

// The vector in a frame that is turned by the angle.
IntervalVector in_frame(const Interval& angle, const IntervalVector& v) {
  const IntervalVector x_axis = unit_interval(angle);
  return {v.dot(x_axis), v.dot(x_axis.turned())};
}

// The normals of a piece that rounding may have carried over its ends.
Interval clamped(const SupportPiece& piece, const Interval& psi) {
  if (piece.kind == PieceKind::kClosed) {
    return psi;
  }
  return {std::clamp(psi.lower(), piece.phi.low, piece.phi.high),
          std::clamp(psi.upper(), piece.phi.low, piece.phi.high)};
}

const SupportPiece& first_piece(const Arrangement& a, const PiecePair& pieces) {
  return a.curve1.pieces()[pieces.first];
}

const SupportPiece& second_piece(const Arrangement& a, const PiecePair& pieces) {
  return a.curve2.pieces()[pieces.second];
}

ArcBounds first_over(const Arrangement& a, const PiecePair& pieces, const Interval& psi) {
  return arc_bounds(a.curve1, pieces.first, a.about1, clamped(first_piece(a, pieces), psi));
}

ArcBounds second_over(const Arrangement& a, const PiecePair& pieces, const Interval& psi) {
  return arc_bounds(a.curve2, pieces.second, a.about2, clamped(second_piece(a, pieces), psi));
}

// B, B′, ρ1 - σ ρ2 = -(B + B″), and the direction of the slide along n and t.
struct SlideTerms {
  Interval B;
  Interval dB;
  Interval rho;
  Interval c;
  Interval dc;

  [[nodiscard]] Interval equation() const { return B * dc - dB * c; }
};

SlideTerms slide_terms(const Arrangement& a, const PiecePair& pieces, const Interval& psi1,
                       const Interval& psi2) {
  const ArcBounds first = first_over(a, pieces, psi1);
  const ArcBounds second = second_over(a, pieces, psi2);
  const IntervalVector n = unit_interval(psi1);
  return {a.sigma * second.h - first.h, a.sigma * second.dh - first.dh, first.rho - a.sigma * second.rho,
          a.slide1.dot(n), a.slide1.dot(n.turned())};
}

Within is_between(const Interval& x, const Bounds& bounds) {
  if (x.upper() < bounds.low || x.lower() > bounds.high) {
    return Within::kNo;
  }
  return bounds.low <= x.lower() && x.upper() <= bounds.high ? Within::kYes : Within::kUnclear;
}

double size_of_curve(const SupportCurve& curve, const IntervalVector& about) {
  double size = kInf;
  for (std::size_t piece = 0; piece < curve.pieces().size(); ++piece) {
    for (const Interval& tile : tiles_of(curve.pieces()[piece])) {
      const ArcBounds at = arc_bounds(curve, piece, about, median(tile));
      const double distance = std::hypot(median(at.h), median(at.dh));
      size = std::min(size, distance + boost::numeric::norm(at.rho));
    }
  }
  return size;
}

}  // namespace

std::vector<Interval> tiles_of(const Interval& psi) {
  constexpr double kWidest = kPi / 4;
  const double low = psi.lower();
  const double width = psi.upper() - low;
  const long count = std::max(1L, std::lround(std::ceil(width / kWidest - 1e-9)));
  std::vector<Interval> tiles;
  double from = low;
  for (long k = 1; k <= count; ++k) {
    const double to =
        k == count ? psi.upper() : low + width * (static_cast<double>(k) / static_cast<double>(count));
    tiles.emplace_back(from, to);
    from = to;
  }
  return tiles;
}

std::vector<Interval> tiles_of(const SupportPiece& piece) {
  return tiles_of(piece.kind == PieceKind::kClosed ? Interval(-kPi, kPi + 1e-15) : to_interval(piece.phi));
}

double size_of(const Arrangement& a) {
  return std::max(size_of_curve(a.curve1, a.about1), size_of_curve(a.curve2, a.about2));
}

Arrangement make_arrangement(const SupportPair& pair, double u, bool opposed) {
  Arrangement a{pair.curve1, pair.curve2, pair.motion2.turns, opposed ? -1.0 : 1.0, {}, {}, {}, {}, {}};
  const OneFreedom& driver = pair.motion1;
  a.theta1 = angle_of_body(driver, u);
  IntervalVector joint1_W = exactly(driver.p_WO);
  if (!driver.turns) {
    joint1_W.x += Interval(u) * driver.direction_W.x();
    joint1_W.y += Interval(u) * driver.direction_W.y();
  }
  const IntervalVector joint2_1 = in_frame(a.theta1, exactly(pair.motion2.p_WO) - joint1_W);
  a.about1 = {joint2_1.x + driver.p_BO.x(), joint2_1.y + driver.p_BO.y()};
  a.about2 = exactly(pair.motion2.p_BO);
  a.turn = opposed ? half_turn() : Interval(0);
  a.turn += a.theta1;
  if (!a.turns) {
    a.turn -= angle_of_body(pair.motion2, 0);
    a.slide1 = in_frame(a.theta1, exactly(pair.motion2.direction_W));
  }
  return a;
}

Interval turning_partner(const Arrangement& a, const Interval& psi1, const Interval& x) {
  return psi1 + a.turn - x;
}

bool may_touch(const Arrangement& a, const PiecePair& pieces, const Interval& psi1, const Interval& psi2) {
  return holds_zero(first_over(a, pieces, psi1).h - a.sigma * second_over(a, pieces, psi2).h);
}

BoxExpansion<2> expand_arcs(const Arrangement& a, const PiecePair& pieces, const Box<2>& X) {
  const ArcBounds first = first_over(a, pieces, X[0]);
  const ArcBounds second = second_over(a, pieces, X[1]);
  BoxExpansion<2> e;
  e.center = {median(X[0]), median(X[1])};
  e.at_center = {first.middle_h - a.sigma * second.middle_h, first.middle_dh - a.sigma * second.middle_dh};
  e.range = {first.h - a.sigma * second.h, first.dh - a.sigma * second.dh};
  e.J[0] = {first.dh, -a.sigma * second.dh};
  e.J[1] = {first.rho - first.h, -a.sigma * (second.rho - second.h)};
  return e;
}

BoxExpansion<2> expand_closed(const Arrangement& a, const PiecePair& pieces, const Box<2>& X) {
  const ArcBounds first = first_over(a, pieces, X[0]);
  const ArcBounds second = second_over(a, pieces, turning_partner(a, X[0], X[1]));
  BoxExpansion<2> e;
  e.center = {median(X[0]), median(X[1])};
  const ArcBounds second_m = second_over(a, pieces, turning_partner(a, e.center[0], e.center[1]));
  e.at_center = {first.middle_h - a.sigma * second_m.h, first.middle_dh - a.sigma * second_m.dh};
  e.range = {first.h - a.sigma * second.h, first.dh - a.sigma * second.dh};
  const Interval rho = first.rho - a.sigma * second.rho;
  e.J[0][1] = a.sigma * second.dh;
  e.J[1][1] = a.sigma * (second.rho - second.h);
  // Each of F1 and F2 is in the derivative of the other: closer bounds make closer bounds.
  for (int pass = 0; pass < 3; ++pass) {
    e.J[0][0] = e.range[1];
    e.J[1][0] = rho - e.range[0];
    for (std::size_t i = 0; i < 2; ++i) {
      const Interval mean =
          e.at_center[i] + e.J[i][0] * (X[0] - e.center[0]) + e.J[i][1] * (X[1] - e.center[1]);
      e.range[i] = overlap(mean, e.range[i]) ? intersect(mean, e.range[i]) : e.range[i];
    }
  }
  return e;
}

BoxExpansion<1> expand_face(const Arrangement& a, const PiecePair& pieces, bool face_is_first,
                            const Box<1>& X) {
  const Interval face = to_interval((face_is_first ? first_piece(a, pieces) : second_piece(a, pieces)).phi);
  const ArcBounds first = first_over(a, pieces, face_is_first ? face : X[0]);
  const ArcBounds second = second_over(a, pieces, face_is_first ? X[0] : face);
  BoxExpansion<1> e;
  e.range = {first.h - a.sigma * second.h};
  e.center = {median(X[0])};
  e.at_center = {face_is_first ? first.h - a.sigma * second.middle_h : first.middle_h - a.sigma * second.h};
  e.J[0] = {face_is_first ? -a.sigma * second.dh : first.dh};
  return e;
}

BoxExpansion<1> expand_slide(const Arrangement& a, const PiecePair& pieces, const Interval& turn,
                             const Box<1>& X) {
  const SlideTerms all = slide_terms(a, pieces, X[0], X[0] + turn);
  const Interval m = median(X[0]);
  BoxExpansion<1> e;
  e.center = {m.lower()};
  e.range = {all.equation()};
  e.at_center = {slide_terms(a, pieces, m, m + turn).equation()};
  e.J[0] = {all.rho * all.c};
  return e;
}

Interval sliding_coordinate(const Arrangement& a, const PiecePair& pieces, const Interval& turn,
                            const Interval& psi1) {
  const Interval m = median(psi1);
  const SlideTerms all = slide_terms(a, pieces, psi1, psi1 + turn);
  const SlideTerms middle = slide_terms(a, pieces, m, m + turn);
  return -(middle.B * middle.c + middle.dB * middle.dc) + all.rho * all.dc * (psi1 - m);
}

Interval sliding_coordinate_of_face(const Arrangement& a, const PiecePair& pieces, const Interval& psi1,
                                    const Interval& psi2) {
  const SlideTerms s = slide_terms(a, pieces, psi1, psi2);
  return holds_zero(s.c) ? Interval(-kInf, kInf) : -s.B / s.c;
}

double polished_turning_coordinate(const Arrangement& a, const PiecePair& pieces, double psi1, double q) {
  const Interval psi2 = turning_partner(a, psi1, q);
  const ArcBounds first = first_over(a, pieces, psi1);
  const ArcBounds second = second_over(a, pieces, psi2);
  const double gap = median(a.sigma * second.middle_h - first.middle_h);
  const double slope = -a.sigma * median(second.middle_dh);
  return slope == 0 ? q : q - gap / slope;
}

Within is_within(const Arrangement& a, const PieceContact& place, const Bounds& range) {
  Within within = a.turns ? Within::kYes : is_between(place.q, range);
  const SupportPiece& piece1 = first_piece(a, place.pieces);
  const SupportPiece& piece2 = second_piece(a, place.pieces);
  const IntervalVector t = unit_interval(place.psi1).turned();
  const Interval moved = a.turns ? Interval(0) : place.q * a.slide1.dot(t);
  if (piece1.kind == PieceKind::kFace && piece2.kind != PieceKind::kFace) {
    const Interval along = a.about1.dot(t) + a.sigma * second_over(a, place.pieces, place.psi2).dh + moved;
    within = std::min(within, is_between(along, piece1.along));
  }
  if (piece2.kind == PieceKind::kFace && piece1.kind != PieceKind::kFace) {
    const IntervalVector t2 = unit_interval(place.psi2).turned();
    const Interval along = a.about2.dot(t2) + a.sigma * (first_over(a, place.pieces, place.psi1).dh - moved);
    within = std::min(within, is_between(along, piece2.along));
  }
  return within;
}

}  // namespace higherpair
