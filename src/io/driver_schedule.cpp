#include "higherpair/io/driver_schedule.hpp"

#include "double_double.hpp"
#include "numeric/decimal.hpp"

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

constexpr std::int64_t kMostRows = std::int64_t{1} << 53;  // row numbers are exact doubles

// A remainder of the duration that is smaller, in time steps, is the rounding of the two numbers.
constexpr double kRemainderTolerance = 1e-9;

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

// How messages call a key of a driver.
std::string key_name(const Profile& profile, std::size_t driver, std::string_view key) {
  const std::string& name = profile.mechanism.drivers[driver].name;
  return name.empty() ? fmt::format("driver.{}", key) : fmt::format("drivers.{}.{}", name, key);
}

Diagnostic mistake(const Profile& profile, std::size_t driver, std::string_view key, std::string_view rule) {
  return {profile.programs[driver].place, fmt::format("{} {}", key_name(profile, driver, key), rule)};
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

// Duration or time step: any driver may give it, and those that do must agree.
std::optional<double> shared_time(const Profile& profile, std::optional<double> DriverProgram::*member,
                                  std::string_view key, Diagnostics& errors) {
  std::optional<double> time;
  for (std::size_t i = 0; i < profile.programs.size(); ++i) {
    const std::optional<double> own = profile.programs[i].*member;
    if (own && time && *own != *time) {
      errors.push_back(
          mistake(profile, i, key, "differs from that of another driver: all move in the same time"));
    }
    if (!time) {
      time = own;
    }
  }
  return time;
}

// The rows of a duration: `steps` full steps, and perhaps a shorter one.
struct Steps {
  std::int64_t full = 0;
  bool has_remainder = false;
};

std::optional<Steps> steps_in(double duration, double time_step) {
  const double ratio = duration / time_step;
  if (!(ratio < static_cast<double>(kMostRows - 2))) {
    return std::nullopt;
  }
  const double nearest = std::round(ratio);
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * nearest;
  if (std::abs(ratio - nearest) <= std::max(kRemainderTolerance, rounding) &&
      (nearest > 0 || duration == 0)) {
    return Steps{static_cast<std::int64_t>(nearest), false};
  }
  return Steps{static_cast<std::int64_t>(std::floor(ratio)), true};
}

struct Timing {
  std::int64_t rows = 1;
  double duration = 0;
  double time_step = 0;  // 0: the rows divide the duration evenly
};

tl::expected<Timing, Diagnostics> timing_of(const Profile& profile, std::optional<std::int64_t> samples) {
  Diagnostics errors;
  const auto duration = shared_time(profile, &DriverProgram::duration, "duration", errors);
  const auto time_step = shared_time(profile, &DriverProgram::time_step, "time_step", errors);
  if (!duration) {
    errors.push_back(mistake(profile, 0, "duration", "is missing: `step` needs to know how long to run"));
  }
  if (!samples && !time_step) {
    errors.push_back(
        mistake(profile, 0, "time_step", "is missing: give the time between two rows, or --samples"));
  }
  if (!errors.empty()) {
    return tl::unexpected(errors);
  }
  if (samples) {
    return Timing{*samples, *duration, 0};
  }
  const auto steps = steps_in(*duration, *time_step);
  if (!steps) {
    errors.push_back(
        mistake(profile, 0, "time_step", "is too small: the duration would have more than 2^53 rows"));
    return tl::unexpected(errors);
  }
  return Timing{steps->full + (steps->has_remainder ? 2 : 1), *duration, *time_step};
}

}  // namespace

std::vector<DriverSchedule::OneDriver> DriverSchedule::drivers_of(const Profile& profile) {
  assert(profile.programs.size() == profile.mechanism.drivers.size());
  std::vector<OneDriver> drivers;
  for (std::size_t i = 0; i < profile.programs.size(); ++i) {
    const DriverProgram& program = profile.programs[i];
    const Dimension position = is_turning(profile, i) ? dimension::kAngle : dimension::kLength;
    const Dimension velocity = position / dimension::kTime;
    drivers.push_back({program.positions, program.start, end_of(profile, i).value_or(program.start),
                       program.velocity, program.acceleration, to_si(position, profile.units),
                       to_si(velocity, profile.units), to_si(velocity / dimension::kTime, profile.units)});
  }
  return drivers;
}

tl::expected<DriverSchedule, Diagnostics> DriverSchedule::analyze(const Profile& profile,
                                                                  std::optional<std::int64_t> samples) {
  Diagnostics errors = mistakes_of_option(samples);
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
  const auto timing = timing_of(profile, samples);
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

double DriverSchedule::passing_time(std::int64_t row, double position, double share) const {
  if (row == 0) {
    return time(0);
  }
  const double before = time(row - 1);
  const double after = time(row);
  const double t = std::lerp(before, after, std::clamp(share, 0.0, 1.0));
  if (drivers_.size() != 1) {
    return t;
  }
  const OneDriver& driver = drivers_.front();
  const double way = position - driver.start;
  if (driver.acceleration == 0) {
    return driver.velocity == 0 ? t : std::clamp(way / driver.velocity, before, after);
  }
  // A parabola passes a place twice: once in the interval, or else the nearer time is meant.
  const double discriminant = driver.velocity * driver.velocity + 2 * driver.acceleration * way;
  const double sum = driver.velocity + std::copysign(std::sqrt(std::max(discriminant, 0.0)), driver.velocity);
  const double one = sum == 0 ? 0 : 2 * way / sum;
  const double other = -sum / driver.acceleration;
  const auto missed = [&](double root) { return std::abs(std::clamp(root, before, after) - root); };
  const auto from_share = [&](double root) { return std::abs(root - t); };
  const bool first =
      missed(one) == missed(other) ? from_share(one) <= from_share(other) : missed(one) < missed(other);
  return std::clamp(first ? one : other, before, after);
}

std::optional<DriverSchedule::TurningPoint> DriverSchedule::turning_point(std::int64_t row) const {
  if (!timed_ || row == 0 || drivers_.size() != 1 || drivers_.front().acceleration == 0) {
    return std::nullopt;
  }
  const OneDriver& driver = drivers_.front();
  const double t = -driver.velocity / driver.acceleration;
  const double before = time(row - 1);
  const double after = time(row);
  if (!(t > before && t < after)) {
    return std::nullopt;
  }
  const double position = driver.start + t * driver.velocity / 2;
  const DriverValues si{driver.position_to_si.apply(position), 0,
                        driver.acceleration_to_si.apply(driver.acceleration)};
  return TurningPoint{si, (t - before) / (after - before)};
}

DriverValues DriverSchedule::values(std::int64_t row, const OneDriver& driver) const {
  if (timed_) {
    const double t = time(row);
    return {driver.start + t * (driver.velocity + t * driver.acceleration / 2),
            driver.velocity + t * driver.acceleration, driver.acceleration};
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
  return {profile,
          {one.position_to_si.apply(profile.position), one.velocity_to_si.apply(profile.velocity),
           one.acceleration_to_si.apply(profile.acceleration)}};
}

std::vector<double> DriverSchedule::first_positions() const {
  std::vector<double> positions;
  for (std::size_t i = 0; i < drivers_.size(); ++i) {
    positions.push_back(state(0, i).si.position);
  }
  return positions;
}

}  // namespace higherpair
