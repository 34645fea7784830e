#pragma once

#include "higherpair/analysis/run.hpp"

#include <cstddef>
#include <memory>
#include <vector>

// The inputs of a run, which its paths vary: the coordinates of the drivers; on a curve in time the time
// alone.

namespace higherpair {

/// Sets the ends of a path on the run's curve, or of a straight one.
void set_path(const Run& run, Path& path, const std::vector<double>& from, const std::vector<double>& to);

/// A part of the path from the row before to the present one, on its line; also one that begins short of the
/// row before, or beyond a limit.
void set_part(const Run& run, Path& part, const std::vector<double>& from, const std::vector<double>& to);
[[nodiscard]] Path part_of_path(const Run& run, const std::vector<double>& from,
                                const std::vector<double>& to);

/// How far s is on the way from row to row, of which the path may be a part: 0 to 1.
[[nodiscard]] double share_at(const Path& path, double s);

/// One unit of a driver's coordinate: a radian, or the size of the mechanism.
[[nodiscard]] double driver_scale(const Run& run, std::size_t driver);

/// One unit of an input: that of the driver's coordinate; of the time, RunPosition::time_unit.
[[nodiscard]] double input_scale(const Run& run, std::size_t input);

/// The input that changes most between two positions, measured in its unit.
[[nodiscard]] std::size_t leading_input(const Run& run, const std::vector<double>& from,
                                        const std::vector<double>& to);

/// How much that input changes, in its unit.
[[nodiscard]] double distance_between(const Run& run, const std::vector<double>& from,
                                      const std::vector<double>& to);

/// One unit of the inputs in the path's coordinate.
[[nodiscard]] double unit_of(const Run& run, const Path& path);

/// The largest of the inputs at s, in the path's coordinate: the magnitude that their rounding is relative
/// to.
[[nodiscard]] double size_at(const Run& run, const Path& path, double s);

/// The least number of inner steps of a path.
[[nodiscard]] double least_steps(const Run& run, const Path& path);

/// The drivers at these inputs: a single one moves at unit rate, on a curve they move as it says, otherwise
/// several are at rest.
void set_unit_motions(const Run& run, const std::vector<double>& inputs, std::vector<DriverMotion>& motions);

/// Puts a run that is at a row on a curve in time; false where it is not quite there, or is on a curve
/// already.
[[nodiscard]] bool enter_curve(Run& run, const std::shared_ptr<const DriverCurve>& curve, double time);

/// Takes a run that is at a row off its curve: its inputs are the drivers' coordinates again.
void leave_curve(Run& run);

}  // namespace higherpair
