#include "schedule_timing.hpp"

#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "io/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

// The name of a driver's key in messages.
std::string key_name(const Profile& profile, std::size_t driver, std::string_view key) {
  return fmt::format("{}.{}", driver_path(profile.mechanism.drivers[driver]), key);
}

// Duration or time step: any driver may give it, and those that do must agree.
std::optional<double> shared_time(const Profile& profile, std::optional<double> DriverProgram::*member,
                                  std::string_view key, Diagnostics& errors) {
  std::optional<double> time;
  for (std::size_t i = 0; i < profile.programs.size(); ++i) {
    const std::optional<double> own = profile.programs[i].*member;
    if (own && time && *own != *time) {
      errors.push_back(mistake(profile, i, key,
                               "differs from that of another driver: all move in the same time; give it to "
                               "one, or the same to all"));
    }
    if (!time) {
      time = own;
    }
  }
  return time;
}

// The time steps in a duration: full ones, and possibly a shorter last one.
struct Steps {
  std::int64_t full = 0;
  bool has_remainder = false;
};

std::optional<Steps> steps_in(double duration, double time_step) {
  const double ratio = duration / time_step;
  if (!(ratio < static_cast<double>(DriverSchedule::kMostRows - 2))) {
    return std::nullopt;
  }
  const double nearest = std::round(ratio);
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * nearest;
  if (std::abs(ratio - nearest) <= std::max(kNoRemainder, rounding) && (nearest > 0 || duration == 0)) {
    return Steps{static_cast<std::int64_t>(nearest), false};
  }
  return Steps{static_cast<std::int64_t>(std::floor(ratio)), true};
}

// The end of the law that ends last; none if there are no laws.
std::optional<double> end_of_laws(const Profile& profile) {
  std::optional<double> end;
  for (const DriverProgram& program : profile.programs) {
    if (program.law) {
      end = std::max(end.value_or(program.law->end()), program.law->end());
    }
  }
  return end;
}

// The number of rows when they are neither listed nor given by a time step.
tl::expected<std::int64_t, Diagnostic> given_samples(const Profile& profile) {
  std::optional<std::int64_t> samples;
  for (std::size_t i = 0; i < profile.programs.size(); ++i) {
    const auto own = profile.programs[i].samples;
    if (own && samples && *own != *samples) {
      return tl::unexpected(mistake(
          profile, i, "samples",
          "differs from that of another driver: all have the same rows; give it to one, or the same to all"));
    }
    samples = samples ? samples : own;
  }
  return samples.value_or(kDefaultSamples);
}

}  // namespace

Diagnostic mistake(const Profile& profile, std::size_t driver, std::string_view key, std::string_view rule) {
  return {profile.programs[driver].place_of(key), fmt::format("{} {}", key_name(profile, driver, key), rule)};
}

tl::expected<Timing, Diagnostics> timing_of_laws(const Profile& profile,
                                                 std::optional<std::int64_t> samples) {
  const double end = *end_of_laws(profile);
  for (std::size_t i = 0; i < profile.programs.size(); ++i) {
    const DriverProgram& program = profile.programs[i];
    if (program.law && !(end > 0)) {
      return tl::unexpected(Diagnostics{
          mistake(profile, i, "law",
                  fmt::format("{} ends at {}, before time 0: nothing moves", program.law_name, end))});
    }
    if (!program.positions.empty()) {
      return tl::unexpected(Diagnostics{mistake(profile, i, "positions",
                                                "have no meaning here: another driver follows a law, and all "
                                                "move in time, with `velocity` and `acceleration`")});
    }
  }
  if (!samples) {
    const auto given = given_samples(profile);
    if (!given) {
      return tl::unexpected(Diagnostics{given.error()});
    }
    samples = *given;
  }
  return Timing{*samples, end, 0};
}

tl::expected<Timing, Diagnostics> timing_of(const Profile& profile, std::optional<std::int64_t> samples) {
  Diagnostics errors;
  auto duration = shared_time(profile, &DriverProgram::duration, "duration", errors);
  const auto laws_end = end_of_laws(profile);
  if (!duration && laws_end && *laws_end > 0) {
    duration = laws_end;
  }
  const auto time_step = shared_time(profile, &DriverProgram::time_step, "time_step", errors);
  if (!duration) {
    errors.push_back(mistake(profile, 0, "duration", "is missing: `step` needs to know how long to run"));
  }
  if (!samples && !time_step && laws_end) {
    const auto given = given_samples(profile);
    if (!given) {
      return tl::unexpected(Diagnostics{given.error()});
    }
    samples = *given;
  }
  if (!samples && !time_step) {
    errors.push_back(
        mistake(profile, 0, "time_step",
                "is missing: give the time between two rows, or the number of rows by --samples"));
  }
  if (!errors.empty()) {
    return tl::unexpected(errors);
  }
  if (samples) {
    return Timing{*samples, *duration, 0};
  }
  const auto steps = steps_in(*duration, *time_step);
  if (!steps) {
    errors.push_back(mistake(profile, 0, "time_step",
                             "is too small: the duration would have more than 2^53 rows; give a longer one"));
    return tl::unexpected(errors);
  }
  return Timing{steps->full + (steps->has_remainder ? 2 : 1), *duration, *time_step};
}

}  // namespace higherpair::io_detail
