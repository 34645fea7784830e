// Applies [fit] of a profile, and the options that override it, to the measured data.
#include "fit_request.hpp"

#include "front/columns/column_set.hpp"
#include "front/demands.hpp"
#include "front/pictures/column_scales.hpp"
#include "front/tolerances.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

namespace higherpair {

FitTask with_settings(FitTask task, const FitSettings& settings, Diagnostics& mistakes) {
  task.loss = settings.loss.value_or(task.loss);
  task.confidence = settings.confidence.value_or(task.confidence);
  if (settings.starts) task.starts = settings.starts;
  if (settings.seed) task.seed = settings.seed;
  if (!settings.columns.empty()) task.use = settings.columns;
  for (const std::string& name : settings.offsets) {
    FitTask::Column column;
    column.column = name;
    column.offset = true;
    column.place = {"setting offset " + name, 0, 0};
    task.columns.push_back(std::move(column));
  }
  if (std::string fault =
          first_unmet({share("confidence", task.confidence), at_least(1, "starts", task.starts.value_or(1))});
      !fault.empty()) {
    mistakes.push_back({task.place, std::move(fault)});
  }
  return task;
}

namespace {

// A deviation so small that rounding alone exceeds it.
std::string objection_to(const FitTask::Column& task, const FitColumn& column) {
  const double least = kNoiseRounding * largest_of(column.values);
  if (task.deviation.value_or(kInf) >= least) return "";
  return fmt::format(
      "{}.deviation = {:.6g} {}: the rounding of {} is more, {:.2g} {}: expected that of the instrument",
      task.path, *task.deviation, column.unit, column.name, least, column.unit);
}

}  // namespace

void apply_columns(FitData& data, Diagnostics& mistakes) {
  std::vector<std::string> names;
  for (const FitWhere& where : data.where) names.push_back(where.name);
  for (const FitColumn& column : data.columns) names.push_back(column.name);
  for (const FitTask::Column& task : data.task.columns) {
    if (std::none_of(names.begin(), names.end(),
                     [&](const std::string& name) { return matches(task.column, name); })) {
      mistakes.push_back({task.place, fmt::format("{}`{}` is no measured column; {}",
                                                  task.path.empty() ? "" : task.path + ".column: ",
                                                  task.column, suggestion(task.column, names))});
    }
    for (FitColumn& column : data.columns) {
      if (!matches(task.column, column.name)) continue;
      if (std::string objection = objection_to(task, column); !objection.empty()) {
        mistakes.push_back({task.place, std::move(objection)});
      }
      if (task.deviation) column.deviation = task.deviation;
      column.weight *= task.weight;
      column.offset = column.offset || task.offset;
    }
    for (FitWhere& where : data.where) {
      if (!matches(task.column, where.name)) continue;
      where.offset = where.offset || task.offset;
      if (task.column == where.name && (task.deviation || task.weight != 1)) {
        mistakes.push_back(
            {task.place,
             fmt::format("{}: {} says where each row is and counts as exact: only `offset` has a meaning",
                         task.path, task.column)});
      }
    }
  }
}

void find_frames(FitData& data, Diagnostics& mistakes) {
  const auto place_of_column = [&](const std::string& name) {
    const auto found = std::find_if(data.columns.begin(), data.columns.end(),
                                    [&](const FitColumn& column) { return column.name == name; });
    return static_cast<std::size_t>(found - data.columns.begin());
  };
  for (const FitTask::Frame& frame : data.task.frames) {
    const std::size_t x = place_of_column(frame.point + ".x"), y = place_of_column(frame.point + ".y");
    if (x == data.columns.size() || y == data.columns.size()) {
      mistakes.push_back({frame.place, fmt::format("{}: both {}.x and {}.y have to be measured", frame.path,
                                                   frame.point, frame.point)});
      continue;
    }
    for (const std::size_t column : {x, y}) {
      if (frame.position && data.columns[column].offset) {
        mistakes.push_back(
            {frame.place, fmt::format("{}: `position` is free, and so is the offset of {}: one of the two",
                                      frame.path, data.columns[column].name)});
      }
    }
    data.frames.push_back({frame, x, y});
  }
}

void check_count(const FitData& data, const Place& table, Diagnostics& mistakes) {
  auto unknowns = static_cast<int>(data.variables->variables.size());
  for (const FitWhere& where : data.where) unknowns += where.offset ? 1 : 0;
  for (const FitColumn& column : data.columns) unknowns += column.offset ? 1 : 0;
  for (const FitFrame& frame : data.frames) {
    unknowns += (frame.task.position ? 2 : 0) + (frame.task.turn ? 1 : 0) + (frame.task.scale ? 1 : 0);
  }
  if (data.values() < unknowns) {
    mistakes.push_back(
        {table, fmt::format("{} measured values in {} rows cannot say what {} numbers are: measure "
                            "more, or look for fewer",
                            data.values(), data.rows(), unknowns)});
  }
}

}  // namespace higherpair
