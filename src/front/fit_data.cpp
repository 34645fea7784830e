#include "fit_data.hpp"

#include "analysis_impl.hpp"
#include "higherpair/front/measure.hpp"
#include "higherpair/io/suggestion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace higherpair {
namespace {

bool matches_any(const std::vector<std::string>& globs, const std::string& name) {
  return std::any_of(globs.begin(), globs.end(),
                     [&](const std::string& glob) { return matches(glob, name); });
}

// What tables say of a row besides its motion.
bool is_aside(const std::string& name) {
  const bool effort = name.ends_with(".effort") || name.ends_with(".effort_check");
  return name == "status" || name == "residual" || name == "time" || name == "driver" ||
         (name.starts_with("driver.") && !effort) || name.ends_with(".linkage");
}

class DataReader {
public:
  DataReader(const Model& model, const MeasuredTable& measured, const FitSettings& settings)
      : measured_(measured),
        settings_(settings),
        data_{model,
              model.profile().design,
              fit_task_of(*model.data().document, model.profile()),
              {},
              measured.lines,
              {},
              {},
              {},
              {},
              {},
              {},
              {},
              {}} {}

  Result<FitData> read() {
    apply_settings();
    read_where();
    std::vector<const MeasuredColumn*> used = used_columns();
    if (!mistakes_.empty()) return refuse();
    if (auto settings = settings_of(used)) {
      data_.settings = *std::move(settings);
    } else {
      return tl::unexpected(std::move(settings.error()));
    }
    read_columns(used);
    if (mistakes_.empty()) read_frames();
    check_tasks();
    check_count();
    if (!mistakes_.empty()) return refuse();
    return std::move(data_);
  }

private:
  tl::unexpected<Error> refuse() { return tl::unexpected(Error{ErrorKind::kInput, std::move(mistakes_)}); }
  void fail(const Place& place, std::string message) { mistakes_.push_back({place, std::move(message)}); }
  [[nodiscard]] Place table() const { return {measured_.source, 0, 0}; }

  void apply_settings() {
    FitTask& task = data_.task;
    task.loss = settings_.loss.value_or(task.loss);
    task.confidence = settings_.confidence.value_or(task.confidence);
    if (settings_.starts) task.starts = settings_.starts;
    if (settings_.seed) task.seed = settings_.seed;
    if (!settings_.columns.empty()) task.use = settings_.columns;
    for (const std::string& name : settings_.offsets) {
      FitTask::Column column;
      column.column = name;
      column.offset = true;
      column.place = {"--offset " + name, 0, 0};
      task.columns.push_back(std::move(column));
    }
    if (!(task.confidence > 0 && task.confidence < 1)) {
      fail(task.place, fmt::format("confidence = {}: must be between 0 and 1", task.confidence));
    }
  }

  [[nodiscard]] const MeasuredColumn* column_of(const std::string& name) const {
    const auto found = std::find_if(measured_.columns.begin(), measured_.columns.end(),
                                    [&](const MeasuredColumn& column) { return column.name == name; });
    return found == measured_.columns.end() ? nullptr : &*found;
  }

