#pragma once

#include "column_set.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/io/contact_report.hpp"
#include "higherpair/io/coordinate.hpp"
#include "model_data.hpp"
#include "row_scout.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace higherpair {

/// Why the mechanism cannot be run at all: no driver, or no order of solution.
[[nodiscard]] std::optional<Error> refuse_to_start(const Model::Data& model);

/// The drivers' positions of a run, row by row. Fails for settings that are wrong. \pre the mechanism has a
/// driver.
[[nodiscard]] Result<DriverSchedule> schedule_of(const Model::Data& model, const RunSettings& settings);

/// The columns of a run. \pre the mechanism has a plan.
[[nodiscard]] Result<ColumnSet> columns_of(const Model::Data& model, const RunSettings& settings,
                                           const Units& units);

/// A run goes on at the beginning of every block of so many rows as a scout has come there (RowScout), unless
/// the scout is in another state: rows do not depend on those of the blocks before, and blocks worked out on
/// several threads are the same to the last bit.
inline constexpr std::int64_t kBlockRows = 4096;

/// The row loop: from the schedule of the drivers to the row of a table, with what happens on the path.
struct Analysis::Impl {
  std::shared_ptr<const Model::Data> model;
  Units units;
  DriverSchedule schedule;
  Run run;
  ColumnSet columns;
  std::optional<InverseDynamics> dynamics;  ///< of a run with forces
  std::optional<Run> start;                 ///< the same, at the first row
  std::int64_t next = 0;                    ///< row
  std::vector<DriverState> drivers;         ///< in the row
  std::vector<DriverMotion> motions;        ///< the same
  std::vector<Event> events;
  bool good = true;
  Diagnostics notes;
  ContactForceReport contacts;           ///< of a run with forces, after its last row
  const Reactions* reactions = nullptr;  ///< in the row, of a run with forces

  RowHistory history = {};             ///< up to the row
  std::optional<RowScout> scout = {};  ///< of a run of several blocks that gives its rows in order

  [[nodiscard]] bool next_row(Row& row);

  /// A copy that works out blocks: the events and all that is known after the last row are not its concern.
  [[nodiscard]] std::unique_ptr<Impl> make_worker() const;
  /// The next row is the first of a block; `from` is how it is at the row before.
  void begin_at(std::int64_t row, const RunPlace& from);
  /// What a worker has found in the block of rows from `next` up to `end`.
  void add_block(std::vector<Event> found, bool all_good, std::int64_t end);

  /// Of the events up to a row those that keep the path there from being good: limit positions and ends of
  /// curves before the row itself, and overlaps.
  [[nodiscard]] std::vector<Event> faults_before(std::int64_t row) const;

private:
  void begin_block();
  void read_drivers();
  void add_event(const RunEvent& what, double share);
  [[nodiscard]] Event opening_event(const ContactForceReport::Opening& opening) const;
  void move();
  void add_law_jumps();
  void report_openings();
};

}  // namespace higherpair
