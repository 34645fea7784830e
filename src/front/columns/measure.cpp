#include "higherpair/front/measure.hpp"

#include "front/analysis_impl.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "measure_series.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

std::string where_column(const Mechanism& mechanism, bool in_time) {
  return in_time ? "time" : driver_name(mechanism.drivers.front());
}

// All columns that a run of the model can have, ordered by what they require.
struct Available {
  std::vector<Column> columns;
  std::vector<std::string> names;
  std::map<std::string, std::size_t> index_of;
  std::size_t plain = 0;   // number of columns without forces and jerk
  std::size_t forces = 0;  // number of columns without jerk

  [[nodiscard]] std::optional<std::size_t> find(const std::string& name) const {
    const auto found = index_of.find(name);
    return found == index_of.end() ? std::nullopt : std::optional(found->second);
  }
};

Result<Available> available_columns(const Model& model, RunSettings settings) {
  Available available;
  const Units units = settings.units.value_or(model.units());
  settings.columns.clear();
  const auto add = [&]() -> Result<void> {
    return columns_of(model.data(), settings, units).map([&](const ColumnSet& set) {
      for (const Column& column : set.columns()) {
        if (!available.index_of.try_emplace(column.name, available.names.size()).second) continue;
        available.columns.push_back(column);
        available.names.push_back(column.name);
      }
    });
  };
  auto done = add();
  available.plain = available.names.size();
  settings.forces = true;
  if (done) done = add();
  available.forces = available.names.size();
  settings.jerk = true;
  if (done) done = add();
  if (!done) {
    return tl::unexpected(std::move(done.error()));
  }
  return available;
}

using PlaceOfRow = std::function<double(std::int64_t row)>;

// Where a row is, as its table says.
PlaceOfRow place_in_units(const DriverSchedule& schedule, const Profile& profile,
                          const RunSettings& settings) {
  const Units units = settings.units.value_or(profile.units);
  const bool own = units == profile.units;
  if (settings.in_time) {
    return [&schedule, own, time = from_si(dimension::kTime, units)](std::int64_t row) {
      return own ? schedule.time(row) : time.apply(schedule.time_si(row));
    };
  }
  return [&schedule, own, position = from_si(driver_dimension(profile.mechanism), units)](std::int64_t row) {
    const DriverState state = schedule.state(row);
    return own ? state.profile.position : position.apply(state.si.position);
  };
}

// The objection to the place of a measure; empty where there is a row at that place.
// \param places  of all rows, in ascending order
std::string place_objection(const std::vector<double>& places, const Measure& measure, bool in_time) {
  if (!std::isfinite(measure.at)) return "must be finite";
  const auto below = std::upper_bound(places.begin(), places.end(), measure.at);
  const auto above = std::lower_bound(places.begin(), places.end(), measure.at);
  const double low = below == places.begin() ? -kInf : *std::prev(below);
  const double high = above == places.end() ? kInf : *above;
  const double nearest = std::min(measure.at - low, high - measure.at);
  if (is_there(nearest, measure.at, places.back() - places.front())) {
    return "";
  }
  const std::string next = std::isinf(low) ? fmt::format("the rows begin at {}", high)
                           : std::isinf(high)
                               ? fmt::format("the rows end at {}", low)
                               : fmt::format("the rows next to it are at {} and {}", low, high);
  return fmt::format("no row is at {}: {}; choose one of the rows, or let {} have a row there", measure.at,
                     next, in_time ? "driver.time_step" : "driver.samples or driver.positions");
}

// Where a measure's place is written: the key `at` beside the key `column`, or a pair of `follow`.
std::string place_named(const Measure& measure) {
  const std::size_t dot = measure.path.rfind('.');
  const std::string table = dot == std::string::npos ? "" : measure.path.substr(0, dot + 1);
  return measure.followed ? table + "follow" : fmt::format("{}at = {}", table, measure.at);
}

Diagnostics place_mistakes(const DriverSchedule& schedule, std::span<const Measure> measures,
                           const Profile& profile, const RunSettings& settings) {
  if (std::none_of(measures.begin(), measures.end(),
                   [](const Measure& measure) { return measure.of == MeasureKind::kAt; })) {
    return {};
  }
  const PlaceOfRow place_of_row = place_in_units(schedule, profile, settings);
  std::vector<double> places;
  for (std::int64_t k = 0; k < schedule.size(); ++k) places.push_back(place_of_row(k));
  std::sort(places.begin(), places.end());
  Diagnostics mistakes;
  for (const Measure& measure : measures) {
    std::string objection =
        measure.of == MeasureKind::kAt ? place_objection(places, measure, settings.in_time) : std::string();
    if (!objection.empty()) {
      mistakes.push_back({measure.place, fmt::format("{}: {}", place_named(measure), objection)});
    }
  }
  return mistakes;
}

Diagnostics column_mistakes(const Available& available, std::span<const Measure> measures) {
  Diagnostics mistakes;
  const auto object = [&](const Measure& measure, const std::string& rule) {
    mistakes.push_back({measure.place, fmt::format("{}{}\"{}\": {}", measure.path,
                                                   measure.path.empty() ? "" : " = ", measure.column, rule)});
  };
  std::set<std::string> followed;
  for (const Measure& measure : measures) {
    if (measure.followed && !followed.insert(measure.path).second) continue;  // another place of a column
    const auto index = available.find(measure.column);
    if (!index) {
      object(measure, "there is no such column; " + suggestion(measure.column, available.names));
    } else if (!available.columns[*index].words.empty()) {
      object(measure, "this column holds words; a measure needs numbers");
    }
  }
  return mistakes;
}

