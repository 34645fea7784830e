#pragma once

#include "higherpair/dynamics/contact_forces.hpp"
#include "higherpair/io/driver_schedule.hpp"

#include <functional>

namespace higherpair {

/// The path that the drivers take through the rows of a schedule: of equally spaced rows its parameter is the
/// number of the row, of positions that are given one by one the way that the drivers have gone, in time the
/// time [s].
struct RowPath {
  DriverPath path;
  std::function<double(double)> row;  ///< number of the row of a parameter, with a fraction between two rows
};

[[nodiscard]] RowPath path_of(const DriverSchedule& schedule);

}  // namespace higherpair
