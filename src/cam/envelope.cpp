#include "envelope.hpp"

#include "follower_shape.hpp"
#include "higherpair/cam/law_series.hpp"
#include "higherpair/geometry/curvature_rates.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/geometry/support.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "relative_motion.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace higherpair {
namespace {

constexpr int kMaxNewton = 50;
constexpr int kNormals = 64;  // at which the sign of the equation is sampled

template <int N>
RelativeMotion<double, N> relative_at(const CamMotion& motion, double x, LawSide side) {
  PowerSeries<double, N + 1> joint(x);
  joint.c[1] = 1;
  return relative_motion<double, N>(motion, joint, series_at<N + 1>(motion.law, x, side));
}

// Finds where the follower's curve touches the cam, up to the N-th power of the cam's coordinate: the point
// whose velocity relative to the cam is along the curve.
template <int N>
class Touching {
public:
  using Series = PowerSeries<double, N>;
  using Vector = Vector2<Series>;
  using Relative = RelativeMotion<double, N>;

  // A point of the follower and its outward normal, in the follower's frame.
  struct Touch {
    Vector p, n;
  };

  Touching(const Curve& curve, double slip) : curve_(curve), slip_(slip) {}

  [[nodiscard]] std::optional<Touch> at(const Relative& relative) const {
    if (is_line(curve_)) {
      return touch_of_line(relative);
    }
    if (const auto center = round_center(curve_)) {
      return touch_of_circle(relative, *center);
    }
    return touch_of_conic(relative);
  }

private:
  [[nodiscard]] std::optional<Touch> touch_of_line(const Relative& relative) const {
    if (value_of(relative.omega) == 0) {
      return std::nullopt;
    }
    const Vector2d n = -curve_.axis_B;
    const Vector2d t = perp(n);
    const Series along = (relative.w.x() * n.x() + relative.w.y() * n.y()) / relative.omega;
    const Vector2d foot = curve_.vertex_B - curve_.vertex_B.dot(t) * t;
    return Touch{{foot.x() + along * t.x(), foot.y() + along * t.y()}, {Series(n.x()), Series(n.y())}};
  }

  // The normal is perpendicular to the velocity of the centre: see side_of().
  [[nodiscard]] std::optional<Touch> touch_of_circle(const Relative& relative, const Vector2d& center) const {
    const Vector W(relative.w.x() - center.y() * relative.omega,
                   relative.w.y() + center.x() * relative.omega);
    const Series length = sqrt(W.x() * W.x() + W.y() * W.y());
    if (!(value_of(length) > 0)) {
      return std::nullopt;
    }
    const Vector n(slip_ * W.y() / length, -slip_ * W.x() / length);
    const double r = curve_.semi_latus * (curve_.side == Side::kInside ? 1 : -1);
    return Touch{{center.x() + r * n.x(), center.y() + r * n.y()}, n};
  }

  // Newton's method for the normal's angle, first in numbers and then in series. The derivative of the
  // equation is the velocity of the centre of curvature along t: its sign is that of slip_.
  [[nodiscard]] std::optional<Touch> touch_of_conic(const Relative& relative) const {
    const PlacedCurve<double> placed = place(curve_, Pose<double>{});
    const Vector2d w(value_of(relative.w.x()), value_of(relative.w.y()));
    const double omega = value_of(relative.omega);
    const auto equation = [&](double phi) {
      const Vector2d n = unit_vector(phi);
      const SupportPoint<double> point = support_point(placed, n);
      const double h = point.p_W.dot(n);
      return std::array{w.dot(n) - omega * point.p_W.dot(perp(n)), w.dot(perp(n)) - omega * (point.rho - h)};
    };
    std::optional<double> root;
    for (const double guess : guesses(placed, equation)) {
      double phi = guess;
      for (int i = 0; i < kMaxNewton; ++i) {
        const auto [f, df] = equation(phi);
        const double step = -f / df;
        phi += std::clamp(step, -kNewtonTurn, kNewtonTurn);
        if (!(std::abs(step) > kEnvelopeSettled)) {
          break;
        }
      }
      if (has_point(placed, unit_vector(phi)) && equation(phi)[1] * slip_ > 0) {
        root = phi;
        break;
      }
    }
    return root ? std::optional(series_of_conic(relative, *root)) : std::nullopt;
  }

