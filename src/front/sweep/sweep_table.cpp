// The columns of a sweep's table, and how its variants are run.
#include "front/analysis_impl.hpp"
#include "front/run_settings.hpp"
#include "sweep_data.hpp"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

Column number_column(std::string name, std::string unit = "1") {
  return {std::move(name), std::move(unit), {}};
}

Result<RunSettings> settings_for_rows(const Model& model, const SweepTask& task, RunSettings settings) {
  if (auto refusal = refuse_to_start(model.data())) {
    return tl::unexpected(*std::move(refusal));
  }
  settings.columns = task.rows;
  if (auto made = settings_with_columns(model.data(), settings)) {
    return *std::move(made);
  }
  const Diagnostic wanted = columns_of(model.data(), settings, model.units()).error().diagnostics.front();
  return wrong(place_of(task, model),
               fmt::format("sweep.rows: {} ({})", wanted.message, wanted.place.source));
}

void add_results(Sweep::Data& data) {
  const MeasureSet set(data.measures, data.run_columns);
  for (std::size_t i = 0; i < data.task.results.size(); ++i) {
    data.columns.push_back(number_column(data.task.results[i].name, set.unit(i)));
    if (data.task.results[i].where) {
      data.columns.push_back(number_column(data.task.results[i].name + ".where", set.where_unit()));
    }
  }
  if (data.task.counts) {
    for (int status = 0; status < kNotStarted; ++status) {
      data.columns.push_back(number_column(fmt::format("rows.{}", name_of(static_cast<RowStatus>(status)))));
    }
    for (std::size_t type = 0; type < kEventTypeCount; ++type) {
      data.columns.push_back(number_column(fmt::format("events.{}", name_of(static_cast<EventType>(type)))));
    }
  }
}

void add_row_columns(Sweep::Data& data) {
  for (std::size_t i = 0; i < data.run_columns.size(); ++i) {
    if (data.run_columns[i].name != "status") {
      data.row_slots.push_back(i);
      data.columns.push_back(data.run_columns[i]);
    }
  }
}

// About the same work in every block, whatever the length of a run.
std::int64_t variants_in_block(std::int64_t rows) {
  constexpr std::int64_t kRows = std::int64_t{1} << 18;
  constexpr std::int64_t kMost = 1024;
  return std::clamp<std::int64_t>(kRows / std::max<std::int64_t>(rows, 1), 1, kMost);
}

}  // namespace

std::span<const std::string_view> sweep_statuses() {
  static const auto names = [] {
    std::array<std::string_view, kSweepStatusCount> all;
    for (std::size_t i = 0; i < kNotStarted; ++i) {
      all[i] = name_of(static_cast<RowStatus>(i));
    }
    all[kNotStarted] = "not_started";
    return all;
  }();
  return names;
}

Place place_of(const SweepTask& task, const Model& model) {
  return task.place.source.empty() ? Place{model.profile().source} : task.place;
}

Result<Sweep::Data> sweep_table(const Model& model, const SweepSettings& settings) {
  const SweepTask& task = settings.task ? *settings.task : *model.profile().sweep;
  Sweep::Data data = {model, task, Variants(task.plan), {}, {}, {}, {}, {}, {}, 0, 0, 1, {}, {}};
  for (const SweepVariable& variable : task.plan.variables) {
    data.paths.insert(data.paths.end(), variable.paths.begin(), variable.paths.end());
  }
  for (const SweepResult& result : task.results) {
    data.measures.push_back(result.measure);
  }
  const RunSettings run = run_settings(settings, task.in_time);
  auto made =
      data.writes_rows() ? settings_for_rows(model, task, run) : settings_for(model, data.measures, run);
  if (!made) {
    return tl::unexpected(std::move(made.error()));
  }
  data.run = *std::move(made);
  const auto schedule = schedule_of(model.data(), data.run);
  if (!schedule) {
    return tl::unexpected(schedule.error());
  }
  data.block_variants = variants_in_block(schedule->size());
  const auto set = columns_of(model.data(), data.run, model.units());
  if (!set) {
    return tl::unexpected(set.error());
  }
  data.run_columns = set->columns();
  data.columns.push_back(number_column("variant"));
  for (std::size_t i = 0; i < task.plan.variables.size(); ++i) {
    data.columns.push_back(number_column(task.plan.variables[i].name, task.units[i]));
  }
  data.writes_rows() ? add_row_columns(data) : add_results(data);
  data.columns.push_back({"status", "", sweep_statuses()});
  std::vector<std::string> names;
  for (const Column& column : data.columns) names.push_back(column.name);
  if (const std::string* name = repeated(names)) {
    return wrong(place_of(task, model),
                 fmt::format("sweep: two columns would be called `{}`; choose another name", *name));
  }
  return data;
}

}  // namespace higherpair