  // A table that has both is one of a run in time: then time says where its rows are.
  void read_where() {
    const Mechanism& mechanism = data_.model.mechanism();
    std::vector<std::string> drivers;
    for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) drivers.push_back(driver_column(mechanism, i));
    data_.settings.in_time = column_of("time") != nullptr;
    const std::vector<std::string> names =
        data_.settings.in_time ? std::vector<std::string>{"time"} : drivers;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const MeasuredColumn* column = column_of(names[i]);
      if (column == nullptr) {
        std::vector<std::string> present;
        for (const MeasuredColumn& other : measured_.columns) present.push_back(other.name);
        const std::string meant = did_you_mean(names[i], present);
        fail(table(),
             fmt::format("has no column `{}`{}, which says where each row is{}", names[i],
                         names.size() == 1 ? " and no `time`" : "", meant.empty() ? "" : "; " + meant));
        continue;
      }
      const Dimension dimension =
          data_.settings.in_time ? dimension::kTime : dimension_of_driver(mechanism, i);
      read_place(*column, unit_text(dimension, data_.model.units()));
    }
  }

  static Dimension dimension_of_driver(const Mechanism& mechanism, std::size_t driver) {
    const auto joint = static_cast<std::size_t>(mechanism.drivers[driver].joint);
    return has_angle(mechanism.joints[joint].type) ? dimension::kAngle : dimension::kLength;
  }

  void read_place(const MeasuredColumn& column, const std::string& unit) {
    std::vector<double> values = scaled(column, unit);
    for (std::size_t row = 0; row < values.size(); ++row) {
      if (!column.mistake && std::isnan(values[row])) {
        fail({measured_.source, measured_.lines[row], 1},
             fmt::format("{} is missing: nothing says where this row is", column.name));
        break;
      }
      if (std::abs(values[row]) > 1e12) {
        fail({measured_.source, measured_.lines[row], 1}, fmt::format("{} is too large", values[row]));
        break;
      }
    }
    data_.where.push_back(std::move(values));
    data_.where_names.push_back(column.name);
    data_.where_unit_given.push_back(!column.unit.empty());
    data_.where_places.push_back(column.place);
    data_.where_offset.push_back(false);
  }

  // Values in `unit`.
  std::vector<double> scaled(const MeasuredColumn& column, const std::string& unit) {
    if (column.mistake) mistakes_.push_back(*column.mistake);
    std::vector<double> values = column.values;
    if (column.unit.empty() || column.unit == unit) return values;
    const auto factor = factor_between(column.unit, unit, data_.model.units());
    if (!factor) {
      fail(column.place, fmt::format("{}[{}]: {}", column.name, column.unit, factor.error()));
      return values;
    }
    for (double& value : values) value *= *factor;
    return values;
  }

  std::vector<const MeasuredColumn*> used_columns() {
    std::vector<const MeasuredColumn*> used;
    for (const MeasuredColumn& column : measured_.columns) {
      const bool wanted = data_.task.use.empty() || matches_any(data_.task.use, column.name);
      if (!wanted || is_aside(column.name)) continue;
      if (column.present == 0 && !column.mistake) {
        data_.notes.push_back(fmt::format("{} has no values", column.name));
        continue;
      }
      used.push_back(&column);
    }
    for (const std::string& glob : data_.task.use) {
      if (std::none_of(used.begin(), used.end(),
                       [&](const MeasuredColumn* column) { return matches(glob, column->name); })) {
        std::vector<std::string> names;
        for (const MeasuredColumn& column : measured_.columns) {
          if (!is_aside(column.name)) names.push_back(column.name);
        }
        fail(table(), fmt::format("no column to be fitted is `{}`; {}", glob, suggestion(glob, names)));
      }
    }
    if (used.empty() && mistakes_.empty()) {
      fail(table(), "has no column with values that a motion could be fitted to, only where each row is");
    }
    return used;
  }

  Result<RunSettings> settings_of(const std::vector<const MeasuredColumn*>& used) {
    std::vector<Measure> measures;
    for (const MeasuredColumn* column : used) {
      Measure& measure = measures.emplace_back();
      measure.column = column->name;
      measure.place = column->place;
    }
    // Rows are the table's: whether the profile's own would do makes no difference.
    const auto& programs = data_.model.profile().programs;
    RunSettings settings;
    if (programs.size() == 1 && !programs.front().law) settings.positions = {programs.front().start};
    return settings_for(data_.model, measures, settings).map([&](RunSettings with_columns) {
      with_columns.positions.clear();
      with_columns.in_time = data_.settings.in_time;
      return with_columns;
    });
  }

  void read_columns(const std::vector<const MeasuredColumn*>& used) {
    const auto columns = columns_of(data_.model.data(), data_.settings, data_.model.units());
    for (const MeasuredColumn* column : used) {
      FitColumn& fitted = data_.columns.emplace_back();
      fitted.name = column->name;
      for (const Column& own : columns->columns()) {
        if (own.name == column->name) fitted.unit = own.unit;
      }
      fitted.values = scaled(*column, fitted.unit);
      fitted.unit_given = !column->unit.empty();
      fitted.place = column->place;
      for (const double value : fitted.values) {
        if (std::abs(value) > kLargestQuantity) {
          fail(column->place, fmt::format("{} is too large", value));
          break;
        }
      }
      for (const FitTask::Column& task : data_.task.columns) {
        if (!matches(task.column, fitted.name)) continue;
        if (task.deviation) fitted.deviation = task.deviation;
        fitted.weight *= task.weight;
        fitted.offset = fitted.offset || task.offset;
      }
    }
  }

  void read_frames() {
    const auto place_of_column = [&](const std::string& name) {
      const auto found = std::find_if(data_.columns.begin(), data_.columns.end(),
                                      [&](const FitColumn& column) { return column.name == name; });
      return static_cast<std::size_t>(found - data_.columns.begin());
    };
    for (const FitTask::Frame& frame : data_.task.frames) {
      const std::size_t x = place_of_column(frame.point + ".x"), y = place_of_column(frame.point + ".y");
      if (x == data_.columns.size() || y == data_.columns.size()) {
        fail(frame.place,
             fmt::format("{}: both {}.x and {}.y have to be measured", frame.path, frame.point, frame.point));
        continue;
      }
      for (const std::size_t column : {x, y}) {
        if (frame.position && data_.columns[column].offset) {
          fail(frame.place, fmt::format("{}: `position` is free, and so is the offset of {}: one of the two",
                                        frame.path, data_.columns[column].name));
        }
      }
      data_.frames.push_back({frame, x, y});
    }
  }

  // [[fit.columns]] that mean nothing that was measured; unknown zeros of drivers and of time.
  void check_tasks() {
    std::vector<std::string> names = data_.where_names;
    for (const FitColumn& column : data_.columns) names.push_back(column.name);
    for (const FitTask::Column& task : data_.task.columns) {
      bool found = false;
      for (const std::string& name : names) found = found || matches(task.column, name);
      if (!found) {
        fail(task.place, fmt::format("{}`{}` is no measured column; {}",
                                     task.path.empty() ? "" : task.path + ".column: ", task.column,
                                     suggestion(task.column, names)));
      }
      for (std::size_t i = 0; i < data_.where_names.size(); ++i) {
        if (!matches(task.column, data_.where_names[i])) continue;
        data_.where_offset[i] = data_.where_offset[i] || task.offset;
        if (task.column == data_.where_names[i] && (task.deviation || task.weight != 1)) {
          fail(task.place,
               fmt::format("{}: {} says where each row is and counts as exact: only `offset` has a meaning",
                           task.path, task.column));
        }
      }
    }
  }

  void check_count() {
    if (!mistakes_.empty()) return;
    auto unknowns = static_cast<int>(data_.variables->variables.size());
    for (const bool offset : data_.where_offset) unknowns += offset ? 1 : 0;
    for (const FitColumn& column : data_.columns) unknowns += column.offset ? 1 : 0;
    for (const FitFrame& frame : data_.frames) {
      unknowns += (frame.task.position ? 2 : 0) + (frame.task.turn ? 1 : 0) + (frame.task.scale ? 1 : 0);
    }
    if (data_.values() < unknowns) {
      fail(table(),
           fmt::format("{} measured values in {} rows cannot say what {} numbers are: measure more, or "
                       "look for fewer",
                       data_.values(), data_.rows(), unknowns));
    }
  }

  const MeasuredTable& measured_;
  const FitSettings& settings_;
  FitData data_;
  Diagnostics mistakes_;
};

}  // namespace

int FitData::values() const {
  std::ptrdiff_t count = 0;
  for (const FitColumn& column : columns) {
    count +=
        std::count_if(column.values.begin(), column.values.end(), [](double v) { return !std::isnan(v); });
  }
  return static_cast<int>(count);
}

std::string FitData::where_unit() const {
  return in_time() ? unit_text(dimension::kTime, model.units())
                   : unit_text(driver_dimension(model.mechanism()), model.units());
}

Result<FitData> fit_data(const Model& model, const MeasuredTable& measured, const FitSettings& settings) {
  const auto refuse = [&](const std::string& reason) {
    return tl::unexpected(error_about(model.data(), ErrorKind::kInput, reason));
  };
  if (!model.data().document) {
    return refuse("was built and has no profile that fitted numbers could be written into");
  }
  if (model.profile().design == nullptr || model.profile().design->variables.empty()) {
    return refuse(
        "no [design.variables]: they say which numbers are to be found, NAME = { path = … } each, with min "
        "and "
        "max or without");
  }
  if (auto refusal = refuse_to_start(model.data())) {
    return tl::unexpected(*std::move(refusal));
  }
  return DataReader(model, measured, settings).read();
}

}  // namespace higherpair
