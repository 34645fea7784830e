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

Value value_at(const Problem& problem, double phi) {
  const Vector2d n = unit_vector(phi);
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

// Smallest and largest |ρ| = ℓ/w³ of a curve for outward normals in the arc; w² = q + (1 - q) cos² of the
// angle to the axis has its extremes at the ends and at quarter turns.
Range radius_range(const PlacedCurve<double>& curve, const Arc& arc) {
  const double from = arc.middle - arc.half - angle_of(-curve.side * curve.axis_W);
  const double to = from + 2 * arc.half;
  const auto w2_at = [&](double psi) {
    const double c = std::cos(psi);
    return curve.q + (1 - curve.q) * c * c;
  };
  double w2_min = std::min(w2_at(from), w2_at(to));
  double w2_max = std::max(w2_at(from), w2_at(to));
  const auto contains_multiple = [&](double offset) {
    return std::floor((to - offset) / kPi) > std::floor((from - offset) / kPi);
  };
  const double at_axis = 1;
  const double across_axis = curve.q;
  if (contains_multiple(0)) {
    w2_min = std::min(w2_min, at_axis);
    w2_max = std::max(w2_max, at_axis);
  }
  if (contains_multiple(kPi / 2)) {
    w2_min = std::min(w2_min, across_axis);
    w2_max = std::max(w2_max, across_axis);
  }
  const auto rho = [&](double w2) { return w2 > 0 ? curve.semi_latus / (w2 * std::sqrt(w2)) : kInfinity; };
  return {rho(w2_max), curve.semi_latus == 0 ? 0 : rho(w2_min)};
}

// A bound R >= -sign (ρ1 + ρ2) on the arc.
double curvature_bound(const Problem& problem, const Arc& arc) {
  const Range r1 = radius_range(problem.first, arc);
  const Range r2 = radius_range(problem.second, {arc.middle + kPi, arc.half});
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

double bound_of(const Piece& piece, double R) {
  if (!std::isfinite(R)) {
    return kInfinity;
  }
  const double a = piece.value.f - R;
  const double b = std::abs(piece.value.slope);
  const double d = piece.arc.half;
  const double peak = std::atan2(b, a);
  return R + (peak <= d ? std::hypot(a, b) : a * std::cos(d) + b * std::sin(d));
}

Piece make_piece(const Problem& problem, const Arc& arc) {
  Piece piece{arc, value_at(problem, arc.middle), kInfinity};
  piece.bound = bound_of(piece, curvature_bound(problem, arc));
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
    value = value_at(problem, phi);
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
