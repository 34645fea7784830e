#include "higherpair/contact/separation.hpp"

#include "higherpair/geometry/support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace higherpair {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMaxArcs = 20000;

// An arc of normal angles.
struct Arc {
  double middle = 0;
  double half = kPi;
};

// The same by its normal in the middle.
struct NormalArc {
  Vector2d n;
  Rotation<double> half;  // by at most 45°
};

// F is g for two convex bodies, -g for a body in a ring: the extreme wanted is always a maximum of F.
struct Value {
  double f = 0;
  double slope = 0;
  double rho_sum = 0;
};

struct Problem {
  PlacedCurve<double> first;
  PlacedCurve<double> second;
  double sign = 1;  // F = sign g
};

Value value_at(const Problem& problem, const Vector2d& n) {
  const Vector2d inward = -n;
  const SupportPoint<double> s1 = support_point(problem.first, n);
  const SupportPoint<double> s2 = support_point(problem.second, inward);
  const Vector2d d = s2.p_W - s1.p_W;
  return {problem.sign * d.dot(n), problem.sign * d.dot(perp(n)), s1.rho + s2.rho};
}

// The convex-side normals that a curve has, as angles of its body's outward normal.
std::optional<Arc> normals_of(const PlacedCurve<double>& curve) {
  if (curve.q > 0) {
    return std::nullopt;
  }
  const double half = curve.q == 0 ? kPi / 2 : std::atan(1 / std::sqrt(-curve.q));
  return Arc{angle_of(-curve.side * curve.axis_W), half};
}

struct Range {
  double low = 0;
  double high = kInfinity;
};

// Smallest and largest |ρ| = ℓ/w³ of a curve for outward normals in the arc; w² = N_x² + q N_y² has its
// extremes at the ends and where the normal is along or across the axis.
Range radius_range(const PlacedCurve<double>& curve, const NormalArc& arc) {
  if (curve.q == 1) {
    return {curve.semi_latus, curve.semi_latus};
  }
  const double N_x = arc.n.dot(curve.axis_W);
  const double N_y = cross(curve.axis_W, arc.n);
  const auto w2_at = [&](double x, double y) { return x * x + curve.q * y * y; };
  const auto [c, s] = arc.half;
  const double one_end = w2_at(c * N_x - s * N_y, s * N_x + c * N_y);
  const double other_end = w2_at(c * N_x + s * N_y, c * N_y - s * N_x);
  double w2_min = std::min(one_end, other_end);
  double w2_max = std::max(one_end, other_end);
  if (std::abs(N_y) <= s) {
    w2_min = std::min(w2_min, 1.0);
    w2_max = std::max(w2_max, 1.0);
  }
  if (std::abs(N_x) <= s) {
    w2_min = std::min(w2_min, curve.q);
    w2_max = std::max(w2_max, curve.q);
  }
  const auto rho = [&](double w2) { return w2 > 0 ? curve.semi_latus / (w2 * std::sqrt(w2)) : kInfinity; };
  return {rho(w2_max), rho(w2_min)};
}

// A bound R >= -sign (ρ1 + ρ2) on the arc.
double curvature_bound(const Problem& problem, const NormalArc& arc) {
  const Range r1 = radius_range(problem.first, arc);
  const Range r2 = radius_range(problem.second, arc);
  if (problem.sign > 0) {
    return -(r1.low + r2.low);
  }
  // One of the two is concave: its ρ is -|ρ|.
  return problem.first.side < 0 ? r2.high - r1.low : r1.high - r2.low;
}

struct Piece {
  Arc arc;
  Value value;
  double bound = kInfinity;

  bool operator<(const Piece& other) const { return bound < other.bound; }
};

double bound_of(const Value& value, const Rotation<double>& half, double R) {
  if (!std::isfinite(R)) {
    return kInfinity;
  }
  const double a = value.f - R;
  const double b = std::abs(value.slope);
  // R + √(a² + b²) or R + a cos + b sin, written so that a huge R does not cancel.
  if (b * half.cos <= a * half.sin) {
    return a > 0 ? value.f + b * b / (std::sqrt(a * a + b * b) + a) : R;
  }
  const double versine = half.sin * half.sin / (1 + half.cos);
  return value.f - a * versine + b * half.sin;
}

