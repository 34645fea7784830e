// The motion of a schedule's drivers in one row, and the time of the row.
#include "higherpair/cam/law_series.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "io/units/double_double.hpp"
#include "numeric/decimal.hpp"
#include "schedule_timing.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <string>

namespace higherpair {
namespace {

using io_detail::DoubleDouble;

// start + (end - start) k/n, rounded once.
double between(double start, double end, std::int64_t k, std::int64_t n) {
  if (k == n) {
    return end;
  }
  const auto steps = static_cast<double>(n);
  const DoubleDouble span = io_detail::exact_sum(end, -start);
  const DoubleDouble offset = span * DoubleDouble{static_cast<double>(k), 0} / DoubleDouble{steps, 0};
  const DoubleDouble sum = io_detail::exact_sum(start, offset.high);
  return sum.high + (sum.low + offset.low);
}

DoubleDouble power_of_ten(int exponent) {
  constexpr int kLargestExact = 22;  // 10^22 is a double
  DoubleDouble power = {1, 0};
  for (; exponent > 0; exponent -= kLargestExact) {
    power = power * DoubleDouble{std::pow(10.0, std::min(exponent, kLargestExact)), 0};
  }
  return power;
}

}  // namespace

double io_detail::rest_of_decimal(double x) {
  const std::string text = shortest_digits(x);
  const std::size_t e = std::min(text.find('e'), text.size());
  std::int64_t digits = 0;
  int exponent = 0;
  bool fraction = false;
  for (const char c : std::string_view(text).substr(0, e)) {
    if (c == '.') {
      fraction = true;
    } else {
      digits = 10 * digits + (c - '0');
      exponent -= fraction ? 1 : 0;
    }
  }
  exponent += e == text.size() ? 0 : std::atoi(text.c_str() + e + 1);
  const auto high = static_cast<double>(digits);
  const DoubleDouble mantissa = {high, static_cast<double>(digits - static_cast<std::int64_t>(high))};
  const DoubleDouble scale = power_of_ten(std::abs(exponent));
  const DoubleDouble decimal = exponent < 0 ? mantissa / scale : mantissa * scale;
  return (decimal.high - x) + decimal.low;
}

bool DriverSchedule::is_listed() const {
  return !timed_ && std::any_of(drivers_.begin(), drivers_.end(),
                                [](const OneDriver& driver) { return !driver.positions.empty(); });
}

double DriverSchedule::time(std::int64_t row) const {
  if (!timed_) {
    return 0;
  }
  if (row == size_ - 1) {
    return duration_;
  }
  if (time_step_ == 0) {
    return between(0, duration_, row, size_ - 1);
  }
  const auto steps = static_cast<double>(row);
  const DoubleDouble multiple = io_detail::exact_product(steps, time_step_);
  return multiple.high + (multiple.low + steps * time_step_rest_);
}

DriverMotion DriverSchedule::values(std::int64_t row, const OneDriver& driver) const {
  if (timed_) {
    const double t = time(row);
    if (driver.law) {
      const auto s = series_at<2>(*driver.law, t, side_of(row));
      return {s.c[0], s.c[1], 2 * s.c[2]};
    }
    return {driver.start + t * (driver.velocity + t * driver.acceleration / 2),
            driver.velocity + t * driver.acceleration, driver.acceleration};
  }
  if (driver.law) {
    const auto k = static_cast<std::size_t>(row);
    const auto s = series_at<2>(*driver.law, driver.times[k]);
    return {driver.positions[k], s.c[1], 2 * s.c[2]};
  }
  if (!driver.positions.empty()) {
    return {driver.positions[row], driver.velocity, driver.acceleration};
  }
  const double position = size_ == 1 ? driver.start : between(driver.start, driver.end, row, size_ - 1);
  return {position, driver.velocity, driver.acceleration};
}

DriverState DriverSchedule::state(std::int64_t row, std::size_t driver) const {
  assert(row >= 0 && row < size_ && driver < drivers_.size());
  const OneDriver& one = drivers_[driver];
  const DriverMotion profile = values(row, one);
  DriverState state{profile,
                    {one.position_to_si.apply(profile.position), one.velocity_to_si.apply(profile.velocity),
                     one.acceleration_to_si.apply(profile.acceleration)},
                    {}};
  if (one.law) {
    const double t = timed_ ? time(row) : one.times[row];
    const auto s = series_at<6>(*one.law, t, side_of(row));
    double factorial = 2;
    for (std::size_t k = 0; k < state.higher_si.size(); ++k) {
      factorial *= static_cast<double>(k + 3);
      state.higher_si[k] = one.higher_to_si[k].apply(factorial * s.c[k + 3]);
    }
  }
  return state;
}

std::vector<double> DriverSchedule::first_positions() const {
  std::vector<double> positions;
  for (std::size_t i = 0; i < drivers_.size(); ++i) {
    positions.push_back(state(0, i).si.position);
  }
  return positions;
}

}  // namespace higherpair
