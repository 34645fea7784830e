#include "tangency_sheet.hpp"

#include "higherpair/contact/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

// The rotation of one unit vector into another.
Rotation<double> rotation_between(const Vector2d& from, const Vector2d& to) {
  return Rotation<double>{from.dot(to), cross(from, to)}.normalised();
}

double angle(const Rotation<double>& R) {
  return std::atan2(R.sin, R.cos);
}

SheetPlace place_at(const Boundary& boundary, const BoundaryPlace& at, const Pose<double>& X_WB,
                    double side) {
  const SpanPoint point = boundary.at(at);
  SheetPlace place;
  place.corner = boundary.is_corner(at);
  place.p_W = X_WB * point.p_B;
  place.n_W = side * (X_WB.R_WB * point.n_B);
  // With the normal reversed, t is reversed too: `along` changes its sign, the rate of the normal's angle
  // does not.
  place.along = place.corner ? 0 : side * point.speed;
  place.turn = place.corner ? 1 : point.kappa * point.speed;
  return place;
}

SpanBounds bounds_by_samples(const Span& span, const Bounds& t) {
  const SpanPoint a = span.at(t.low);
  const SpanPoint m = span.at(t.low + t.width() / 2);
  const SpanPoint b = span.at(t.high);
  const auto speed = std::minmax({a.speed, m.speed, b.speed});
  const auto turn = std::minmax({a.kappa * a.speed, m.kappa * m.speed, b.kappa * b.speed});
  return {{speed.first, speed.second}, {turn.first, turn.second}};
}

SheetStretch stretch_at(const Boundary& boundary, int span, const Bounds& t, const Pose<double>& X_WB,
                        double side) {
  const Span& curve = *boundary.spans()[span];
  const auto proven = curve.bounds(t);
  const SpanBounds bounds = proven ? *proven : bounds_by_samples(curve, t);
  const auto largest = [](const Bounds& b) { return std::max(std::abs(b.low), std::abs(b.high)); };
  SheetStretch stretch;
  stretch.middle = place_at(boundary, {span, t.low + t.width() / 2}, X_WB, side);
  stretch.half = t.width() / 2;
  stretch.reach = stretch.half * largest(bounds.speed);
  stretch.tilt = stretch.half * largest(bounds.turn);
  stretch.along = side > 0 ? bounds.speed : -bounds.speed;
  stretch.turn = bounds.turn;
  return stretch;
}

// All numbers or vectors within a radius of one.
template <class T>
struct Around {
  T middle;
  double radius = 0;
};

Around<double> around(const Bounds& a) {
  return {a.low + a.width() / 2, a.width() / 2};
}

Around<double> dot(const Around<Vector2d>& a, const Around<Vector2d>& b) {
  return {a.middle.dot(b.middle), a.middle.norm() * b.radius + a.radius * (b.middle.norm() + b.radius)};
}

Around<double> operator*(const Around<double>& a, const Around<double>& b) {
  return {a.middle * b.middle, std::abs(a.middle) * b.radius + a.radius * (std::abs(b.middle) + b.radius)};
}

Around<double> operator-(const Around<double>& a, const Around<double>& b) {
  return {a.middle - b.middle, a.radius + b.radius};
}

Around<Vector2d> normal_to(const Around<Vector2d>& a) {
  return {higherpair::perp(a.middle), a.radius};
}

// The largest distance by which a unit vector moves when it turns by an angle.
double chord_of(double turn) {
  return std::min(turn, 2.0);
}

// The vectors turned by R and by at most `turn` more to either side.
Around<Vector2d> turned(const Rotation<double>& R, const Around<Vector2d>& a, double turn) {
  return {R * a.middle, a.radius + a.middle.norm() * chord_of(turn)};
}

// turn·m - along·n over a stretch of a body that turns, m being its points from the pivot: `turn` times the
// vector from there to the centre of curvature, which is constant along an arc.
Around<Vector2d> turned_center(const SheetStretch& stretch, const Vector2d& m) {
  const Around<double> along = around(stretch.along);
  const Around<double> turn = around(stretch.turn);
  return {turn.middle * m - along.middle * stretch.middle.n_W,
          turn.radius * (m.norm() + stretch.reach) + along.radius +
              stretch.half * (std::abs(turn.middle) * along.radius + std::abs(along.middle) * turn.radius)};
}

// What is known about a function with these slopes that has this value at the middle of both stretches, and
// differs from it by at most `reach`.
SheetRange range_of(const SheetStretch& one, const SheetStretch& two, const Around<double>& slope1,
                    const Around<double>& slope2, double value, double reach) {
  const auto largest = [](const Around<double>& a) { return std::abs(a.middle) + a.radius; };
  const auto sign = [](const Around<double>& a) {
    return a.middle > a.radius ? 1 : a.middle < -a.radius ? -1 : 0;
  };
  const double change = one.half * largest(slope1) + two.half * largest(slope2);
  return {std::abs(value) <= std::min(reach, change), sign(slope1), sign(slope2)};
}

}  // namespace

