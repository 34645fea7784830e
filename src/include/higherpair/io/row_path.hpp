#pragma once

#include "higherpair/dynamics/contact_forces.hpp"
#include "higherpair/io/driver_schedule.hpp"

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

[[nodiscard]] RowPath path_of(const DriverSchedule& schedule);

}  // namespace higherpair