Piece make_piece(const Problem& problem, const Arc& arc) {
  const NormalArc normals{unit_vector(arc.middle), Rotation<double>::from_angle(arc.half)};
  Piece piece{arc, value_at(problem, normals.n), kInfinity};
  piece.bound = bound_of(piece.value, normals.half, curvature_bound(problem, normals));
  return piece;
}

// A few Newton steps uphill; the best value seen.
std::pair<double, double> climb(const Problem& problem, const Arc& within, double phi, Value value) {
  double best_phi = phi;
  double best = value.f;
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
    if (!(value.f > best)) {
      break;
    }
    best = value.f;
    best_phi = phi;
  }
  return {best, best_phi};
}

Separation maximum(const Problem& problem, const Arc& domain, double tolerance) {
  std::vector<Piece> heap;
  double best = -kInfinity;
  double best_phi = domain.middle;
  const auto add = [&](const Arc& arc) {
    const Piece piece = make_piece(problem, arc);
    if (piece.value.f > best) {
      std::tie(best, best_phi) = climb(problem, domain, arc.middle, piece.value);
    }
    heap.push_back(piece);
    std::push_heap(heap.begin(), heap.end());
  };
  constexpr int kStart = 8;
  for (int i = 0; i < kStart; ++i) {
    add({domain.middle + domain.half * ((2 * i + 1.0) / kStart - 1), domain.half / kStart});
  }
  for (int arcs = 0; !heap.empty() && heap.front().bound > best + tolerance && arcs < kMaxArcs; ++arcs) {
    std::pop_heap(heap.begin(), heap.end());
    const Arc arc = heap.back().arc;
    heap.pop_back();
    if (arc.half < 1e-15) {
      continue;
    }
    add({arc.middle - arc.half / 2, arc.half / 2});
    add({arc.middle + arc.half / 2, arc.half / 2});
  }
  return {problem.sign * best, unit_vector(best_phi)};
}

// The only normal is that of the face.
Separation from_face(const PlacedCurve<double>& face, const PlacedCurve<double>& other, bool face_is_first) {
  const Vector2d n_face = -face.axis_W;
  const Vector2d inward = -n_face;
  const Vector2d n_W = face_is_first ? n_face : inward;
  if (!has_point(other, inward)) {
    return {-kInfinity, n_W};
  }
  return {(support_point(other, inward).p_W - face.vertex_W).dot(n_face), n_W};
}

std::optional<Arc> intersection(const std::optional<Arc>& a, const std::optional<Arc>& b, bool& empty) {
  empty = false;
  if (!a || !b) {
    return a ? a : b;
  }
  const double shift = nearest_turn(b->middle, a->middle) - a->middle;
  const double low = std::max(-a->half, shift - b->half);
  const double high = std::min(a->half, shift + b->half);
  empty = !(low < high);
  return Arc{a->middle + (low + high) / 2, (high - low) / 2};
}

}  // namespace

Separation separation(const Curve& curve1, const Pose<double>& X_W1, const Curve& curve2,
                      const Pose<double>& X_W2, double tolerance) {
  Problem problem{place(curve1, X_W1), place(curve2, X_W2), 1};
  if (curve1.kind == CurveKind::kLine) {
    return from_face(problem.first, problem.second, true);
  }
  if (curve2.kind == CurveKind::kLine) {
    return from_face(problem.second, problem.first, false);
  }
  const std::optional<Arc> normals1 = normals_of(problem.first);
  std::optional<Arc> normals2 = normals_of(problem.second);
  if (normals2) {
    normals2->middle += kPi;
  }
  const bool ring1 = curve1.side == Side::kOutside;
  const bool ring2 = curve2.side == Side::kOutside;
  bool empty = false;
  std::optional<Arc> domain = intersection(normals1, normals2, empty);
  if (ring1 || ring2) {
    // Only the normals of the ring bound the other body; if that one reaches further, it crosses the ring.
    problem.sign = -1;
    const std::optional<Arc>& of_ring = ring1 ? normals1 : normals2;
    const std::optional<Arc>& of_body = ring1 ? normals2 : normals1;
    const double wanted = of_ring ? of_ring->half : kPi;
    const bool covered = !empty && (!of_body || (domain && domain->half >= wanted * (1 - 1e-12)));
    if (!covered) {
      return {-kInfinity, Vector2d::UnitX()};
    }
  } else if (empty) {
    return {-kInfinity, Vector2d::UnitX()};
  }
  return maximum(problem, domain.value_or(Arc{}), tolerance);
}

}  // namespace higherpair
