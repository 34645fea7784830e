#include "design_runs.hpp"

#include "front/analysis_impl.hpp"
#include "higherpair/io/row_path.hpp"
#include "higherpair/numeric/contains.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

double count_of(const std::vector<EventType>& types, const std::vector<Event>& events) {
  return static_cast<double>(std::count_if(events.begin(), events.end(),
                                           [&](const Event& event) { return contains(types, event.type); }));
}

// Follows the positions only, without a table.
void follow(Run& run, const DriverSchedule& schedule, RowReader& reader) {
  int limits = 0;
  for (std::int64_t k = 0; k < schedule.size(); ++k) {
    const std::vector<DriverMotion> motions = drivers_in(schedule, k);
    move_to_row(run, schedule, k, motions, [&](double from, double to) {
      limits +=
          static_cast<int>(std::count_if(run.events.begin(), run.events.end(), [&](const RunEvent& event) {
            return is_fault(event.type, k, std::lerp(from, to, event.share), schedule.size() - 1);
          }));
    });
    const bool there = run.row.status != RowStatus::kNotAssemblable;
    reader.take(run.row.bodies, there, motions.front().position, run.row.status);
    there ? reader.take_gaps(run.row.bodies) : reader.take_gaps(closure_gaps(run, positions_in(schedule, k)));
  }
  reader.finish(limits);
}

// Records the remaining rows, which are not computed, as not assemblable.
void give_up(const DriverSchedule& schedule, std::int64_t row, const std::vector<BodyMotion>& bodies,
             RowReader& reader) {
  for (; row < schedule.size(); ++row) {
    reader.take(bodies, false, schedule.state(row).si.position, RowStatus::kNotAssemblable);
  }
}

// A run of a candidate with the columns of the measures; none where they cannot be computed.
std::optional<Analysis> analysis_of(const DesignSetup& setup, const DesignCandidate& candidate, Run run) {
  const std::shared_ptr<const Model::Data>& data = candidate.data;
  auto columns = columns_of(*data, setup.settings, data->profile.units);
  if (!columns) {
    return std::nullopt;
  }
  return Analysis(make_impl(data, data->profile.units, candidate.schedule, std::move(run),
                            *std::move(columns), setup.settings.forces));
}

// Runs the analysis through its rows.
void take_rows(Analysis& analysis, WhenLost when_lost, RowReader& reader, MeasureSet& measures,
               DesignRows& rows) {
  Row row;
  while (analysis.next(row)) {
    const Run& at = analysis.impl().run;
    const std::vector<double> drivers = positions_in(analysis.impl().schedule, row.number);
    const bool there = row.status != RowStatus::kNotAssemblable;
    measures.add(row);
    rows.table.insert(rows.table.end(), row.values.begin(), row.values.end());
    rows.places.push_back(analysis.impl().schedule.state(row.number).profile.position);
    reader.take(at.row.bodies, there, drivers.front(), row.status);
    there ? reader.take_gaps(at.row.bodies) : reader.take_gaps(closure_gaps(at, drivers));
    if (!there && when_lost == WhenLost::kGiveUp) {
      give_up(analysis.impl().schedule, row.number + 1, at.row.bodies, reader);
      break;
    }
  }
}

// The numbers of a column that is followed begin with `first`.
void take_followed(const ColumnQuantity& column, std::size_t first, DesignRows& rows) {
  const std::size_t slot = rows.table_slots[column.measure];
  const auto at = rows_at(column.at, rows.places);
  for (std::size_t k = 0; k < at.size(); ++k) {
    if (at[k]) rows.measured[first + k] = rows.table[*at[k] * rows.table_columns + slot];
  }
}

bool measure(const DesignSetup& setup, const DesignCandidate& candidate, Run run, WhenLost when_lost,
             RowReader& reader, DesignRows& rows) {
  std::optional<Analysis> analysis = analysis_of(setup, candidate, std::move(run));
  if (!analysis) {
    return false;
  }
  MeasureSet measures(setup.measures, analysis->columns());
  for (const Measure& one : setup.measures) {
    rows.table_slots.push_back(column_slot(analysis->columns(), one.column));
  }
  rows.table_columns = analysis->columns().size();
  take_rows(*analysis, when_lost, reader, measures, rows);
  rows.measured.assign(setup.numbers_measured, kNoValue);
  for (const DesignQuantity& quantity : setup.quantities) {
    double& number = rows.measured[quantity.first];
    if (const auto* events = quantity.as<DesignTask::Events>()) {
      number = count_of(events->types, analysis->events());
    } else if (const auto* column = quantity.as<ColumnQuantity>()) {
      if (column->at.empty()) {
        number = measures.value(column->measure).value;
      } else {
        take_followed(*column, quantity.first, rows);
      }
    }
  }
  const auto ends = std::count_if(
      analysis->events().begin(), analysis->events().end(),
      [](const Event& event) { return loses_motion(event.type) || event.type == EventType::kOverlap; });
  reader.finish(analysis->good() ? 0 : static_cast<int>(ends));
  rows.run = analysis->impl().run;
  return true;
}

}  // namespace

void follow_rows(const DesignSetup& setup, const DesignCandidate& candidate, int branch, WhenLost when_lost,
                 DesignRows& rows) {
  rows.restart();
  RowReader reader(setup, *candidate.mechanism, candidate.plan, rows);
  const std::vector<double> first = candidate.schedule.first_positions();
  const RunModel model = make_run_model(*candidate.mechanism, candidate.plan);
  auto run = start_on_branch(model, first, branch);
  if (!run) {
    rows.missing = 1;
    reader.take_gaps(first_closure_gaps(model, first, branch));
    return;
  }
  rows.started = true;
  if (!setup.needs_table()) {
    follow(*run, candidate.schedule, reader);
    rows.run = *std::move(run);
  } else {
    rows.started = measure(setup, candidate, *std::move(run), when_lost, reader, rows);
  }
}

}  // namespace higherpair