TangencySheet::TangencySheet(const BoundaryPair& pair, bool opposed)
    : pair_(pair),
      side2_(opposed ? 1 : -1),
      X_W1_(pose_at(pair.motion1, 0)),
      X_W2_(pose_at(pair.motion2, 0)),
      O12_(pair.motion2.p_WO - pair.motion1.p_WO) {
  const auto reach = [](const Boundary& boundary, const OneFreedom& motion) {
    return boundary.size() + (motion.turns ? (boundary.middle_B() - motion.p_BO).norm() : 0);
  };
  size_ = std::min(reach(*pair.boundary1, pair.motion1), reach(*pair.boundary2, pair.motion2)) +
          (pair.motion1.turns && pair.motion2.turns ? O12_.norm() : 0);
  size_ = size_ > 0 ? size_ : std::max(pair.boundary1->size(), pair.boundary2->size());
}

bool TangencySheet::is_regular() const {
  if (pair_.motion1.turns && pair_.motion2.turns) {
    return O12_.norm() > kParallelSlides * size_;
  }
  return pair_.motion1.turns || pair_.motion2.turns ||
         std::abs(cross(pair_.motion1.direction_W, pair_.motion2.direction_W)) > kParallelSlides;
}

SheetPlace TangencySheet::place1(const BoundaryPlace& at) const {
  return place_at(*pair_.boundary1, at, X_W1_, 1);
}

SheetPlace TangencySheet::place2(const BoundaryPlace& at) const {
  return place_at(*pair_.boundary2, at, X_W2_, side2_);
}

double TangencySheet::value(const SheetPlace& one, const SheetPlace& two) const {
  const Vector2d& O1 = pair_.motion1.p_WO;
  const Vector2d& O2 = pair_.motion2.p_WO;
  if (pair_.motion1.turns && pair_.motion2.turns) {
    const double d = O12_.norm();
    const double w = (one.p_W - O1 - rotation_between(two.n_W, -one.n_W) * (two.p_W - O2)).norm();
    return (w - d) * (w + d) / (2 * d);
  }
  if (pair_.motion1.turns) {
    const Vector2d p = O1 + rotation_between(one.n_W, -two.n_W) * (one.p_W - O1);
    return (p - two.p_W).dot(perp(pair_.motion2.direction_W));
  }
  if (pair_.motion2.turns) {
    const Vector2d p = O2 + rotation_between(two.n_W, -one.n_W) * (two.p_W - O2);
    return (p - one.p_W).dot(perp(pair_.motion1.direction_W));
  }
  return cross(one.n_W, two.n_W) * size_;
}

// When n1 turns by δ, R(ψ) turns by δ; when n2 does, by -δ; R t2 = -t1.
Vector2d TangencySheet::slopes(const SheetPlace& one, const SheetPlace& two) const {
  const Vector2d& O1 = pair_.motion1.p_WO;
  const Vector2d& O2 = pair_.motion2.p_WO;
  const Vector2d t1 = perp(one.n_W);
  const Vector2d t2 = perp(two.n_W);
  if (pair_.motion1.turns && pair_.motion2.turns) {
    const Vector2d Rm2 = rotation_between(two.n_W, -one.n_W) * (two.p_W - O2);
    const Vector2d w = (one.p_W - O1 - Rm2) / O12_.norm();
    return {w.dot(one.along * t1 - one.turn * perp(Rm2)), w.dot(two.along * t1 + two.turn * perp(Rm2))};
  }
  if (pair_.motion1.turns) {
    const Vector2d Rm1 = rotation_between(one.n_W, -two.n_W) * (one.p_W - O1);
    const Vector2d across = perp(pair_.motion2.direction_W);
    return {-across.dot(one.along * t2 + one.turn * perp(Rm1)),
            across.dot(two.turn * perp(Rm1) - two.along * t2)};
  }
  if (pair_.motion2.turns) {
    const Vector2d Rm2 = rotation_between(two.n_W, -one.n_W) * (two.p_W - O2);
    const Vector2d across = perp(pair_.motion1.direction_W);
    return {across.dot(one.turn * perp(Rm2) - one.along * t1),
            -across.dot(two.along * t1 + two.turn * perp(Rm2))};
  }
  return {size_ * one.turn * cross(t1, two.n_W), size_ * two.turn * cross(one.n_W, t2)};
}

SheetStretch TangencySheet::stretch1(int span, const Bounds& t) const {
  return stretch_at(*pair_.boundary1, span, t, X_W1_, 1);
}

SheetStretch TangencySheet::stretch2(int span, const Bounds& t) const {
  return stretch_at(*pair_.boundary2, span, t, X_W2_, side2_);
}