  [[nodiscard]] Touch series_of_conic(const Relative& relative, double phi_at) const {
    PlacedCurve<Series> placed;
    placed.vertex_W = {Series(curve_.vertex_B.x()), Series(curve_.vertex_B.y())};
    placed.axis_W = {Series(curve_.axis_B.x()), Series(curve_.axis_B.y())};
    placed.semi_latus = curve_.semi_latus;
    placed.q = curve_.q;
    placed.side = curve_.side == Side::kInside ? 1 : -1;
    Series phi(phi_at);
    Touch touch;
    // Each pass doubles the number of correct terms.
    for (int pass = 0; pass < 4; ++pass) {
      touch.n = {cos(phi), sin(phi)};
      const Vector t(-touch.n.y(), touch.n.x());
      const SupportPoint<Series> point = support_point(placed, touch.n);
      touch.p = point.p_W;
      const Series h = dot(touch.p, touch.n);
      const Series f = dot(relative.w, touch.n) - relative.omega * dot(touch.p, t);
      phi -= f / (dot(relative.w, t) - relative.omega * (point.rho - h));
    }
    return touch;
  }

  [[nodiscard]] static Series dot(const Vector& a, const Vector& b) { return a.x() * b.x() + a.y() * b.y(); }

  // Normals of the curve between which the equation changes sign.
  template <class F>
  [[nodiscard]] static std::vector<double> guesses(const PlacedCurve<double>& placed, const F& equation) {
    const NormalArc all = normals_of(placed).value_or(NormalArc{});
    std::vector<double> found;
    double last = 0;
    for (int i = 1; i < kNormals; ++i) {
      const double phi = all.middle + all.half * (2.0 * i / kNormals - 1);
      const double f = equation(phi)[0];
      if (last * f < 0) {
        found.push_back(phi - all.half / kNormals);
      }
      last = f;
    }
    // For a closed curve one may lie across the cut.
    found.push_back(all.middle + all.half);
    return found;
  }

  const Curve& curve_;
  double slip_;  // see Envelope::slip()
};

// A place of the cam, with the follower's curve there.
template <int N>
struct Place {
  Vector2<PowerSeries<double, N>> p;
  Vector2d n;  // outward normal of the cam
};

template <int N>
std::optional<Place<N>> place_at(const Envelope& envelope, double x, LawSide side) {
  const FlankOrigin& origin = envelope.origin();
  const RelativeMotion<double, N> relative = relative_at<N>(origin.motion, x, side);
  const auto touch = Touching<N>(origin.curve, envelope.slip()).at(relative);
  if (!touch) {
    return std::nullopt;
  }
  const auto n = relative.R * touch->n;
  return Place<N>{relative.R * touch->p + relative.p, {-value_of(n.x()), -value_of(n.y())}};
}

// The same as a point of a span with the parameter sense · x.
SpanPoint point_of(const Vector2<PowerSeries<double, 3>>& p, const Vector2d& n, double sense) {
  const auto derivative_of = [&](std::size_t k, double factor) {
    return Vector2d(factor * p.x().c[k], factor * p.y().c[k]);
  };
  const Vector2d d1 = sense * derivative_of(1, 1);
  const Vector2d d2 = derivative_of(2, 2);
  const Vector2d d3 = sense * derivative_of(3, 6);
  const double speed = d1.dot(perp(n));
  const double per2 = 1 / (speed * speed);
  const double turn = cross(d1, d2);
  return {derivative_of(0, 1), n, turn * per2 / speed,
          (cross(d1, d3) * per2 - 3 * turn * d1.dot(d2) * per2 * per2) * per2, speed};
}

}  // namespace

Envelope::Envelope(FlankOrigin origin) : origin_(std::move(origin)) {
  slip_ = origin_.motion.cam_sign * side_of(origin_);
}

std::optional<SpanPoint> Envelope::at(double x, LawSide side, double sense) const {
  const auto place = place_at<3>(*this, x, side);
  return place ? std::optional(point_of(place->p, place->n, sense)) : std::nullopt;
}

std::optional<CurvatureRates> Envelope::curvature_rates(double x, LawSide side, double sense) const {
  auto place = place_at<CurveSeries::kLast>(*this, x, side);
  if (!place) {
    return std::nullopt;
  }
  for (std::size_t k = 1; sense < 0 && k <= CurveSeries::kLast; k += 2) {
    place->p.x().c[k] = -place->p.x().c[k];
    place->p.y().c[k] = -place->p.y().c[k];
  }
  return rates_of_curvature(place->p);
}

}  // namespace higherpair
