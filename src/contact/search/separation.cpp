#include "higherpair/contact/separation.hpp"

#include "common_normals.hpp"
#include "higherpair/contact/least_gaps.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace higherpair {
namespace {

constexpr int kMaxArcs = 20000;
constexpr int kMaxArcsInRing = 100;  // many more would be needed where body and ring conform

// F is g for two convex bodies, -g for a body in a ring, so that a maximum of F is wanted in both cases.
struct Value {
  double f = 0;
  double slope = 0;
  double rho_sum = 0;
};

struct GapProblem {
  PlacedCurve<double> first;
  PlacedCurve<double> second;
  double sign = 1;  // F = sign g
};

Value value_at(const GapProblem& problem, const Vector2d& n) {
  const Vector2d inward = -n;
  const SupportPoint<double> s1 = support_point(problem.first, n);
  const SupportPoint<double> s2 = support_point(problem.second, inward);
  const Vector2d d = s2.p_W - s1.p_W;
  return {problem.sign * d.dot(n), problem.sign * d.dot(perp(n)), s1.rho + s2.rho};
}

// A bound R >= -sign (ρ1 + ρ2) for all normals within `half` of n.
double curvature_bound(const GapProblem& problem, const Vector2d& n, const Rotation<double>& half) {
  const Bounds rho1 = radius_bounds(problem.first, n, half);
  const Bounds rho2 = radius_bounds(problem.second, -n, half);
  return problem.sign > 0 ? -(rho1.low + rho2.low) : rho1.high + rho2.high;
}

struct ArcPiece {
  NormalArc arc;
  Value value;
  double bound = kInf;

  bool operator<(const ArcPiece& other) const { return bound < other.bound; }
};

double bound_of(const Value& value, const Rotation<double>& half, double R) {
  if (!std::isfinite(R)) {
    return kInf;
  }
  const double a = value.f - R;
  const double b = std::abs(value.slope);
  // R + √(a² + b²) or R + a cos + b sin, rearranged to avoid cancellation for a huge R.
  if (b * half.cos <= a * half.sin) {
    return a > 0 ? value.f + b * b / (std::sqrt(a * a + b * b) + a) : R;
  }
  const double versine = half.sin * half.sin / (1 + half.cos);
  return value.f - a * versine + b * half.sin;
}

ArcPiece make_piece(const GapProblem& problem, const NormalArc& arc) {
  const Vector2d n = unit_vector(arc.middle);
  const auto half = Rotation<double>::from_angle(arc.half);
  ArcPiece piece{arc, value_at(problem, n), kInf};
  piece.bound = bound_of(piece.value, half, curvature_bound(problem, n, half));
  return piece;
}

// A value of the problem, at the normal with this angle.
struct Height {
  double phi = 0;
  double f = 0;
};

// A few Newton steps uphill; returns the best value.
Height climb(const GapProblem& problem, const NormalArc& within, double phi, Value value) {
  Height best{phi, value.f};
  for (int i = 0; i < 6; ++i) {
    const double second = -problem.sign * value.rho_sum - value.f;
    if (!(second < 0)) {
      break;
    }
    phi -= value.slope / second;
    if (!(std::abs(phi - within.middle) < within.half)) {
      break;
    }
    value = value_at(problem, unit_vector(phi));
    if (!(value.f > best.f)) {
      break;
    }
    best = {phi, value.f};
  }
  return best;
}

struct Maximum {
  Height best;
  bool is_within = false;  // the tolerance
};

Maximum maximum(const GapProblem& problem, const NormalArc& domain, double tolerance, int max_arcs) {
  std::vector<ArcPiece> heap;
  Height best{domain.middle, -kInf};
  const auto add = [&](const NormalArc& arc) {
    const ArcPiece piece = make_piece(problem, arc);
    if (piece.value.f > best.f) {
      best = climb(problem, domain, arc.middle, piece.value);
    }
    heap.push_back(piece);
    std::push_heap(heap.begin(), heap.end());
  };
  constexpr int kStart = 8;
  for (int i = 0; i < kStart; ++i) {
    add({domain.middle + domain.half * ((2 * i + 1.0) / kStart - 1), domain.half / kStart});
  }
  const auto is_within = [&] { return heap.empty() || heap.front().bound <= best.f + tolerance; };
  for (int arcs = 0; !is_within() && arcs < max_arcs; ++arcs) {
    std::pop_heap(heap.begin(), heap.end());
    const NormalArc arc = heap.back().arc;
    heap.pop_back();
    if (arc.half < kFinestArc) {
      continue;
    }
    add({arc.middle - arc.half / 2, arc.half / 2});
    add({arc.middle + arc.half / 2, arc.half / 2});
  }
  return {best, is_within()};
}

// Discs and points: along the line of centres.
std::optional<Separation> between_discs(const Curve& curve1, const Pose<double>& X_W1, const Curve& curve2,
                                        const Pose<double>& X_W2) {
  const auto center1 = round_center(curve1);
  const auto center2 = round_center(curve2);
  if (!center1 || !center2 || curve1.side != Side::kInside || curve2.side != Side::kInside) {
    return std::nullopt;
  }
  const Vector2d apart = X_W2 * *center2 - X_W1 * *center1;
  const double distance = apart.norm();
  const Vector2d n_W = distance > 0 ? Vector2d(apart / distance) : Vector2d::UnitX();
  return Separation{distance - curve1.semi_latus - curve2.semi_latus, n_W};
}

std::optional<Vector2d> middle_of_convex(const Curve& curve) {
  return is_point(curve)               ? std::optional(curve.vertex_B)
         : curve.side == Side::kInside ? middle_of(curve)
                                       : std::nullopt;
}

// Two bounded convex bodies that are apart: the distance √(F² + F′²) of the points with any given normal is
// at least that of the bodies, and so an upper bound of the maximum of F. Newton's method from the line of
// centres until F reaches it to within the tolerance.
std::optional<Separation> between_apart(const GapProblem& problem, const Vector2d& center1,
                                        const Vector2d& center2, double tolerance) {
  constexpr int kMostSteps = 8;
  double phi = angle_of(Vector2d(center2 - center1));
  for (int step = 0; step < kMostSteps; ++step) {
    const Vector2d n = unit_vector(phi);
    const Value value = value_at(problem, n);
    if (std::hypot(value.f, value.slope) - value.f <= tolerance) {
      return Separation{value.f, n};
    }
    const double curvature = value.rho_sum + value.f;
    if (!(value.f > 0) || !(curvature > 0)) {
      return std::nullopt;
    }
    phi += value.slope / curvature;
  }
  return std::nullopt;
}

// The normal of the face is the only one.
Separation from_face(const PlacedCurve<double>& face, const PlacedCurve<double>& other, bool face_is_first) {
  const Vector2d n_face = face_normal(face);
  const Vector2d inward = -n_face;
  const Vector2d n_W = face_is_first ? n_face : inward;
  if (!has_point(other, inward)) {
    return {-kInf, n_W};
  }
  return {(support_point(other, inward).p_W - face.vertex_W).dot(n_face), n_W};
}

}  // namespace