// With e = turn·m - along·n of a turning body (m from its pivot) the slopes are e1·w⊥ and w·(R e2)⊥, w in
// units of O1O2, for two pivots, and -d⊥·(R e)⊥ for the turning body of a pair with a slide.
SheetRange TangencySheet::range(const SheetStretch& one, const SheetStretch& two, double level) const {
  const SheetPlace& p1 = one.middle;
  const SheetPlace& p2 = two.middle;
  const double above = value(p1, p2) - level;
  const double turn = one.tilt + two.tilt;
  if (pair_.motion1.turns && pair_.motion2.turns) {
    const Vector2d m1 = p1.p_W - pair_.motion1.p_WO;
    const Vector2d m2 = p2.p_W - pair_.motion2.p_WO;
    const double d = O12_.norm();
    const Rotation<double> R = rotation_between(p2.n_W, -p1.n_W);
    const Vector2d Rm2 = R * m2;
    const double off = one.reach + two.reach + m2.norm() * chord_of(turn);
    const Around<Vector2d> w{(m1 - Rm2) / d, off / d};
    const double reach = off * (w.middle.norm() + w.radius / 2);
    return range_of(one, two, dot(turned_center(one, m1), normal_to(w)),
                    dot(w, normal_to(turned(R, turned_center(two, m2), turn))), above, reach);
  }
  if (pair_.motion1.turns || pair_.motion2.turns) {
    const bool first = pair_.motion1.turns;
    const SheetStretch& turning = first ? one : two;
    const SheetStretch& sliding = first ? two : one;
    const Vector2d m = turning.middle.p_W - (first ? pair_.motion1 : pair_.motion2).p_WO;
    const Rotation<double> R = rotation_between(turning.middle.n_W, -sliding.middle.n_W);
    const Around<Vector2d> across{perp((first ? pair_.motion2 : pair_.motion1).direction_W), 0};
    const Around<Vector2d> Rm{R * m, turning.reach + m.norm() * chord_of(turn)};
    const Around<Vector2d> t{perp(sliding.middle.n_W), chord_of(sliding.tilt)};
    const Around<double> of_turning =
        dot(Around<Vector2d>{-across.middle, 0}, normal_to(turned(R, turned_center(turning, m), turn)));
    const Around<double> of_sliding =
        around(sliding.turn) * dot(across, normal_to(Rm)) - around(sliding.along) * dot(across, t);
    return range_of(one, two, first ? of_turning : of_sliding, first ? of_sliding : of_turning, above,
                    Rm.radius + sliding.reach);
  }
  // Zeros with the normals the other way are not tangencies.
  const double apart = std::abs(angle(rotation_between(p1.n_W, -p2.n_W)));
  const Around<double> cosine{size_ * std::cos(apart), size_ * chord_of(turn)};
  const Around<double> none{0, 0};
  SheetRange range = range_of(one, two, around(one.turn) * cosine, none - around(two.turn) * cosine, above,
                              size_ * chord_of(turn));
  range.zero = range.zero && apart <= kPi / 2 + turn;
  return range;
}

bool TangencySheet::faces(const SheetPlace& one, const SheetPlace& two) const {
  return pair_.motion1.turns || pair_.motion2.turns || one.n_W.dot(two.n_W) < 0;
}

SheetPoint TangencySheet::point(const SheetPlace& one, const SheetPlace& two) const {
  const OneFreedom& motion1 = pair_.motion1;
  const OneFreedom& motion2 = pair_.motion2;
  SheetPoint at;
  at.n_W = one.n_W;
  if (motion1.turns && motion2.turns) {
    const Rotation<double> R = rotation_between(two.n_W, -one.n_W);
    const Vector2d w = one.p_W - motion1.p_WO - R * (two.p_W - motion2.p_WO);
    const Rotation<double> turn = rotation_between(w.normalized(), O12_.normalized());
    at.u = angle(turn);
    at.q = at.u + angle(R);
    at.n_W = turn * one.n_W;
    at.p_W = motion1.p_WO + turn * (one.p_W - motion1.p_WO);
  } else if (motion1.turns) {
    const Rotation<double> turn = rotation_between(one.n_W, -two.n_W);
    at.u = angle(turn);
    at.n_W = -two.n_W;
    at.p_W = motion1.p_WO + turn * (one.p_W - motion1.p_WO);
    at.q = (at.p_W - two.p_W).dot(motion2.direction_W);
  } else if (motion2.turns) {
    const Rotation<double> turn = rotation_between(two.n_W, -one.n_W);
    at.q = angle(turn);
    at.p_W = motion2.p_WO + turn * (two.p_W - motion2.p_WO);
    at.u = (at.p_W - one.p_W).dot(motion1.direction_W);
  } else {
    const Vector2d apart = two.p_W - one.p_W;
    const double det = cross(motion1.direction_W, motion2.direction_W);
    at.u = cross(apart, motion2.direction_W) / det;
    at.q = cross(apart, motion1.direction_W) / det;
    at.p_W = one.p_W + at.u * motion1.direction_W;
  }
  at.gap_q = at.n_W.dot(velocity_per_q(motion2, at.p_W));
  at.gap_u = at.n_W.dot(velocity_per_q(motion1, at.p_W));
  if (one.corner || two.corner) {
    at.curvature_sum = one.corner && two.corner ? 0 : 1;
  } else {
    at.curvature_sum = one.turn / one.along + two.turn / two.along;
  }
  return at;
}

}  // namespace higherpair
