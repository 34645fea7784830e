#pragma once

#include "group_solver.hpp"
#include "higherpair/analysis/run.hpp"

#include <vector>

namespace higherpair {

/// Sets the ends of a path.
void set_path(Path& path, const std::vector<double>& from, const std::vector<double>& to);

struct StepResult {
  enum Kind { kOk, kLost, kDisagrees } kind = kOk;
  std::size_t group = 0;               ///< which failed
  std::optional<LimitPosition> limit;  ///< of a tracked pair, its u the driver's coordinate
};

/// Tries a step of `h` from run.state, which stands at s, into run.trial; kOk only where every group agrees
/// with its prediction, or crosses over to its other branch where branches cross.
[[nodiscard]] StepResult try_step(Run& run, const Path& path, double s, double h);

/// What counts as one unit of a driver's coordinate: a radian, or the size of the mechanism.
[[nodiscard]] double driver_scale(const Run& run, std::size_t driver);

/// The first driver's coordinate at s.
[[nodiscard]] double driver_at(const Path& path, double s);

/// Places all groups and sets their rates in run.trial, `x` beyond run.state, which stands at s; in the modes
/// of run.state and without asking whether they agree with a prediction.
[[nodiscard]] bool solve_at(Run& run, const Path& path, double s, double x);

/// Names the joint or contact at which an event of a group happens.
void name_item(const Run& run, std::size_t g, RunEvent& event);

/// Follows the path; false if the branch is lost on the way (run.held is then false and an event says where).
/// Sets run.drivers to where run.state stands, and run.between where the end itself is in run.trial.
bool follow(Run& run, const Path& path);

/// Looks for the branch held last at the drivers' positions; true if it is there again.
bool resume(Run& run, const std::vector<double>& drivers);

}  // namespace higherpair
