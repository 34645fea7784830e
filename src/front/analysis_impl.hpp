#pragma once

#include "front/columns/column_set.hpp"
#include "front/columns/row_scout.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/io/contact_report.hpp"
#include "higherpair/io/coordinate.hpp"
#include "model_data.hpp"

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace higherpair {

/// Why the mechanism cannot be run at all: no driver, or no order of solution.
[[nodiscard]] std::optional<Error> refuse_to_start(const Model::Data& model);

/// Whether a profile could have this position of a driver.
[[nodiscard]] bool can_be_position(double position, const Dimension& of_driver, const Units& units);
/// The farthest one, as messages name it.
[[nodiscard]] std::string_view farthest_position(const Dimension& of_driver);

/// Positions of the drivers in each row of a run. Fails for invalid settings. \pre the mechanism has a
/// driver.
[[nodiscard]] Result<DriverSchedule> schedule_of(const Model::Data& model, const RunSettings& settings);

/// Whether an event on the path to `row` makes a run up to `last_row` bad: an overlap, and a lost motion,
/// except at the very ends of the run.
[[nodiscard]] bool is_fault(EventType type, std::int64_t row, double share, std::int64_t last_row);

/// The columns of a run. \pre the mechanism has a plan.
[[nodiscard]] Result<ColumnSet> columns_of(const Model::Data& model, const RunSettings& settings,
                                           const Units& units);

/// The settings with columns of forces and jerk only where a glob matches nothing else; none if a glob
/// matches no column at all. \pre the mechanism has a plan.
[[nodiscard]] std::optional<RunSettings> settings_with_columns(const Model::Data& model,
                                                               const RunSettings& settings);

/// Rows per block. At the beginning of each block a run continues from the state in which a scout (RowScout)
/// has arrived there, unless that state differs from its own. Rows then do not depend on the blocks before
/// theirs, and blocks computed on several threads are the same to the last bit.
inline constexpr std::int64_t kBlockRows = 4096;

/// The largest moment about the pin of an idle body that nothing balances, and the row where it is.
struct IdleMoment {
  double moment = 0;  ///< [N m]; 0: the body is in equilibrium
  std::int64_t row = 0;
};

/// Rows whose conditions are not met to within the tolerance.
struct InexactRows {
  std::int64_t count = 0;
  std::int64_t first = 0;
  double residual = 0;  ///< the largest [m]
};

/// What is found in rows besides their values.
struct RowsFound {
  std::vector<Event> events = {};
  bool good = true;
  std::vector<IdleMoment> idle = {};  ///< of Mechanism::bodies; only with forces
  InexactRows inexact = {};

  /// Adds what is found in later rows.
  void add(RowsFound later);
};

/// The row loop: from the schedule of the drivers to the rows of a table and the events on the path.
struct Analysis::Impl {
  std::shared_ptr<const Model::Data> model;
  Units units;
  DriverSchedule schedule;
  Run run;
  ColumnSet columns;
  std::optional<InverseDynamics> dynamics = {};  ///< only with forces
  std::optional<Run> start = {};                 ///< the run at its first row; only with forces
  std::int64_t next = 0;                         ///< number of the next row
  std::vector<DriverState> drivers = {};         ///< in the current row
  std::vector<DriverMotion> motions = {};        ///< in the current row
  RowsFound found = {};                          ///< in the rows before `next`
  Diagnostics notes = {};                        ///< from the start
  std::vector<std::size_t> open = {};            ///< contacts that may part and are open in the first row
  ContactForceReport contacts = {};              ///< only with forces, after the last row
  const Reactions* reactions = nullptr;          ///< in the current row; only with forces

  RowHistory history = {};             ///< up to the current row
  std::optional<RowScout> scout = {};  ///< only of a run of several blocks whose rows are computed in order

  [[nodiscard]] bool next_row(Row& row);

  /// A copy that computes single blocks; what is known only after the last row is left to the original.
  [[nodiscard]] std::unique_ptr<Impl> make_worker() const;
  /// Continues with `row`, the first of a block; `from` is the state at the row before it.
  void begin_at(std::int64_t row, const RunPlace& from);
  /// Adds what a worker has found in the rows from `next` up to, but not including, `end`.
  void add_block(RowsFound of_block, std::int64_t end);

  /// The events up to a row that make the path to it bad: overlaps, and limit positions and ends of curves
  /// before the row itself.
  [[nodiscard]] std::vector<Event> faults_before(std::int64_t row) const;

private:
  void begin_block();
  void read_drivers();
  void note_idle_moments();
  void note_status(RowStatus status);
  void add_event(const RunEvent& what, double share);
  [[nodiscard]] Event opening_event(const ContactForceReport::Opening& opening) const;
  void move();
  void add_law_jumps();
  bool advance(std::int64_t end);
  bool report_openings();
};

/// A run before its first row, from the first position on.
[[nodiscard]] std::unique_ptr<Analysis::Impl> make_impl(std::shared_ptr<const Model::Data> model,
                                                        const Units& units, DriverSchedule schedule, Run run,
                                                        ColumnSet columns, bool forces);

}  // namespace higherpair
