#include "higherpair/geometry/curve_queries.hpp"

#include "higherpair/geometry/arc_length.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <boost/math/quadrature/gauss_kronrod.hpp>

namespace higherpair {
namespace {

constexpr unsigned kMostHalvingsOfArc = 12;

const SupportPiece& piece_of(const PlacedCurve<double>& curve) {
  return curve.support->pieces()[curve.piece];
}

// The angle of a normal in the body's frame, on the same turn as the angles of the piece.
double angle_on_piece(const PlacedCurve<double>& curve, const Vector2d& n_W) {
  const double angle = angle_of(Vector2d(n_W.dot(curve.axis_W), cross(curve.axis_W, n_W)));
  const SupportPiece& piece = piece_of(curve);
  return piece.kind == PieceKind::kClosed ? angle : nearest_turn(angle, (piece.phi.low + piece.phi.high) / 2);
}

SupportValue value_at(const PlacedCurve<double>& curve, const Vector2d& n_W) {
  return curve.support->at(curve.piece, angle_on_piece(curve, n_W));
}

Bounds whole_piece(const Curve& curve) {
  const SupportPiece& piece = curve.support->pieces()[curve.piece];
  return piece.kind == PieceKind::kClosed ? Bounds{-kPi, kPi} : piece.phi;
}

// Calls `take` for a few angles along the piece; returns half of their spacing.
template <class F>
double for_samples(const Curve& curve, const F& take) {
  constexpr int kSamples = 16;
  const Bounds phi = whole_piece(curve);
  const double step = phi.width() / kSamples;
  for (int i = 0; i < kSamples; ++i) {
    take(phi.low + (i + 0.5) * step);
  }
  return step / 2;
}

bool is_concave(const Curve& curve) {
  return radius_bounds(curve).high < 0;
}

}  // namespace

Curve make_curve(const SupportCurve& support, std::size_t piece) {
  assert(support.pieces()[piece].kind != PieceKind::kFace);
  Curve curve{CurveKind::kSupport, Side::kInside, Vector2d::Zero(), Vector2d::UnitX(), 0, 0, &support, piece};
  curve.side = radius_bounds(curve).high < 0 ? Side::kOutside : Side::kInside;
  return curve;
}

SupportPoint<double> point_by_support(const PlacedCurve<double>& curve, const Vector2d& n_W) {
  const SupportValue value = value_at(curve, n_W);
  return {curve.vertex_W + value.h * n_W + value.dh * perp(n_W), value.rho, 1};
}

bool has_normal(const PlacedCurve<double>& curve, const Vector2d& n_W) {
  const SupportPiece& piece = piece_of(curve);
  return piece.kind == PieceKind::kClosed || piece.phi.contains(angle_on_piece(curve, n_W));
}

double slope_by_support(const PlacedCurve<double>& curve, const Vector2d& n_W) {
  return value_at(curve, n_W).drho;
}

double size_of(const Curve& curve) {
  if (curve.support == nullptr) {
    return curve.semi_latus;
  }
  double size = kInf;
  for_samples(curve, [&](double phi) {
    const SupportValue value = curve.support->at(curve.piece, phi);
    size = std::min(size, std::hypot(value.h, value.dh) + std::abs(value.rho));
  });
  return size;
}

Bounds radius_bounds(const Curve& curve) {
  if (is_line(curve)) {
    return {kInf, kInf};
  }
  if (curve.support != nullptr) {
    return curve.support->radius(curve.piece, whole_piece(curve));
  }
  // A conic is sharpest at its vertex; an ellipse is flattest on its minor axis, an open conic at infinity.
  const double flattest = curve.q > 0 ? curve.semi_latus / (curve.q * std::sqrt(curve.q)) : kInf;
  const Bounds rho{curve.semi_latus, flattest};
  return curve.side == Side::kInside ? rho : -rho;
}

std::string_view why_no_contact(const Curve& a, const Curve& b) {
  if (a.kind == b.kind && !is_curved(a)) {
    return is_line(a) ? "two lines cannot make a contact"
                      : "two points cannot make a contact (join them by a revolute joint)";
  }
  if (is_concave(a) && is_concave(b)) {
    return "two concave curves (side = \"outside\") cannot make a contact";
  }
  if (!is_concave(a) && !is_concave(b)) {
    return "";
  }
  const Curve& hollow = is_concave(a) ? a : b;
  const Curve& other = is_concave(a) ? b : a;
  if (is_line(other)) {
    return "a line cannot touch a concave curve (side = \"outside\")";
  }
  if (radius_bounds(other).low + radius_bounds(hollow).low > 0) {
    return "the convex curve is nowhere sharp enough to fit into the concave one (side = \"outside\")";
  }
  return "";
}

Bounds radius_bounds(const PlacedCurve<double>& curve, const Vector2d& n_W, const Rotation<double>& half) {
  if (curve.q == 1) {
    return {curve.side * curve.semi_latus, curve.side * curve.semi_latus};
  }
  const auto [c, s] = half;
  if (curve.support != nullptr) {
    const double middle = angle_on_piece(curve, n_W);
    const double turn = std::atan2(s, c);
    Bounds phi{middle - turn, middle + turn};
    if (piece_of(curve).kind != PieceKind::kClosed) {
      const Bounds& all = piece_of(curve).phi;
      phi = {std::clamp(phi.low, all.low, all.high), std::clamp(phi.high, all.low, all.high)};
    }
    return curve.support->radius(curve.piece, phi);
  }
  // |ρ| = ℓ/w³; w² = N_x² + q N_y² has its extremes at the ends and where the normal is along or across the
  // axis.
  const double N_x = n_W.dot(curve.axis_W);
  const double N_y = cross(curve.axis_W, n_W);
  const auto w2_at = [&](double x, double y) { return x * x + curve.q * y * y; };
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
  const auto rho = [&](double w2) { return w2 > 0 ? curve.semi_latus / (w2 * std::sqrt(w2)) : kInf; };
  const Bounds bounds{rho(w2_max), rho(w2_min)};
  return curve.side > 0 ? bounds : -bounds;
}

std::optional<NormalArc> normals_of(const PlacedCurve<double>& curve) {
  if (curve.support != nullptr) {
    const SupportPiece& piece = piece_of(curve);
    if (piece.kind == PieceKind::kClosed) {
      return std::nullopt;
    }
    return NormalArc{angle_of(curve.axis_W) + (piece.phi.low + piece.phi.high) / 2, piece.phi.width() / 2};
  }
  if (curve.q > 0) {
    return std::nullopt;
  }
  const double half = curve.q == 0 ? kPi / 2 : std::atan(1 / std::sqrt(-curve.q));
  return NormalArc{angle_of(-curve.side * curve.axis_W), half};
}

std::optional<double> reach_from(const Curve& curve, const Vector2d& p_B) {
  if (is_point(curve)) {
    return (curve.vertex_B - p_B).norm();
  }
  if (curve.support != nullptr) {
    // A point between two samples is no farther from the nearer one than the arc between them.
    const Bounds rho = radius_bounds(curve);
    double farthest = 0;
    const double half = for_samples(curve, [&](double phi) {
      const SupportValue value = curve.support->at(curve.piece, phi);
      const Vector2d n = unit_vector(phi);
      farthest = std::max(farthest, (value.h * n + value.dh * perp(n) - p_B).norm());
    });
    const double reach = farthest + half * std::max(std::abs(rho.low), std::abs(rho.high));
    return std::isfinite(reach) ? std::optional(reach) : std::nullopt;
  }
  const auto middle = middle_of(curve);
  return middle ? std::optional((*middle - p_B).norm() + semi_axes(curve)[0]) : std::nullopt;
}

std::optional<Vector2d> round_center(const Curve& curve) {
  if (curve.kind != CurveKind::kCircle && !is_point(curve)) {
    return std::nullopt;
  }
  return curve.vertex_B + curve.semi_latus * curve.axis_B;
}

std::optional<Vector2d> middle_of(const Curve& curve) {
  return is_conic(curve) && curve.q > 0 ? std::optional(center(curve)) : std::nullopt;
}

bool is_centered_at(const Curve& curve, const Vector2d& p_B, double size) {
  const auto middle = round_center(curve);
  return middle && (*middle - p_B).norm() <= kCentered * size;
}

bool slides_along_itself(const Curve& curve, const Rotation<double>& R_WB, const Vector2d& direction_W) {
  return is_line(curve) && std::abs((R_WB * curve.axis_B).dot(direction_W)) <= kAlongItself;
}

double arc_to_normal(const Curve& curve, double phi_B) {
  if (curve.support != nullptr) {
    const auto rho = [&](double phi) { return curve.support->at(curve.piece, phi).rho; };
    const int parts = 1 + static_cast<int>(std::abs(phi_B) / (kPi / 8));
    double arc = 0;
    for (int i = 0; i < parts; ++i) {
      // Subdivided where the curve is nearly flat, since ρ is large there.
      arc += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
          rho, phi_B * i / parts, phi_B * (i + 1) / parts, kMostHalvingsOfArc, kArcPrecision);
    }
    return arc;
  }
  // For a body on the outside the normal is reversed, and the arc runs the other way.
  const bool inside = curve.side == Side::kInside;
  const double psi = phi_B - vertex_normal_angle(curve) - (inside ? 0 : kPi);
  const double arc = arc_length(curve, curve.q > 0 ? psi : nearest_turn(psi, 0));
  return inside ? arc : -arc;
}

double arc_to_point(const Curve& curve, const Vector2d& p_B) {
  const Vector2d d = p_B - curve.vertex_B;
  const double arc = open_arc_length(curve.semi_latus, curve.q, d.dot(curve.axis_B), cross(d, curve.axis_B));
  return curve.side == Side::kInside ? arc : -arc;
}

}  // namespace higherpair
