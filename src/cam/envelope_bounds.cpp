#include "envelope.hpp"
#include "higherpair/geometry/pose.hpp"
#include "higherpair/geometry/support.hpp"
#include "numeric/interval.hpp"
#include "relative_motion.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr int kMostHalvings = 6;
constexpr int kMostWidenings = 8;

using MotionOver = RelativeMotion<Interval, 1>;

MotionOver motion_over(const CamMotion& motion, const Bounds& x) {
  // Keeps away from a join, where the derivatives of the next piece would count as well.
  const double beside = std::min(kBesideJoin * std::max(std::abs(x.low), std::abs(x.high)), x.width() / 2);
  PowerSeries<Interval, 2> joint(to_interval(x));
  joint.c[1] = 1;
  PowerSeries<Interval, 2> s;
  for (int k = 0; k <= 2; ++k) {
    const Bounds derivative = motion.law.bounds(k, x.low + beside, x.high - beside);
    s.c[k] = to_interval(derivative) / (k == 2 ? 2.0 : 1.0);
  }
  return relative_motion<Interval, 1>(motion, joint, s);
}

IntervalVector term(const Vector2<MotionOver::Series>& v, std::size_t k) {
  return {v.x().c[k], v.y().c[k]};
}

// Speed of the contact point along the follower's t, relative to the cam, and rate of rotation of its normal
// relative to the follower.
struct FlankRates {
  Interval along;
  Interval turn;
};

FlankRates rates_of_line(const MotionOver& motion, const Curve& line) {
  const Vector2d n = -line.axis_B;
  const auto h_slope = (motion.w.x() * n.x() + motion.w.y() * n.y()) / motion.omega;
  const Interval& omega = motion.omega.c[0];
  return {term(motion.w, 0).dot(exactly(perp(n))) + omega * line.vertex_B.dot(n) + h_slope.c[1], 0};
}

// The follower's curve near one of its normals.
struct Arc {
  const Curve& curve;
  double middle;  // angle of that normal
  Vector2d p;     // the point there

  [[nodiscard]] Interval radius(const Interval& phi) const {
    if (is_point(curve)) {
      return 0;
    }
    const SpanPtr span = conic_span(curve, phi.lower(), phi.upper());
    const Interval size = to_interval(span->bounds(span->range())->speed);
    return curve.side == Side::kInside ? size : -size;
  }
};

// With f(φ, x) = w·n - ω h′ = 0 of cam_flank():  dφ/dx = -f_x/f_φ,  f_φ = w·t - ω (ρ - h).
FlankRates rates_of_arc(const MotionOver& motion, const Arc& arc, const Interval& phi) {
  const IntervalVector n = unit_interval(phi);
  const IntervalVector t = n.turned();
  const Interval rho = arc.radius(phi);
  const Interval distance = rho * (phi - arc.middle);
  const IntervalVector p = {arc.p.x() + distance * t.x, arc.p.y() + distance * t.y};
  const Interval h = p.dot(n);
  const Interval& omega = motion.omega.c[0];
  const Interval along = term(motion.w, 0).dot(t);
  const Interval rate =
      (motion.omega.c[1] * p.dot(t) - term(motion.w, 1).dot(n)) / (along - omega * (rho - h));
  return {along + omega * h + rho * rate, rate};
}

bool is_finite(const FlankRates& rates) {
  return std::isfinite(boost::numeric::norm(rates.along)) && std::isfinite(boost::numeric::norm(rates.turn));
}

// The normal's angle solves dφ/dx = rate: it stays within bounds that it cannot leave at the rates found over
// them.
std::optional<FlankRates> rates_of_arc_over(const MotionOver& motion, const Arc& arc,
                                            const Interval& from_middle) {
  Interval phi = around(arc.middle, kEnvelopeRounding);
  for (int i = 0; i < kMostWidenings; ++i) {
    const FlankRates rates = rates_of_arc(motion, arc, phi);
    const Interval next = around(arc.middle, kEnvelopeRounding) + rates.turn * from_middle;
    if (!is_finite(rates) || !(boost::numeric::width(next) < kPi / 2)) {
      return std::nullopt;
    }
    if (boost::numeric::subset(next, phi)) {
      return rates_of_arc(motion, arc, next);
    }
    phi = around(arc.middle, 1.5 * boost::numeric::norm(next - arc.middle) + kEnvelopeRounding);
  }
  return std::nullopt;
}

std::optional<FlankRates> rates_over(const FlankOrigin& origin, const MotionOver& motion, const Bounds& x,
                                     const SpanPoint& middle, double at) {
  if (is_line(origin.curve)) {
    const FlankRates rates = rates_of_line(motion, origin.curve);
    return is_finite(rates) ? std::optional(rates) : std::nullopt;
  }
  const MotionOver there = motion_over(origin.motion, {at, at});
  const Rotation<double> R{boost::numeric::median(there.R.cos.c[0]),
                           boost::numeric::median(there.R.sin.c[0])};
  const Vector2d n = -(R.inverse() * middle.n_B);
  const Arc arc{origin.curve, angle_of(n), support_point(place(origin.curve, Pose<double>{}), n).p_W};
  return rates_of_arc_over(motion, arc, to_interval(x) - at);
}

std::optional<SpanBounds> bounds_by_halves(const Envelope& envelope, const Bounds& x, double sense,
                                           int halvings) {
  const double at = (x.low + x.high) / 2;
  const MotionOver motion = motion_over(envelope.origin().motion, x);
  const auto middle = envelope.at(at, LawSide::kAfter, sense);
  const auto rates = middle ? rates_over(envelope.origin(), motion, x, *middle, at) : std::nullopt;
  if (rates) {
    // The cam's normal is opposite to the follower's, and so is its t.
    const Interval rounding = around(1, kEnvelopeRounding);
    return SpanBounds{to_bounds(-sense * rates->along * rounding),
                      to_bounds(sense * (motion.omega.c[0] + rates->turn) * rounding)};
  }
  if (halvings == 0 || !(x.low < at && at < x.high)) {
    return std::nullopt;
  }
  const auto first = bounds_by_halves(envelope, {x.low, at}, sense, halvings - 1);
  const auto second = first ? bounds_by_halves(envelope, {at, x.high}, sense, halvings - 1) : std::nullopt;
  return second
             ? std::optional(SpanBounds{hull(first->speed, second->speed), hull(first->turn, second->turn)})
             : std::nullopt;
}

}  // namespace

std::optional<SpanBounds> Envelope::bounds(const Bounds& x, double sense) const {
  return bounds_by_halves(*this, x, sense, kMostHalvings);
}

}  // namespace higherpair
