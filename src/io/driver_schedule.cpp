#include "higherpair/io/driver_schedule.hpp"

#include "double_double.hpp"
#include "numeric/decimal.hpp"
#include "schedule_timing.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include <fmt/format.h>

namespace higherpair {
namespace {

using io_detail::DoubleDouble;
using io_detail::kMostRows;
using io_detail::mistake;

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

// The shortest decimal number that is read as x > 0, less x.
double rest_of_decimal(double x) {
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

bool is_turning(const Profile& profile, std::size_t driver) {
  const auto joint = static_cast<std::size_t>(profile.mechanism.drivers[driver].joint);
  return profile.mechanism.joints[joint].type == JointType::kRevolute;
}

double full_turn(const Units& units) {
  return from_si(dimension::kAngle, units).apply(2 * kPi);
}

Diagnostics mistakes_of_option(std::optional<std::int64_t> samples) {
  Diagnostics mistakes;
  if (samples && (*samples < 1 || *samples > kMostRows)) {
    mistakes.push_back(about("--samples " + std::to_string(*samples), "must be an integer from 1 to 2^53"));
  }
  return mistakes;
}

// Where this driver ends, if it moves at all.
std::optional<double> end_of(const Profile& profile, std::size_t driver) {
  const DriverProgram& program = profile.programs[driver];
  if (!program.end && is_turning(profile, driver)) {
    return program.start + full_turn(profile.units);
  }
  return program.end;
}

tl::expected<std::int64_t, Diagnostic> analyze_rows(const Profile& profile, std::size_t driver,
                                                    std::optional<std::int64_t> option) {
  const auto fail = [&](std::string_view key, std::string_view rule) {
    return tl::unexpected(mistake(profile, driver, key, rule));
  };
  const DriverProgram& program = profile.programs[driver];
  if (!program.positions.empty()) {
    if (option) return fail("positions", "are given one by one: --samples has no meaning for them");
    return static_cast<std::int64_t>(program.positions.size());
  }
  const auto samples = option ? option : program.samples;
  const auto end = end_of(profile, driver);
  if (!end) {
    if (samples.value_or(1) > 1) {
      return fail("end",
                  fmt::format("is missing: {} samples need one (the same as start to stay there)", *samples));
    }
    return 1;
  }
  return samples.value_or(kDefaultSamples);
}

// When a law comes to a value first.
std::optional<double> first_time(const MotionLaw& law, double value) {
  const LawExtremes range = law.extremes(0, 0, std::max(law.end(), 0.0));
  const double rounding = 1e-12 * (range.greatest - range.least);
  if (value < range.least - rounding || value > range.greatest + rounding) {
    return std::nullopt;
  }
  const double reached = std::clamp(value, range.least, range.greatest);
  if (law(0.0) == reached) {
    return 0;
  }
  if (reached == range.least || reached == range.greatest) {  // touched only: exact as an extreme
    return reached == range.least ? range.least_at : range.greatest_at;
  }
  const auto times = law.places(reached, 0, std::max(law.end(), 0.0));
  return times.empty() ? std::nullopt : std::optional(times.front());
}

}  // namespace

std::vector<DriverSchedule::OneDriver> DriverSchedule::drivers_of(const Profile& profile) {
  assert(profile.programs.size() == profile.mechanism.drivers.size());
  std::vector<OneDriver> drivers;
  for (std::size_t i = 0; i < profile.programs.size(); ++i) {
    const DriverProgram& program = profile.programs[i];
    const Dimension position = is_turning(profile, i) ? dimension::kAngle : dimension::kLength;
    const Dimension velocity = position / dimension::kTime;
    OneDriver driver{program.positions,
                     program.start,
                     end_of(profile, i).value_or(program.start),
                     program.velocity,
                     program.acceleration,
                     to_si(position, profile.units),
                     to_si(velocity, profile.units),
                     to_si(velocity / dimension::kTime, profile.units),
                     {},
                     program.law,
                     {}};
    Dimension higher = velocity / dimension::kTime;
    for (Scaling& scaling : driver.higher_to_si) {
      higher = higher / dimension::kTime;
      scaling = to_si(higher, profile.units);
    }
    drivers.push_back(std::move(driver));
  }
  return drivers;
}

tl::expected<DriverSchedule, Diagnostics> DriverSchedule::analyze(const Profile& profile,
                                                                  std::optional<std::int64_t> samples) {
  Diagnostics errors = mistakes_of_option(samples);
  const bool laws =
      std::any_of(profile.programs.begin(), profile.programs.end(),
                  [](const DriverProgram& program) { return program.law && program.positions.empty(); });
  if (errors.empty() && laws) {
    return in_time(profile, samples, true);
  }
  DriverSchedule schedule;
  schedule.drivers_ = drivers_of(profile);
  for (std::size_t i = 0; errors.empty() && i < profile.programs.size(); ++i) {
    const auto rows = analyze_rows(profile, i, samples);
    if (!rows) {
      errors.push_back(rows.error());
    } else if (i == 0) {
      schedule.size_ = *rows;
    } else if (*rows != schedule.size_) {
      errors.push_back(mistake(
          profile, i, "samples",
          fmt::format("gives {} positions where the first driver has {}: all drivers need equally many",
                      *rows, schedule.size_)));
    }
  }
  for (std::size_t i = 0; errors.empty() && i < schedule.drivers_.size(); ++i) {
    OneDriver& driver = schedule.drivers_[i];
    for (const double position : driver.law ? driver.positions : std::vector<double>{}) {
      if (const auto time = first_time(*driver.law, position)) {
        driver.times.push_back(*time);
      } else {
        errors.push_back(
            mistake(profile, i, "law",
                    fmt::format("{} does not come to {}", profile.programs[i].law_name, position)));
      }
    }
  }
  if (!errors.empty()) {
    return tl::unexpected(errors);
  }
  return schedule;
}

tl::expected<DriverSchedule, Diagnostics> DriverSchedule::step(const Profile& profile,
                                                               std::optional<std::int64_t> samples) {
  Diagnostics errors = mistakes_of_option(samples);
  if (!errors.empty()) {
    return tl::unexpected(errors);
  }
  return in_time(profile, samples, false);
}

tl::expected<DriverSchedule, Diagnostics> DriverSchedule::in_time(const Profile& profile,
                                                                  std::optional<std::int64_t> samples,
                                                                  bool equally_spaced) {
  Diagnostics errors;
  const auto timing =
      equally_spaced ? io_detail::timing_of_laws(profile, samples) : io_detail::timing_of(profile, samples);
  if (!timing) {
    return tl::unexpected(timing.error());
  }
  DriverSchedule schedule;
  schedule.drivers_ = drivers_of(profile);
  schedule.timed_ = true;
  schedule.size_ = timing->rows;
  schedule.duration_ = timing->rows == 1 ? 0 : timing->duration;
  schedule.time_step_ = timing->time_step;
  schedule.time_step_rest_ = timing->time_step > 0 ? rest_of_decimal(timing->time_step) : 0;
  schedule.time_to_si_ = to_si(dimension::kTime, profile.units);
  schedule.time_from_si_ = from_si(dimension::kTime, profile.units);
  for (std::size_t i = 0; i < schedule.driver_count(); ++i) {
    const DriverState last = schedule.state(schedule.size() - 1, i);
    if (is_turning(profile, i) && !is_sharp_angle(last.si.position)) {
      errors.push_back(mistake(profile, i, "duration",
                               "takes the driver over more than 1e9 turns: its place within the turn is "
                               "rounding"));
      return tl::unexpected(errors);
    }
    if (!(std::abs(last.si.position) <= kLargestQuantity)) {
      errors.push_back(mistake(profile, i, "duration", "takes the driver beyond 1e50 m"));
      return tl::unexpected(errors);
    }
  }
  return schedule;
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

DriverValues DriverSchedule::values(std::int64_t row, const OneDriver& driver) const {
  if (timed_) {
    const double t = time(row);
    if (driver.law) {
      const auto s = driver.law->series<2>(t, side_of(row));
      return {s.c[0], s.c[1], 2 * s.c[2]};
    }
    return {driver.start + t * (driver.velocity + t * driver.acceleration / 2),
            driver.velocity + t * driver.acceleration, driver.acceleration};
  }
  if (driver.law) {
    const auto k = static_cast<std::size_t>(row);
    const auto s = driver.law->series<2>(driver.times[k]);
    return {driver.positions[k], s.c[1], 2 * s.c[2]};
  }
  if (!driver.positions.empty()) {
    return {driver.positions[static_cast<std::size_t>(row)], driver.velocity, driver.acceleration};
  }
  const double position = size_ == 1 ? driver.start : between(driver.start, driver.end, row, size_ - 1);
  return {position, driver.velocity, driver.acceleration};
}

DriverState DriverSchedule::state(std::int64_t row, std::size_t driver) const {
  assert(row >= 0 && row < size_ && driver < drivers_.size());
  const OneDriver& one = drivers_[driver];
  const DriverValues profile = values(row, one);
  DriverState state{profile,
                    {one.position_to_si.apply(profile.position), one.velocity_to_si.apply(profile.velocity),
                     one.acceleration_to_si.apply(profile.acceleration)},
                    {}};
  if (one.law) {
    const double t = timed_ ? time(row) : one.times[static_cast<std::size_t>(row)];
    const auto s = one.law->series<6>(t, side_of(row));
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
