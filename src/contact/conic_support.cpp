#include "arc_bounds.hpp"
#include "higherpair/contact/subdivision.hpp"
#include "higherpair/geometry/support.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace higherpair {
namespace {

// Encloses the angle of a vector; the library's arc tangent is within one unit of the last place.
Interval angle_around(const Vector2d& v) {
  return around(angle_of(v), 4e-16 * std::abs(angle_of(v)) + 1e-300);
}

SupportValue value_of(const Interval& h, const Interval& dh, double rho, double drho) {
  using boost::numeric::median;
  using boost::numeric::width;
  return {median(h), median(dh), rho, drho, std::max(width(h), width(dh))};
}

// A point, or any point of a line: ρ = 0.
class PointSupport final : public SupportCurve {
public:
  PointSupport(const Vector2d& at_B, const SupportPiece& piece) : at_B_(exactly(at_B)), pieces_{piece} {}

  [[nodiscard]] const std::vector<SupportPiece>& pieces() const override { return pieces_; }
  [[nodiscard]] SupportValue at(std::size_t, double phi) const override {
    const IntervalVector n = unit_interval(phi);
    return value_of(at_B_.dot(n), at_B_.dot(n.turned()), 0, 0);
  }
  [[nodiscard]] Bounds radius(std::size_t, const Bounds&) const override { return {0, 0}; }

private:
  IntervalVector at_B_;
  std::vector<SupportPiece> pieces_;
};

// In the vertex form of Curve, N = side n in the frame of the axis, w² = N_x² + q N_y²:
//     h = v·n + side ℓ N_y²/(w - N_x),   |ρ| = ℓ/w³,
//     h′ = v·t + side y (N_x - N_y²/(w - N_x)),   y = ℓ N_y/w,
// and on the far half of an ellipse (N_x > 0) N_y²/(w - N_x) = (w + N_x)/q, so that nothing cancels.
class ConicSupport final : public SupportCurve {
public:
  ConicSupport(const Curve& conic, double reach)
      : conic_(conic), vertex_B_(exactly(conic.vertex_B)), axis_angle_(angle_around(conic.axis_B)) {
    SupportPiece piece{PieceKind::kClosed, {}, {}};
    if (conic.q <= 0) {
      // |y| = reach at tan(ν) = |N_y/N_x| = reach/√(ℓ² - q reach²), w² = 1/(1+tan²) + q tan²/(1+tan²).
      const double ratio = reach / conic.semi_latus;
      const double of_reach = ratio / std::sqrt(1 - conic.q * ratio * ratio);
      const double of_w = std::sqrt((1 - kLeastW2) / (kLeastW2 - conic.q));
      const double half = std::atan(std::min(of_reach, of_w));
      const double at_vertex = angle_of(-sign() * conic.axis_B);
      piece = {PieceKind::kArc, {at_vertex - half, at_vertex + half}, {}};
    }
    pieces_ = {piece};
  }

  [[nodiscard]] const std::vector<SupportPiece>& pieces() const override { return pieces_; }

  [[nodiscard]] SupportValue at(std::size_t, double phi) const override {
    const double side = sign();
    const IntervalVector N = normal(phi);
    const Interval w = root_of_w2(conic_.q * square(N.y) + square(N.x));
    const bool near_half = boost::numeric::median(N.x) <= 0 || conic_.q <= 0;
    const Interval part = near_half ? square(N.y) / (w - N.x) : (w + N.x) / conic_.q;
    const IntervalVector n = unit_interval(phi);
    const double l = conic_.semi_latus;
    const Interval h = vertex_B_.dot(n) + side * l * part;
    const Interval dh = vertex_B_.dot(n.turned()) + side * l * N.y / w * (N.x - part);
    const double rho = boost::numeric::median(side * l / (square(w) * w));
    return value_of(h, dh, rho, radius_slope(place(conic_, Pose<double>{}), rho, unit_vector(phi)));
  }

  [[nodiscard]] Bounds radius(std::size_t, const Bounds& phi) const override {
    if (conic_.q == 1) {
      return {sign() * conic_.semi_latus, sign() * conic_.semi_latus};
    }
    // w² = 1 - (1-q) N_y² has N_y only once.
    const IntervalVector N = normal(to_interval(phi));
    const Interval one_minus_q = 1.0 - Interval(conic_.q);
    const Interval w2 = 1.0 - one_minus_q * square(N.y);
    const Interval w = root_of_w2(w2);
    return to_bounds(sign() * conic_.semi_latus / (square(w) * w));
  }

private:
  [[nodiscard]] double sign() const { return conic_.side == Side::kInside ? 1 : -1; }

  [[nodiscard]] IntervalVector normal(const Interval& phi) const {
    const Interval angle = phi - axis_angle_;
    return {sign() * cos(angle), sign() * sin(angle)};
  }

  // w² is positive on all pieces; rounding may say otherwise next to the end of the cone.
  static Interval root_of_w2(const Interval& w2) {
    return sqrt(Interval(std::max(w2.lower(), 0.0), std::max(w2.upper(), 0.0)));
  }

  Curve conic_;
  IntervalVector vertex_B_;
  Interval axis_angle_;
  std::vector<SupportPiece> pieces_;
};

}  // namespace

SupportBounds bounds_over(const SupportCurve& curve, std::size_t piece, const Bounds& phi) {
  assert(phi.low <= phi.high && phi.width() <= 3.15);
  const ArcBounds arc = arc_bounds(curve, piece, {Interval(0), Interval(0)}, to_interval(phi));
  return {to_bounds(arc.h), to_bounds(arc.dh), to_bounds(arc.rho)};
}

std::unique_ptr<SupportCurve> make_support_curve(const Curve& curve, double reach) {
  assert(reach > 0);
  switch (curve.kind) {
    case CurveKind::kPoint:
      return std::make_unique<PointSupport>(curve.vertex_B, SupportPiece{PieceKind::kClosed, {}, {}});
    case CurveKind::kLine:
      return std::make_unique<PointSupport>(
          curve.vertex_B,
          SupportPiece{PieceKind::kFace, to_bounds(angle_around(-curve.axis_B)), Bounds{-kInf, kInf}});
    default:
      return std::make_unique<ConicSupport>(curve, reach);
  }
}

}  // namespace higherpair
