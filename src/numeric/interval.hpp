#pragma once

#include "higherpair/numeric/special_values.hpp"
#include "higherpair/numeric/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Core>

// Not <boost/numeric/interval.hpp>, which requires a processor whose rounding mode it can set.
#include <boost/numeric/interval/arith.hpp>
#include <boost/numeric/interval/arith2.hpp>
#include <boost/numeric/interval/checking.hpp>
#include <boost/numeric/interval/interval.hpp>
#include <boost/numeric/interval/policies.hpp>
#include <boost/numeric/interval/utility.hpp>

namespace higherpair {

/// Outward rounding of intervals without changing the processor's rounding mode: the nearest double is within
/// half a unit in the last place, and one to two units are subtracted or added. This needs no compiler flags,
/// cannot be disturbed by calls of foreign code, and works where there are no rounding modes.
struct OutwardRounding {
  using unprotected_rounding = OutwardRounding;

  // The last summand covers underflow; it also keeps away from subnormal numbers, which are slow.
  static double margin(double x) { return std::abs(x) * std::numeric_limits<double>::epsilon() + 0x1p-960; }
  // A NaN (∞ - ∞, 0·∞) may be any number; a result that overflowed was finite.
  static double down(double x) {
    const double y = x - margin(x);
    if (y == y) return y;
    return x > 0 ? std::numeric_limits<double>::max() : -kInf;
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

/// Converts from the ends of a range.
template <class Range>
[[nodiscard]] Interval to_interval(const Range& range) {
  return {range.low, range.high};
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
  return around(std::numbers::pi, 0x1p-52);
}

/// Encloses the cosine (`quarter` = 0) or the sine (1) over x, from the values at the ends (which libraries
/// compute to one unit in the last place) and the extremes in between: at (k + quarter/2) π, k whole.
[[nodiscard]] inline Interval wave(const Interval& x, int quarter) {
  if (!(x.upper() - x.lower() < 2 * std::numbers::pi)) {
    return {-1, 1};
  }
  const auto value = [&](double angle) { return quarter == 0 ? std::cos(angle) : std::sin(angle); };
  const double a = value(x.lower());
  const double b = x.upper() == x.lower() ? a : value(x.upper());
  double low = OutwardRounding::down(std::min(a, b));
  double high = OutwardRounding::up(std::max(a, b));
  const double slack = kExtremeSlack * (1 + std::max(std::abs(x.lower()), std::abs(x.upper())));
  const long first = std::lround(std::ceil((x.lower() - slack) / std::numbers::pi - 0.5 * quarter));
  const long last = std::lround(std::floor((x.upper() + slack) / std::numbers::pi - 0.5 * quarter));
  for (long k = first; k <= last; ++k) {
    const bool peak = k % 2 == 0;
    low = peak ? low : -1;
    high = peak ? 1 : high;
  }
  return {std::max(low, -1.0), std::min(high, 1.0)};
}

/// \name Found by argument-dependent lookup in templates over a scalar
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

[[nodiscard]] inline IntervalVector exactly(const Eigen::Vector2d& v) {
  return {Interval(v.x()), Interval(v.y())};
}

/// (cos, sin) of an angle.
[[nodiscard]] inline IntervalVector unit_interval(const Interval& angle) {
  return {cos(angle), sin(angle)};
}

}  // namespace higherpair