// The mistakes of measures that a program made are of the model.
Diagnostics placed(Diagnostics mistakes, const Model& model) {
  for (Diagnostic& mistake : mistakes) {
    if (mistake.place.source.empty()) mistake.place.source = model.profile().source;
  }
  return mistakes;
}

}  // namespace

Result<RunSettings> settings_for(const Model& model, std::span<const Measure> measures,
                                 RunSettings settings) {
  if (auto refusal = refuse_to_start(model.data())) {
    return tl::unexpected(*std::move(refusal));
  }
  const auto available = available_columns(model, settings);
  if (!available) {
    return tl::unexpected(available.error());
  }
  if (Diagnostics mistakes = column_mistakes(*available, measures); !mistakes.empty()) {
    return wrong(placed(std::move(mistakes), model));
  }
  const auto schedule = schedule_of(model.data(), settings);
  if (!schedule) {
    return tl::unexpected(schedule.error());
  }
  if (Diagnostics mistakes = place_mistakes(*schedule, measures, model.profile(), settings);
      !mistakes.empty()) {
    return wrong(placed(std::move(mistakes), model));
  }
  std::set<std::string> chosen(settings.columns.begin(), settings.columns.end());
  const auto add_once = [&](const std::string& name) {
    if (chosen.insert(name).second) settings.columns.push_back(name);
  };
  add_once(where_column(model.mechanism(), settings.in_time));
  for (const Measure& measure : measures) {
    const std::size_t index = *available->find(measure.column);
    settings.forces = settings.forces || (index >= available->plain && index < available->forces);
    settings.jerk = settings.jerk || index >= available->forces;
    add_once(measure.column);
  }
  return settings;
}

MeasureSet::MeasureSet(std::vector<Measure> measures, const std::vector<Column>& columns)
    : measures_(std::move(measures)), states_(measures_.size()) {
  const auto is_driver = [](const Column& column) {
    return column.name == "driver" || column.name.starts_with("driver.");
  };
  where_slot_ = column_slot(columns, "time");
  if (where_slot_ == columns.size()) {
    where_slot_ =
        static_cast<std::size_t>(std::find_if(columns.begin(), columns.end(), is_driver) - columns.begin());
  }
  assert(where_slot_ < columns.size());
  where_unit_ = columns[where_slot_].unit;
  for (const Measure& measure : measures_) {
    slots_.push_back(column_slot(columns, measure.column));
    assert(slots_.back() < columns.size());
    units_.push_back(columns[slots_.back()].unit);
  }
  clear();
}

void MeasureSet::clear() {
  rows_ = 0;
  std::fill(states_.begin(), states_.end(), State());
}

void MeasureSet::add(const Row& row) {
  const double where = row.values[where_slot_];
  low_where_ = rows_ == 0 ? where : std::min(low_where_, where);
  high_where_ = rows_ == 0 ? where : std::max(high_where_, where);
  ++rows_;
  for (std::size_t i = 0; i < measures_.size(); ++i) {
    take({row.values[slots_[i]], where}, measures_[i], states_[i]);
  }
}

void MeasureSet::take(const Measured& seen, const Measure& measure, State& state) const {
  const auto keep = [&](bool better) {
    if (state.rows == 0 || better) state.best = seen;
  };
  if (measure.of == MeasureKind::kFirst || measure.of == MeasureKind::kLast) {
    if (rows_ == 1 || measure.of == MeasureKind::kLast) state.best = seen;
    return;
  }
  if (measure.of == MeasureKind::kAt) {
    const double off = std::abs(seen.where - measure.at);
    if (rows_ == 1 || off < state.low) {
      state.best = seen;
      state.low = off;
    }
    return;
  }
  if (std::isnan(seen.value)) {
    return;
  }
  switch (measure.of) {
    case MeasureKind::kMax:
      keep(seen.value > state.best.value);
      break;
    case MeasureKind::kMin:
      keep(seen.value < state.best.value);
      break;
    case MeasureKind::kMaxAbs:
      keep(std::abs(seen.value) > std::abs(state.best.value));
      break;
    case MeasureKind::kRange:
      keep(seen.value > state.best.value);
      state.low = state.rows == 0 ? seen.value : std::min(state.low, seen.value);
      break;
    case MeasureKind::kRms:
      state.sum += static_cast<long double>(seen.value) * seen.value;
      break;
    default:
      state.sum += seen.value;
  }
  ++state.rows;
}

Measured MeasureSet::value(std::size_t measure) const {
  const State& state = states_[measure];
  Measured result;
  const auto of_row = [&](double value) {
    if (!std::isnan(value)) result = {value, state.best.where};
  };
  const auto rows = static_cast<long double>(state.rows);
  switch (measures_[measure].of) {
    case MeasureKind::kMaxAbs:
      of_row(std::abs(state.best.value));
      break;
    case MeasureKind::kRange:
      result.value = state.best.value - state.low;
      break;
    case MeasureKind::kMean:
      result.value = static_cast<double>(state.sum / rows);
      break;
    case MeasureKind::kRms:
      result.value = static_cast<double>(std::sqrt(state.sum / rows));
      break;
    case MeasureKind::kAt:
      of_row(is_there(state.low, measures_[measure].at, high_where_ - low_where_) ? state.best.value
                                                                                  : kNoValue);
      break;
    default:
      of_row(state.best.value);
  }
  return result;
}

}  // namespace higherpair
