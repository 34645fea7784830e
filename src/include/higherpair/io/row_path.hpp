#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/dynamics/contact_forces.hpp"
#include "higherpair/io/driver_schedule.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

namespace higherpair {

/// The path that the drivers take through the rows of a schedule: its parameter is the number of the row for
/// equally spaced rows, the distance that the drivers have travelled for listed positions, and the time [s]
/// for rows in time.
struct RowPath {
  DriverPath path;
  std::function<double(double)> row;  ///< number of the row at a parameter, fractional between two rows
};

/// The motion of every driver in a row.
[[nodiscard]] std::vector<DriverMotion> drivers_in(const DriverSchedule& schedule, std::int64_t row);

/// Their positions alone.
[[nodiscard]] std::vector<double> positions_in(const DriverSchedule& schedule, std::int64_t row);

/// Calls go(drivers, from, to) for every part of the drivers' path from the row before to a row on which none
/// of them turns back, in order: they may pass something on such a part and pass it again on the next one.
/// `drivers` are those at the end of the part, which is the row itself for the last one; `from` and `to` are
/// the fractions of the time between the two rows at its ends. \param at_row  drivers_in(schedule, row)
template <class Go>
void for_each_part(const DriverSchedule& schedule, std::int64_t row, const std::vector<DriverMotion>& at_row,
                   Go&& go) {
  double from = 0;
  for (const DriverSchedule::TurningPoint& turning : schedule.turning_points(row)) {
    go(std::vector<DriverMotion>{turning.si}, from, turning.share);
    from = turning.share;
  }
  go(at_row, from, 1.0);
}

/// Moves a run from the row before to a row, part by part, and calls seen(from, to) after each of them, with
/// the fractions of the time between the two rows at its ends. \param at_row  drivers_in(schedule, row)
template <class Seen>
void move_to_row(Run& run, const DriverSchedule& schedule, std::int64_t row,
                 const std::vector<DriverMotion>& at_row, Seen&& seen) {
  if (schedule.curve()) {
    move_along(run, schedule.curve(), schedule.time_si(std::max<std::int64_t>(row - 1, 0)),
               schedule.time_si(row), at_row);
    seen(0.0, 1.0);
    return;
  }
  for_each_part(schedule, row, at_row, [&](const std::vector<DriverMotion>& drivers, double from, double to) {
    move_to(run, drivers);
    seen(from, to);
  });
}

/// The same without being told of the parts.
void move_to_row(Run& run, const DriverSchedule& schedule, std::int64_t row,
                 const std::vector<DriverMotion>& at_row);

[[nodiscard]] RowPath path_of(const DriverSchedule& schedule);

}  // namespace higherpair
