#pragma once

#include "higherpair/analysis/driver_motion.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace higherpair {

/// How several drivers move together in time: a curve in the space of their coordinates, bent where their
/// accelerations differ. For a run that follows it the time is the only input, as the coordinate of its
/// driver is for a run that has one.
struct DriverCurve {
  /// A driver's coordinate at a time [s], and its rates by the time.
  std::function<DriverMotion(std::size_t driver, double time)> motion;
  /// The first and the last time of the motion and those in between at which a velocity or an acceleration
  /// may jump, ascending [s].
  std::vector<double> breaks;
  std::vector<double> greatest_speeds;  ///< of each driver; not all of them 0 [rad/s or m/s]
};

}  // namespace higherpair
