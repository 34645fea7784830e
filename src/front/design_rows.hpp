#pragma once

#include "design_columns.hpp"
#include "design_extents.hpp"
#include "design_numbers.hpp"
#include "design_quantities.hpp"
#include "higherpair/analysis/branch_run.hpp"
#include "higherpair/analysis/direct_motion.hpp"
#include "higherpair/front/measure.hpp"
#include "tolerances.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace higherpair {

/// What a task asks of every candidate; made once.
struct DesignSetup {
  DesignNumbers numbers;
  std::vector<DesignQuantity> quantities;
  std::vector<Measure> measures;  ///< of the quantities that are measures
  RunSettings settings;           ///< with their columns
  DriverSchedule schedule;        ///< of the start
  int branches = 1;
  std::optional<int> start_branch;  ///< none where the start cannot be assembled
  double size = 1;                  ///< of the start [m]
  /// Of each constraint: by how much its limit has to be missed to count as 1, in the unit of tables.
  std::vector<double> scales = {};
  double cost_scale = 1;  ///< what costs are of the order of, in the unit of tables

  /// What dyads are to have to spare [m]: on the very edge of their reach rounding loses the motion.
  [[nodiscard]] double spare() const { return kSpareReach * size; }
  /// Whether they reach all the way, when this is the largest gap. Constraints ask for all of spare(), so
  /// that what an optimiser tolerates is no edge either.
  [[nodiscard]] bool closes(double gap) const { return gap < -spare() / 2; }

  /// Whether a candidate's table or events are wanted, and whether what check() has of it is.
  [[nodiscard]] bool needs_table() const;
  [[nodiscard]] bool needs_check() const;
  /// Whether it is asked how far bodies come.
  [[nodiscard]] bool needs_extents() const;
};

/// The rows of a candidate, as far as it has them.
struct DesignRows {
  bool started = false;
  double missing = 0;  ///< share of rows that are not ok or to which the path is not good; 0: all is good
  std::vector<double> gaps;      ///< of each group with two modes, the largest over all rows [m]
  std::vector<double> measured;  ///< of DesignSetup::quantities, NaN where undefined
  std::vector<std::vector<ExtentTerm>> extents;  ///< of those of DesignSetup::quantities that are extents
  std::vector<double> transmissions;             ///< of each constraint on one: the least |sine|
  std::vector<std::vector<Vector2d>> points;     ///< of each path: where the point is in each row, in ground
                                                 ///< [m]; of a row that is missing where it was last
  std::vector<double> positions;                 ///< of the first driver in the rows [rad or m]

  /// What derivatives depend on, of rows that were followed or placed by groups of any kind: to first order
  /// each gap is the sum of weights times the gaps in these rows; empty where it is largest elsewhere.
  std::vector<std::vector<WeightedRow>> gap_rows;
  std::vector<std::size_t> transmission_rows;
  std::vector<double> table;             ///< of the columns that measures need, row by row
  std::size_t table_columns = 0;         ///< how many they are
  std::vector<std::size_t> table_slots;  ///< of each measure: its column
  std::vector<double> places;            ///< of the first driver in the rows, as tables show it

  /// The bodies where the only driver is at a position within the rows; rates for its unit velocity. \pre
  /// nothing is missing, and `direct` or `run` is there
  [[nodiscard]] const std::vector<BodyMotion>& bodies_at(double driver);

  /// As at first; keeps its memory.
  void restart();

  std::unique_ptr<const Mechanism> mechanism;  ///< of `direct`
  std::optional<DirectMotion> direct;
  std::optional<Run> run;
};

}  // namespace higherpair
