#include "fit_data.hpp"

#include "fit_request.hpp"
#include "front/analysis_impl.hpp"
#include "higherpair/front/measure.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/mechanism/driver_name.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

bool matches_any(const std::vector<std::string>& globs, const std::string& name) {
  return std::any_of(globs.begin(), globs.end(),
                     [&](const std::string& glob) { return matches(glob, name); });
}

FitTask task_of(const Profile& profile) {
  if (profile.fit) return *profile.fit;
  FitTask task;
  task.place.source = profile.source;
  return task;
}

class DataReader {
public:
  DataReader(const Model& model, const MeasuredTable& measured, const FitSettings& settings)
      : measured_(measured),
        settings_(settings),
        data_{model, model.profile().design, task_of(model.profile()), measured.lines} {}

  Result<FitData> read() {
    data_.task = with_settings(std::move(data_.task), settings_, mistakes_);
    read_where();
    std::vector<const MeasuredColumn*> used = used_columns();
    if (!mistakes_.empty()) return wrong(std::move(mistakes_));
    if (auto settings = settings_of(used)) {
      data_.settings = *std::move(settings);
    } else {
      return tl::unexpected(std::move(settings.error()));
    }
    read_columns(used);
    const bool read = mistakes_.empty();
    apply_columns(data_, mistakes_);
    if (read) find_frames(data_, mistakes_);
    if (mistakes_.empty()) check_count(data_, table(), mistakes_);
    if (!mistakes_.empty()) return wrong(std::move(mistakes_));
    return std::move(data_);
  }

private:
  // A column that a program made has no place of its own.
  void fail(const Place& place, std::string message) {
    mistakes_.push_back({place.source.empty() ? table() : place, std::move(message)});
  }
  [[nodiscard]] Place table() const { return {measured_.source, 0, 0}; }

  [[nodiscard]] const MeasuredColumn* column_of(const std::string& name) const {
    const auto found = std::find_if(measured_.columns.begin(), measured_.columns.end(),
                                    [&](const MeasuredColumn& column) { return column.name == name; });
    return found == measured_.columns.end() ? nullptr : &*found;
  }

  // Columns of tables that are not the motion to be fitted.
  [[nodiscard]] bool is_aside(const std::string& name) const {
    const std::vector<Driver>& drivers = data_.model.mechanism().drivers;
    const auto is_given = [&](const Driver& driver) {
      const std::string own = driver_name(driver);
      return name == own || name == own + ".velocity" || name == own + ".acceleration" ||
             name == own + ".jerk";
    };
    return name == "status" || name == "residual" || name == "time" || name.ends_with(".linkage") ||
           std::any_of(drivers.begin(), drivers.end(), is_given);
  }

  // A table with both time and drivers is one of a run in time: time then says where its rows are.
  void read_where() {
    const Mechanism& mechanism = data_.model.mechanism();
    std::vector<std::string> drivers;
    for (const Driver& driver : mechanism.drivers) drivers.push_back(driver_name(driver));
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
      const Dimension dimension = data_.settings.in_time ? dimension::kTime : driver_dimension(mechanism, i);
      read_place(*column, unit_text(dimension, data_.model.units()));
    }
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
        fail({measured_.source, measured_.lines[row], 1},
             fmt::format("{}: {} is too large", column.name, values[row]));
        break;
      }
    }
    data_.where.push_back({column.name, unit, std::move(values), false, !column.unit.empty(), column.place});
  }

  // The values converted to `unit`.
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
      const bool empty = std::all_of(column.values.begin(), column.values.end(),
                                     [](double value) { return std::isnan(value); });
      if (empty && !column.mistake) {
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
    // The rows are those of the table: whether the profile's own have the right places does not matter.
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
    std::map<std::string_view, const Column*> own;
    for (const Column& column : columns->columns()) own.emplace(column.name, &column);
    for (const MeasuredColumn* column : used) {
      FitColumn& fitted = data_.columns.emplace_back();
      fitted.name = column->name;
      if (const auto found = own.find(column->name); found != own.end()) fitted.unit = found->second->unit;
      fitted.values = scaled(*column, fitted.unit);
      fitted.unit_given = !column->unit.empty();
      fitted.place = column->place;
      for (const double value : fitted.values) {
        if (std::abs(value) > kLargestQuantity) {
          fail(column->place, fmt::format("{}: {} is too large", column->name, value));
          break;
        }
      }
    }
  }

  const MeasuredTable& measured_;
  const FitSettings& settings_;
  FitData data_;
  Diagnostics mistakes_;
};

}  // namespace

Result<MeasuredTable> whole(MeasuredTable table) {
  const std::size_t rows = !table.lines.empty()    ? table.lines.size()
                           : table.columns.empty() ? 0
                                                   : table.columns.front().values.size();
  for (const MeasuredColumn& column : table.columns) {
    if (column.values.size() == rows) continue;
    return wrong(Place{table.source},
                 fmt::format("{} has {} values in a table of {} rows: each row needs one", column.name,
                             column.values.size(), rows));
  }
  for (std::size_t row = table.lines.size(); row < rows; ++row) {
    table.lines.push_back(static_cast<int>(row) + 1);
  }
  return table;
}

int FitData::values() const {
  std::ptrdiff_t count = 0;
  for (const FitColumn& column : columns) {
    count +=
        std::count_if(column.values.begin(), column.values.end(), [](double v) { return !std::isnan(v); });
  }
  return static_cast<int>(count);
}

Result<FitData> fit_data(const Model& model, const MeasuredTable& measured, const FitSettings& settings) {
  if (!model.data().document) {
    return wrong(model, "was built and has no profile that fitted numbers could be written into");
  }
  if (const auto text = model.data().document->text_with({}); !text) {
    return wrong(model, text.error());
  }
  if (model.profile().design == nullptr || model.profile().design->variables.empty()) {
    return wrong(model,
                 "no [design.variables]: they say which numbers are to be found, NAME = { path = … } each, "
                 "with min and "
                 "max or without");
  }
  if (auto refusal = refuse_to_start(model.data())) {
    return tl::unexpected(*std::move(refusal));
  }
  return whole(measured).and_then(
      [&](const MeasuredTable& table) { return DataReader(model, table, settings).read(); });
}

}  // namespace higherpair
