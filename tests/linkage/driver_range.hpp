#pragma once

#include "higherpair/linkage/angles.hpp"
#include "higherpair/linkage/reach.hpp"

#include <array>

namespace higherpair {

/// Motion of a link's direction.
struct AngleMotion {
  double theta = 0;  ///< [rad]
  double omega = 0;  ///< [rad/s]
  double alpha = 0;  ///< [rad/s²]
};

/// Motion of a variable length: a slider along its guide.
struct SlideMotion {
  double r = 0;       ///< [m]
  double r_dot = 0;   ///< [m/s]
  double r_ddot = 0;  ///< [m/s²]
};

enum class DriverReach {
  kNever,     ///< no position of the driver can be assembled
  kRanges,    ///< the driver moves between limit positions; every end of a range is a dead point
  kFullTurn,  ///< every angle can be assembled (a change point may lie among them)
};

/// A closed interval of driver positions [rad] or [m]; a single position where begin == end.
struct DriverInterval {
  double begin = 0;  ///< angles: in (-π, π]
  double end = 0;    ///< angles: in [begin, begin + 2π]
};

/// Where a driver can go. The limits are the same for both assembly modes.
struct DriverRange {
  DriverReach reach = DriverReach::kNever;
  int count = 0;                              ///< how many intervals: 1 or 2 for kRanges, else 0
  std::array<DriverInterval, 2> intervals{};  ///< they do not touch; the first begins with the smaller value
                                              ///< before angles are brought into (-π, π]
};

/// The range of an angle theta = centre + ψ that can be assembled iff stretch(ψ) >= 0 and fold(ψ) >= 0.
/// stretch falls from ψ = 0 to ±π, fold rises, and their sum is positive. The limits are computed by
/// `root_angle`.
[[nodiscard]] DriverRange angle_range(const CosineLine<double>& stretch, const CosineLine<double>& fold,
                                      double centre);

/// The range of a length r that can be assembled iff inner <= r² <= outer.
[[nodiscard]] DriverRange slide_range(double inner, double outer);

/// The status at a driver's angle that was given in ground. The difference theta - theta1 carries a rounding
/// error of each, which the kernel cannot know because it receives the angle as a unit vector.
[[nodiscard]] LinkageStatus status_at_angle(Reach<double> reach, double theta, double theta1);

}  // namespace higherpair
