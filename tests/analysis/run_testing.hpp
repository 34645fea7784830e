#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/motion_table.hpp"
#include "higherpair/io/profile_reader.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair::testing {

using Complex = std::complex<double>;
using Settings = std::vector<std::string>;

/// What a run gives, as its table shows it: in the profile's units, NaN for an empty field.
class Motion {
public:
  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] double value(std::size_t row, const std::string& column) const {
    const auto found = columns_.find(column);
    if (found == columns_.end()) {
      ADD_FAILURE() << "no column " << column;
      return NAN;
    }
    return rows_[row][found->second];
  }
  /// An angle or its rates, from degrees.
  [[nodiscard]] double radians(std::size_t row, const std::string& column) const {
    return value(row, column) * (kPi / 180);
  }
  /// The columns `name`x and `name`y: value "crank.P." is a place, "crank.P.v" a velocity.
  [[nodiscard]] Complex vector(std::size_t row, const std::string& name) const {
    return {value(row, name + "x"), value(row, name + "y")};
  }
  [[nodiscard]] const std::vector<double>& row(std::size_t row) const { return rows_[row]; }
  [[nodiscard]] const std::vector<RunEvent>& events() const { return events_; }
  [[nodiscard]] const std::string& failure() const { return failure_; }
  [[nodiscard]] std::size_t count(RowStatus status) const {
    return static_cast<std::size_t>(std::count(statuses_.begin(), statuses_.end(), status));
  }
  [[nodiscard]] RowStatus status(std::size_t row) const { return statuses_[row]; }

  friend Motion motion_of(const Profile& profile, const DriverSchedule& schedule, bool timed);

private:
  std::map<std::string, std::size_t> columns_;
  std::vector<std::vector<double>> rows_;
  std::vector<RowStatus> statuses_;
  std::vector<RunEvent> events_;
  std::string failure_;  ///< why it could not be started
};

inline Motion motion_of(const Profile& profile, const DriverSchedule& schedule, bool timed) {
  Motion motion;
  std::vector<DriverState> states(schedule.driver_count());
  std::vector<DriverMotion> drivers(schedule.driver_count());
  const auto read = [&](std::int64_t k) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      states[i] = schedule.state(k, i);
      drivers[i] = {states[i].si.position, states[i].si.velocity, states[i].si.acceleration};
    }
  };
  read(0);
  std::vector<double> first;
  for (const DriverMotion& driver : drivers) first.push_back(driver.position);
  auto run = start_run(profile.mechanism, first);
  if (!run) {
    motion.failure_ = run.error().reason;
    return motion;
  }
  MotionTable table = MotionTable::make(profile, timed).value();
  for (std::size_t i = 0; i < table.columns().size(); ++i) motion.columns_[table.columns()[i].name] = i;
  for (std::int64_t k = 0; k < schedule.size(); ++k) {
    read(k);
    move_to(*run, drivers);
    std::vector<double> row;
    for (const Cell& cell : table.cells(run->row, states, timed ? schedule.time(k) : 0)) {
      const auto* number = std::get_if<double>(&cell);
      row.push_back(number != nullptr ? *number : std::numeric_limits<double>::quiet_NaN());
    }
    motion.rows_.push_back(std::move(row));
    motion.statuses_.push_back(run->row.status);
    motion.events_.insert(motion.events_.end(), run->events.begin(), run->events.end());
  }
  return motion;
}

/// What the commands `analyze` and `step` write for a profile.
inline Motion analyze(const Profile& profile) {
  return motion_of(profile, DriverSchedule::analyze(profile).value(), false);
}
inline Motion step(const Profile& profile) {
  return motion_of(profile, DriverSchedule::step(profile).value(), true);
}

/// A profile of the folder profiles/, with settings "PATH=VALUE".
inline Profile shipped(const std::string& name, const Settings& settings = {}) {
  auto profile =
      read_profile_file(std::string(HIGHERPAIR_SOURCE_DIR "/profiles/") + name + ".toml", settings);
  if (!profile) {
    for (const Diagnostic& diagnostic : profile.error()) ADD_FAILURE() << to_string(diagnostic);
    return {};
  }
  return *profile;
}

inline Profile profile_of(const std::string& text, const Settings& settings = {}) {
  auto profile = read_profile_text(text, "test.toml", settings);
  if (!profile) {
    for (const Diagnostic& diagnostic : profile.error()) ADD_FAILURE() << to_string(diagnostic);
    return {};
  }
  return *profile;
}

/// Every row has the status `ok`.
inline void expect_all_ok(const Motion& motion) {
  EXPECT_EQ(motion.failure(), "");
  EXPECT_GT(motion.size(), 0U);
  EXPECT_EQ(motion.count(RowStatus::kOk), motion.size());
}

/// Of the two points at the given distances from A and B the one to the left of AB (right: side -1).
inline Complex meeting_point(Complex A, double a, Complex B, double b, double side) {
  const double c = std::abs(B - A);
  const double along = (a * a - b * b + c * c) / (2 * c);
  return A + (B - A) / c * Complex(along, side * std::sqrt(a * a - along * along));
}

}  // namespace higherpair::testing
