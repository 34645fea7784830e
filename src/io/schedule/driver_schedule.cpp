#include "higherpair/io/driver_schedule.hpp"

#include "higherpair/io/coordinate.hpp"
#include "io/tolerances.hpp"
#include "schedule_timing.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

using io_detail::mistake;

bool is_turning(const Profile& profile, std::size_t driver) {
  return driven_joint(profile.mechanism, driver).type == JointType::kRevolute;
}

Diagnostics mistakes_of_option(std::optional<std::int64_t> samples) {
  Diagnostics mistakes;
  if (samples && (*samples < 1 || *samples > DriverSchedule::kMostRows)) {
    mistakes.push_back(
        about("setting samples " + std::to_string(*samples), "must be an integer from 1 to 2^53"));
  }
  return mistakes;
}

// The position at which this driver ends; none if it does not move.
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
    if (option) {
      return fail("positions",
                  "are given one by one, and each is a row: leave --samples out, or give `end` in place of "
                  "`positions`");
    }
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

// The first time at which a law reaches a value.
std::optional<double> first_time(const MotionLaw& law, double value) {
  const LawExtremes range = law.extremes(0, 0, std::max(law.end(), 0.0));
  const double rounding = kBeyondLaw * (range.greatest - range.least);
  if (value < range.least - rounding || value > range.greatest + rounding) {
    return std::nullopt;
  }
  const double reached = std::clamp(value, range.least, range.greatest);
  if (law(0.0) == reached) {
    return 0;
  }
  if (reached == range.least || reached == range.greatest) {  // touched without crossing: exact as an extreme
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
    const Dimension position = driver_dimension(profile.mechanism, i);
    OneDriver driver{program.positions,
                     program.start,
                     end_of(profile, i).value_or(program.start),
                     program.velocity,
                     program.acceleration,
                     to_si(position, profile.units),
                     to_si(rate_of(position), profile.units),
                     to_si(rate_of(position, 2), profile.units),
                     {},
                     program.law,
                     {}};
    int order = 3;
    for (Scaling& scaling : driver.higher_to_si) scaling = to_si(rate_of(position, order++), profile.units);
    drivers.push_back(std::move(driver));
  }
  return drivers;
}

tl::expected<DriverSchedule, Diagnostics> DriverSchedule::analyze(const Profile& profile,
                                                                  std::optional<std::int64_t> samples) {
  if (Diagnostics errors = mistakes_of_option(samples); !errors.empty()) {
    return tl::unexpected(std::move(errors));
  }
  if (std::any_of(profile.programs.begin(), profile.programs.end(),
                  [](const DriverProgram& program) { return program.law && program.positions.empty(); })) {
    return in_time(profile, samples, true);
  }
  DriverSchedule schedule;
  schedule.drivers_ = drivers_of(profile);
  for (std::size_t i = 0; i < profile.programs.size(); ++i) {
    const auto rows = analyze_rows(profile, i, samples);
    if (!rows) {
      return tl::unexpected(Diagnostics{rows.error()});
    }
    if (i > 0 && *rows != schedule.size_) {
      const bool listed = !profile.programs[i].positions.empty();
      return tl::unexpected(Diagnostics{
          mistake(profile, i, listed ? "positions" : "samples",
                  fmt::format("{} {} positions where the first driver has {}: all drivers need equally many",
                              listed ? "are" : "gives", *rows, schedule.size_))});
    }
    schedule.size_ = *rows;
  }
  for (std::size_t i = 0; i < schedule.drivers_.size(); ++i) {
    OneDriver& driver = schedule.drivers_[i];
    if (!driver.law) continue;
    Diagnostics errors;
    for (const double position : driver.positions) {
      if (const auto time = first_time(*driver.law, position)) {
        driver.times.push_back(*time);
      } else {
        errors.push_back(
            mistake(profile, i, "law",
                    fmt::format("{} does not come to {}", profile.programs[i].law_name, position)));
      }
    }
    if (!errors.empty()) {
      return tl::unexpected(std::move(errors));
    }
  }
  return schedule;
}

tl::expected<DriverSchedule, Diagnostics> DriverSchedule::step(const Profile& profile,
                                                               std::optional<std::int64_t> samples) {
  if (Diagnostics errors = mistakes_of_option(samples); !errors.empty()) {
    return tl::unexpected(std::move(errors));
  }
  return in_time(profile, samples, false);
}

tl::expected<DriverSchedule, Diagnostics> DriverSchedule::in_time(const Profile& profile,
                                                                  std::optional<std::int64_t> samples,
                                                                  bool equally_spaced) {
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
  schedule.time_step_rest_ = timing->time_step > 0 ? io_detail::rest_of_decimal(timing->time_step) : 0;
  schedule.time_to_si_ = to_si(dimension::kTime, profile.units);
  schedule.time_from_si_ = from_si(dimension::kTime, profile.units);
  for (std::size_t i = 0; i < schedule.driver_count(); ++i) {
    const auto& law = schedule.drivers_[i].law;
    const double repetitions = law && law->repeats() ? schedule.duration_ / (law->end() - law->begin()) : 0;
    if (repetitions > kMostRepetitions) {
      return tl::unexpected(Diagnostics{mistake(
          profile, i, "duration",
          fmt::format("takes the driver through {:.6g} repetitions of {}; at most 1e6 can be followed",
                      repetitions, profile.programs[i].law_name))});
    }
    const DriverState last = schedule.state(schedule.size() - 1, i);
    if (is_turning(profile, i) && !is_sharp_angle(last.si.position)) {
      return tl::unexpected(
          Diagnostics{mistake(profile, i, "duration",
                              "takes the driver over more than 1e9 turns: its place within the turn is "
                              "rounding")});
    }
    if (!(std::abs(last.si.position) <= kLargestQuantity)) {
      return tl::unexpected(Diagnostics{mistake(profile, i, "duration", "takes the driver beyond 1e50 m")});
    }
  }
  if (schedule.driver_count() > 1) {
    schedule.curve_ = schedule.make_curve();
  }
  return schedule;
}

}  // namespace higherpair
