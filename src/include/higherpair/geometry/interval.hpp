#pragma once

#include "higherpair/geometry/curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

// Not <boost/numeric/interval.hpp>, which wants a processor whose rounding mode it can set.
#include <boost/numeric/interval/arith.hpp>
#include <boost/numeric/interval/arith2.hpp>
#include <boost/numeric/interval/checking.hpp>
#include <boost/numeric/interval/interval.hpp>
#include <boost/numeric/interval/policies.hpp>
#include <boost/numeric/interval/utility.hpp>

namespace higherpair {

/// Rounding of intervals outwards without touching the processor's rounding mode: the nearest double is
/// within half a unit of the last place, and one to two units are taken off or added. So no compiler flag is
/// needed, a call of foreign code in between cannot spoil it, and it works where there are no rounding modes.
struct OutwardRounding {
  using unprotected_rounding = OutwardRounding;

  // The last summand covers underflow; subnormal numbers are kept away, they are slow.
  static double margin(double x) { return std::abs(x) * std::numeric_limits<double>::epsilon() + 0x1p-960; }
  // A NaN (∞ - ∞, 0·∞) may be any number; what has overflowed was finite.
  static double down(double x) {
    const double y = x - margin(x);
    if (y == y) return y;
    return x > 0 ? std::numeric_limits<double>::max() : -std::numeric_limits<double>::infinity();
  }
  static double up(double x) { return -down(-x); }

  static double conv_down(double x) { return x; }
  static double conv_up(double x) { return x; }
  static double add_down(double x, double y) { return down(x + y); }
  static double add_up(double x, double y) { return up(x + y); }
  static double sub_down(double x, double y) { return down(x - y); }
  static double sub_up(double x, double y) { return up(x - y); }
  static double mul_down(double x, double y) { return down(x * y); }
  static double mul_up(double x, double y) { return up(x * y); }
  static double div_down(double x, double y) { return down(x / y); }
  static double div_up(double x, double y) { return up(x / y); }
  static double sqrt_down(double x) { return down(std::sqrt(x)); }
  static double sqrt_up(double x) { return up(std::sqrt(x)); }
  static double median(double x, double y) { return (x + y) / 2; }
};

/// A closed interval whose arithmetic encloses every result.
using Interval = boost::numeric::interval<
    double, boost::numeric::interval_lib::policies<OutwardRounding,
                                                   boost::numeric::interval_lib::checking_base<double>>>;

[[nodiscard]] inline Interval to_interval(const Bounds& bounds) {
  return {bounds.low, bounds.high};
}

[[nodiscard]] inline Bounds to_bounds(const Interval& x) {
  return {x.lower(), x.upper()};
}

/// From the lower begin to the higher end.
[[nodiscard]] inline Bounds hull(const Bounds& a, const Bounds& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

[[nodiscard]] inline bool holds_zero(const Interval& x) {
  return x.lower() <= 0 && x.upper() >= 0;
}

/// [x - error, x + error]
[[nodiscard]] inline Interval around(double x, double error) {
  return Interval(x) + Interval(-error, error);
}

/// π
[[nodiscard]] inline Interval half_turn() {
  return around(kPi, 0x1p-52);
}

/// Encloses the cosine (`quarter` = 0) or the sine (1) over x, from the values at the ends (libraries compute
/// them within one unit of the last place) and the extremes between: at (k + quarter/2) π, k whole.
[[nodiscard]] inline Interval wave(const Interval& x, int quarter) {
  if (!(x.upper() - x.lower() < 2 * kPi)) {
    return {-1, 1};
  }
  const auto value = [&](double angle) { return quarter == 0 ? std::cos(angle) : std::sin(angle); };
  const double a = value(x.lower());
  const double b = x.upper() == x.lower() ? a : value(x.upper());
  double low = OutwardRounding::down(std::min(a, b));
  double high = OutwardRounding::up(std::max(a, b));
  const double slack = 1e-15 * (1 + std::max(std::abs(x.lower()), std::abs(x.upper())));
  const long first = std::lround(std::ceil((x.lower() - slack) / kPi - 0.5 * quarter));
  const long last = std::lround(std::floor((x.upper() + slack) / kPi - 0.5 * quarter));
  for (long k = first; k <= last; ++k) {
    const bool peak = k % 2 == 0;
    low = peak ? low : -1;
    high = peak ? 1 : high;
  }
  return {std::max(low, -1.0), std::min(high, 1.0)};
}

/// \name Found by the type of their argument, in templates over a scalar
/// @{
[[nodiscard]] inline Interval cos(const Interval& x) {
  return wave(x, 0);
}
[[nodiscard]] inline Interval sin(const Interval& x) {
  return wave(x, 1);
}
/// @}

/// A planar vector of which only bounds are known.
struct IntervalVector {
  Interval x;
  Interval y;

  [[nodiscard]] Interval dot(const IntervalVector& other) const { return x * other.x + y * other.y; }
  [[nodiscard]] IntervalVector turned() const { return {-y, x}; }
  [[nodiscard]] IntervalVector operator-(const IntervalVector& other) const {
    return {x - other.x, y - other.y};
  }
};

[[nodiscard]] inline IntervalVector exactly(const Vector2d& v) {
  return {Interval(v.x()), Interval(v.y())};
}

/// (cos, sin) of an angle.
[[nodiscard]] inline IntervalVector unit_interval(const Interval& angle) {
  return {cos(angle), sin(angle)};
}

/// What lies between a curve's support h and slope h′ about a reference point, and its radius, over an
/// interval of normals; and h, h′ at its middle.
struct ArcBounds {
  Interval middle_h;
  Interval middle_dh;
  Interval h;
  Interval dh;
  Interval rho;
};

/// \param about  the reference point in the body's frame \param phi  at most a half turn wide. With δ the
/// angle from the middle m and ρ the bounds of the radius over the interval,
///     h = h_m + h′_m sin δ + (ρ - h_m)(1 - cos δ),   h′ = h′_m cos δ + (ρ - h_m) sin δ,
/// since h + h″ = ρ: h = h_m cos δ + h′_m sin δ + ∫ ρ(m+τ) sin(δ-τ) dτ, τ from 0 to δ. |δ| <= π/2.
[[nodiscard]] inline ArcBounds arc_bounds(const SupportCurve& curve, std::size_t piece,
                                          const IntervalVector& about, const Interval& phi) {
  const double m = boost::numeric::median(phi);
  const SupportValue value = curve.at(piece, m);
  const IntervalVector n = unit_interval(m);
  ArcBounds arc;
  arc.middle_h = around(value.h, value.error) - about.dot(n);
  arc.middle_dh = around(value.dh, value.error) - about.dot(n.turned());
  const Bounds rho = curve.radius(piece, to_bounds(phi));
  assert(value.error >= 0 && rho.low <= rho.high);
  arc.rho = to_interval(rho);
  const Interval from_middle = phi - m;
  const double half = std::max(-from_middle.lower(), from_middle.upper());
  const Interval sin_delta(-half, half);
  const Interval versine(0.0, OutwardRounding::mul_up(half, half) / 2);
  const Interval bend = arc.rho - arc.middle_h;
  arc.h = arc.middle_h + arc.middle_dh * sin_delta + bend * versine;
  arc.dh = arc.middle_dh * (1.0 - versine) + bend * sin_delta;
  return arc;
}

}  // namespace higherpair
