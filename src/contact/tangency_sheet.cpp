#include "tangency_sheet.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kSameLine = 1e-12;  // sine between two slides that are parallel

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
  // On the other side of a curve t and κ change their signs, so that only dp/dt does.
  place.along = place.corner ? 0 : side * point.speed;
  place.turn = place.corner ? 1 : point.kappa * point.speed;
  return place;
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
    return O12_.norm() > kSameLine * size_;
  }
  return pair_.motion1.turns || pair_.motion2.turns ||
         std::abs(cross(pair_.motion1.direction_W, pair_.motion2.direction_W)) > kSameLine;
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

// As n1 turns by δ, R(ψ) turns by δ; as n2 does, by -δ; R t2 = -t1.
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
    at.bend = one.corner && two.corner ? 0 : 1;
  } else {
    at.bend = one.turn / one.along + two.turn / two.along;
  }
  return at;
}

}  // namespace higherpair
