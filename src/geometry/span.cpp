#include "higherpair/geometry/boundary.hpp"
#include "higherpair/geometry/curvature_rates.hpp"
#include "higherpair/geometry/pose.hpp"
#include "higherpair/geometry/support.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "numeric/interval.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace higherpair {
namespace {

// By the angle of the outward normal; on the concave side, where the angle decreases along t, by minus the
// angle.
class ConicSpan final : public Span {
public:
  ConicSpan(const Curve& curve, double from, double to)
      : curve_(curve),
        sense_(curve.side == Side::kInside ? 1 : -1),
        range_(sense_ > 0 ? Bounds{from, to} : Bounds{-to, -from}) {}

  [[nodiscard]] SpanPoint at(double t) const override {
    const Vector2d n = unit_vector(sense_ * t);
    const PlacedCurve<double> placed = place(curve_, Pose<double>{});
    const SupportPoint<double> point = support_point(placed, n);
    const double slope = radius_slope(placed, point.rho, n);
    return {point.p_W, n, 1 / point.rho, -slope / (point.rho * point.rho * point.rho), std::abs(point.rho)};
  }
  [[nodiscard]] std::optional<CurvatureRates> curvature_rates(double t) const override {
    CurveSeries phi(sense_ * t);
    phi.c[1] = sense_;
    const Vector2<CurveSeries> n(cos(phi), sin(phi));
    return rates_of_curvature(support_point(place(curve_, Pose<CurveSeries>{}), n).p_W);
  }
  [[nodiscard]] Bounds range() const override { return range_; }
  // The radius is monotonic from vertex to vertex.
  [[nodiscard]] std::optional<SpanBounds> bounds(const Bounds& t) const override {
    const double a = at(t.low).speed;
    const double b = at(t.high).speed;
    Bounds speed{std::min(a, b), std::max(a, b)};
    const double apart = curve_.q > 0 ? kPi / 2 : 2 * kPi;  // normals of neighbouring vertices
    const double vertex = sense_ * angle_of(-curve_.axis_B);
    for (double k = std::ceil((t.low - vertex) / apart); vertex + k * apart < t.high; ++k) {
      const double value = at(vertex + k * apart).speed;
      speed = hull(speed, {value, value});
    }
    return SpanBounds{{speed.low * (1 - kSpanBoundRounding), speed.high * (1 + kSpanBoundRounding)},
                      {sense_, sense_}};
  }

private:
  Curve curve_;
  double sense_;
  Bounds range_;
};

// Parametrised by the distance from its origin.
class FaceSpan final : public Span {
public:
  FaceSpan(const Vector2d& origin_B, const Vector2d& t_B, const Bounds& range)
      : origin_(origin_B), t_(t_B), range_(range) {}

  [[nodiscard]] SpanPoint at(double t) const override { return {origin_ + t * t_, -perp(t_), 0, 0, 1}; }
  [[nodiscard]] std::optional<CurvatureRates> curvature_rates(double /*t*/) const override {
    return CurvatureRates{};
  }
  [[nodiscard]] Bounds range() const override { return range_; }
  [[nodiscard]] std::optional<SpanBounds> bounds(const Bounds& /*t*/) const override {
    return SpanBounds{{1, 1}, {0, 0}};
  }
  [[nodiscard]] int parts() const override { return 1; }

private:
  Vector2d origin_, t_;
  Bounds range_;
};

class CornerSpan final : public Span {
public:
  CornerSpan(const Vector2d& at_B, double from, double to) : p_(at_B), range_{from, to} {}

  [[nodiscard]] SpanPoint at(double t) const override { return {p_, unit_vector(t), 0, 0, 1}; }
  [[nodiscard]] std::optional<CurvatureRates> curvature_rates(double /*t*/) const override {
    return CurvatureRates{};
  }
  [[nodiscard]] Bounds range() const override { return range_; }
  [[nodiscard]] std::optional<SpanBounds> bounds(const Bounds& /*t*/) const override {
    return SpanBounds{{0, 0}, {1, 1}};
  }
  [[nodiscard]] bool is_corner() const override { return true; }
  [[nodiscard]] int parts() const override { return 1 + static_cast<int>(range_.width() / 0.1); }

private:
  Vector2d p_;
  Bounds range_;
};

class ReversedSpan final : public Span {
public:
  explicit ReversedSpan(SpanPtr span) : span_(std::move(span)) {}