std::optional<bool> always_free(const Curve& curve1, const Curve& curve2) {
  const bool concave1 = radius_bounds(curve1).low < 0;
  const bool concave2 = radius_bounds(curve2).low < 0;
  if (is_point(curve1) || is_point(curve2) || (!concave1 && !concave2)) {
    return true;
  }
  const bool never = (concave1 && concave2) || is_line(curve1) || is_line(curve2);
  return never ? std::optional(false) : std::nullopt;
}

Separation separation(const Curve& curve1, const Pose<double>& X_W1, const Curve& curve2,
                      const Pose<double>& X_W2, double tolerance) {
  GapProblem problem{place(curve1, X_W1), place(curve2, X_W2), 1};
  if (is_line(curve1)) {
    return from_face(problem.first, problem.second, true);
  }
  if (is_line(curve2)) {
    return from_face(problem.second, problem.first, false);
  }
  if (const auto discs = between_discs(curve1, X_W1, curve2, X_W2)) {
    return *discs;
  }
  const auto middle1 = middle_of_convex(curve1);
  const auto middle2 = middle_of_convex(curve2);
  if (middle1 && middle2) {
    if (const auto apart = between_apart(problem, X_W1 * *middle1, X_W2 * *middle2, tolerance)) {
      return *apart;
    }
  }
  // Every normal of a ring limits the body inside; where that one has no point with such a normal, it crosses
  // the ring.
  const CommonNormals normals = common_normals(problem.first, problem.second);
  if (normals.empty || !normals.cover_ring) {
    return {-kInf, Vector2d::UnitX()};
  }
  const bool in_ring = curve1.side == Side::kOutside || curve2.side == Side::kOutside;
  problem.sign = in_ring ? -1 : 1;
  const auto [best, is_within] =
      maximum(problem, normals.arc.value_or(NormalArc{}), tolerance, in_ring ? kMaxArcsInRing : kMaxArcs);
  Separation found{problem.sign * best.f, unit_vector(best.phi)};
  if (in_ring && !is_within) {
    for (const CommonNormal& least : least_gaps(curve1, X_W1, curve2, X_W2, kInf)) {
      if (least.gap() < found.gap) {
        found = {least.gap(), least.n_W};
      }
    }
  }
  return found;
}

}  // namespace higherpair
