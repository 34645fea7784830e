#pragma once

#include "design_numbers.hpp"
#include "higherpair/analysis/branch_run.hpp"
#include "higherpair/analysis/direct_motion.hpp"
#include "higherpair/front/measure.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace higherpair {

/// What a task asks of every candidate; made once.
struct DesignSetup {
  DesignNumbers numbers;
  std::vector<Measure> measures;  ///< those of objectives, then those of constraints that have one
  RunSettings settings;           ///< with their columns
  DriverSchedule schedule;        ///< of the start
  int branches = 1;
  std::optional<int> start_branch;  ///< none where the start cannot be assembled
  double size = 1;                  ///< of the start [m]
};

/// The rows of a candidate, as far as it has them.
struct DesignRows {
  bool started = false;
  double missing = 0;  ///< share of rows that are not ok or to which the path is not good; 0: all is good
  std::vector<double> gaps;                   ///< of each group with two modes, the largest over all rows [m]
  std::vector<double> measured;               ///< of DesignSetup::measures, NaN where undefined
  std::vector<double> transmissions;          ///< of each constraint on one: the least |sine|
  std::vector<std::vector<Vector2d>> points;  ///< of each path: where the point is in each row, in ground
                                              ///< [m]; of a row that is missing where it was last
  std::vector<double> positions;              ///< of the first driver in the rows [rad or m]

  /// The bodies where the only driver is at a position within the rows; rates for its unit velocity. \pre
  /// nothing is missing
  [[nodiscard]] const std::vector<BodyMotion>& bodies_at(double driver);

  std::unique_ptr<const Mechanism> mechanism;  ///< of `direct`
  std::optional<DirectMotion> direct;          ///< one of these two is there, if it started
  std::optional<Run> run;
};

/// Runs the candidate x on a branch.
[[nodiscard]] DesignRows rows_of(const DesignSetup& setup, std::span<const double> x, int branch);

}  // namespace higherpair
