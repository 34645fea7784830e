#pragma once

#include "design_columns.hpp"
#include "design_extents.hpp"
#include "design_numbers.hpp"
#include "design_placement.hpp"
#include "design_quantities.hpp"
#include "front/tolerances.hpp"
#include "higherpair/analysis/direct_motion.hpp"
#include "higherpair/front/measure.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace higherpair {

/// Values of a task's objectives and constraints for one candidate, in the units of tables.
struct DesignScore {
  bool started = false;
  std::vector<double> objectives;  ///< for each of DesignTask::objectives: a path's sum of squares or a
                                   ///< measure's value; NaN where undefined
  /// For each objective that is a free path: a point p of the path is placed at first · p + second [m].
  std::vector<std::optional<std::pair<PathPlacement::Complex, PathPlacement::Complex>>> placements;
  std::vector<double> constraints;  ///< for each of DesignTask::constraints: the value that is limited
  double missing = 0;               ///< DesignRows::missing
};

/// Where the numbers of an objective begin among those of all objectives.
struct ObjectivePlace {
  Eigen::Index residual = 0;  ///< of the problem
  std::size_t path = 0;       ///< among the paths, if it is one
  std::size_t quantity = 0;   ///< in DesignSetup::quantities, if it is no path
};

/// Where the numbers of a constraint are.
struct ConstraintPlace {
  std::optional<Eigen::Index> above, below;  ///< the problem's constraints for its limits
  std::size_t transmission = 0;              ///< among the transmission constraints, if it is one
  std::size_t quantity = 0;                  ///< in DesignSetup::quantities, if it is none
};

/// What a task asks of every candidate; made once.
struct DesignSetup {
  DesignNumbers numbers;
  std::vector<DesignQuantity> quantities;
  std::vector<Measure> measures;     ///< of the quantities that are measures
  std::size_t numbers_measured = 0;  ///< of all quantities
  RunSettings settings;              ///< of a run with the columns of the measures
  DriverSchedule schedule;           ///< of the start values
  int branches = 1;
  std::size_t closures = 0;  ///< number of groups with two modes, each with a constraint on its closure
  std::optional<int> start_branch = {};  ///< none where the start values cannot be assembled
  DesignScore start_score = {};          ///< on that branch, else on the first
  double size = 1;                       ///< of the mechanism with the start values [m]
  std::vector<ObjectivePlace> objective_places = {};
  std::vector<ConstraintPlace> constraint_places = {};
  Eigen::Index residuals = 0;    ///< number of residuals of the problem
  Eigen::Index constraints = 0;  ///< the same: of closures, of the path as a whole, of limits
  /// For each constraint: by how much its limit must be missed to count as 1, in the unit of tables.
  std::vector<double> scales = {};
  double cost_scale = 1;  ///< order of magnitude of the cost, in the unit of tables
  /// For each constraint: whether no variable changes it near the start. It holds at its limit, where no
  /// search could bring it to the inside.
  std::vector<bool> idle = {};

  /// Margin required of dyads [m]: on the very edge of their reach rounding loses the motion.
  [[nodiscard]] double spare() const { return kSpareReach * size; }
  /// By how much a constraint's limit may be missed by rounding, in the unit of tables.
  [[nodiscard]] double slack(std::size_t constraint) const {
    return kHoldsLimit * std::max(1.0, scales[constraint]);
  }
  /// Whether the dyads can be closed all the way, given the largest gap. Constraints require the whole of
  /// spare(), so that the optimiser's tolerance does not lead to the edge either.
  [[nodiscard]] bool closes(double gap) const { return gap < -spare() / 2; }

  /// Whether the table or events of a candidate are needed, and whether figures of check() are.
  [[nodiscard]] bool needs_table() const {
    return has_any<ColumnQuantity>(quantities) || has_any<DesignTask::Events>(quantities);
  }
  [[nodiscard]] bool needs_check() const { return has_any<DesignTask::Figure>(quantities); }
  /// Whether the extents of bodies are needed.
  [[nodiscard]] bool needs_extents() const { return has_any<DesignTask::Extent>(quantities); }
};

/// The rows of a candidate, as far as they exist.
struct DesignRows {
  bool started = false;
  double missing = 0;  ///< fraction of rows that are not ok, plus half a row for each limit; 0: all is good
  std::vector<double> gaps;      ///< for each group with two modes, the largest over all rows [m]
  std::vector<double> measured;  ///< of DesignSetup::quantities, NaN where undefined
  std::vector<std::vector<ExtentTerm>> extents;  ///< for each of DesignSetup::quantities that is an extent
  std::vector<double> transmissions;             ///< for each transmission constraint: the least |sine|
  std::vector<std::vector<Vector2d>> points;     ///< for each path: the position of the point in each row, in
                                                 ///< ground [m]; in a missing row, its last position
  std::vector<double> positions;                 ///< of the first driver in each row [rad or m]

  /// What derivatives depend on, for rows that were followed, or positioned by groups of any kind. To first
  /// order each gap is the weighted sum of the gaps in these rows; empty where it is largest between rows.
  std::vector<std::vector<WeightedRow>> gap_rows;
  std::vector<std::size_t> transmission_rows;
  std::vector<double> table;             ///< columns needed by measures, row by row
  std::size_t table_columns = 0;         ///< number of these columns
  std::vector<std::size_t> table_slots;  ///< for each measure: its column
  std::vector<double> places;            ///< position of the first driver in each row, as in tables

  /// The bodies at a position of the only driver within the rows; rates for unit velocity of the driver. \pre
  /// nothing is missing, and `direct` or `run` is set
  [[nodiscard]] const std::vector<BodyMotion>& bodies_at(double driver);

  /// Forgets the candidate, but keeps the memory.
  void restart();

  std::unique_ptr<const Mechanism> mechanism;  ///< used by `direct`
  std::optional<DirectMotion> direct;
  std::optional<Run> run;
};

}  // namespace higherpair