  // Both κ and the sense of s change their signs, so that dκ/ds does not.
  [[nodiscard]] SpanPoint at(double t) const override {
    const SpanPoint point = span_->at(-t);
    return {point.p_B, -point.n_B, -point.kappa, point.slope, point.speed};
  }
  [[nodiscard]] std::optional<CurvatureRates> curvature_rates(double t) const override {
    auto rates = span_->curvature_rates(-t);
    if (rates) {
      rates = {-(*rates)[0], (*rates)[1], -(*rates)[2]};
    }
    return rates;
  }
  [[nodiscard]] Bounds range() const override { return -span_->range(); }
  [[nodiscard]] std::optional<SpanBounds> bounds(const Bounds& t) const override {
    auto of = span_->bounds(-t);
    if (of) {
      of->turn = -of->turn;
    }
    return of;
  }
  [[nodiscard]] int parts() const override { return span_->parts(); }
  [[nodiscard]] std::vector<double> breaks() const override {
    std::vector<double> breaks = span_->breaks();
    std::reverse(breaks.begin(), breaks.end());
    std::transform(breaks.begin(), breaks.end(), breaks.begin(), std::negate<>());
    return breaks;
  }

private:
  SpanPtr span_;
};

// κ of the offset is κ/m with m = 1 + κ d, and its arc is m ds, so that dκ/ds is divided by m³.
class OffsetSpan final : public Span {
public:
  OffsetSpan(SpanPtr span, double distance) : span_(std::move(span)), distance_(distance) {}

  [[nodiscard]] SpanPoint at(double t) const override {
    const SpanPoint point = span_->at(t);
    const double m = 1 + point.kappa * distance_;
    return {point.p_B + distance_ * point.n_B, point.n_B, point.kappa / m, point.slope / (m * m * m),
            point.speed * m};
  }
  [[nodiscard]] std::optional<CurvatureRates> curvature_rates(double t) const override {
    const auto rates = span_->curvature_rates(t);
    if (!rates) {
      return std::nullopt;
    }
    const CurveSeries kappa = curvature_series(span_->at(t), *rates);
    const CurveSeries stretch = 1 + distance_ * kappa;
    return rates_of_curvature(kappa / stretch, stretch);
  }
  [[nodiscard]] Bounds range() const override { return span_->range(); }
  [[nodiscard]] std::optional<SpanBounds> bounds(const Bounds& t) const override {
    auto of = span_->bounds(t);
    if (of) {
      of->speed = to_bounds(to_interval(of->speed) + distance_ * to_interval(of->turn));
    }
    return of;
  }
  [[nodiscard]] int parts() const override { return span_->parts(); }
  [[nodiscard]] std::vector<double> breaks() const override { return span_->breaks(); }

private:
  SpanPtr span_;
  double distance_;
};

}  // namespace

SpanPtr conic_span(const Curve& curve, double from, double to) {
  assert(is_conic(curve) && from < to);
  return std::make_shared<ConicSpan>(curve, from, to);
}

SpanPtr face_span(const Vector2d& from_B, const Vector2d& to_B) {
  assert(from_B != to_B);
  const double length = (to_B - from_B).norm();
  return face_span(from_B, (to_B - from_B) / length, {0, length});
}

SpanPtr face_span(const Vector2d& origin_B, const Vector2d& t_B, const Bounds& range) {
  return std::make_shared<FaceSpan>(origin_B, t_B, range);
}

SpanPtr corner_span(const Vector2d& at_B, double from, double to) {
  assert(from < to);
  return std::make_shared<CornerSpan>(at_B, from, to);
}

SpanPtr reversed_span(SpanPtr span) {
  assert(!span->is_corner());
  return std::make_shared<ReversedSpan>(std::move(span));
}

SpanPtr offset_span(SpanPtr span, double distance) {
  assert(!span->is_corner());
  return std::make_shared<OffsetSpan>(std::move(span), distance);
}

}  // namespace higherpair
