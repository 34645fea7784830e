#pragma once

#include "column_set.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/io/contact_report.hpp"
#include "model_data.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace higherpair {

/// Of the first driver: an angle or a length.
[[nodiscard]] Dimension driver_dimension(const Mechanism& mechanism);

/// Why the mechanism cannot be run at all: no driver, or no order of solution.
[[nodiscard]] std::optional<Error> refuse_to_start(const Model::Data& model);

/// The drivers' positions of a run, row by row. Fails for settings that are wrong. \pre the mechanism has a
/// driver.
[[nodiscard]] Result<DriverSchedule> schedule_of(const Model::Data& model, const RunSettings& settings);

/// The columns of a run. \pre the mechanism has a plan.
[[nodiscard]] Result<ColumnSet> columns_of(const Model::Data& model, const RunSettings& settings,
                                           const Units& units);

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

  [[nodiscard]] bool next_row(Row& row);

private:
  void read_drivers();
  void add_event(const RunEvent& what, double share);
  void move();
  void add_law_jumps(std::size_t first);
  void report_openings();
};

}  // namespace higherpair
