#include "higherpair/front/drawing.hpp"

#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/suggestion.hpp"
#include "model_data.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace higherpair {
namespace {

constexpr std::int64_t kMostRows = 721;  // that decide about a picture
constexpr double kMostScenes = 200;      // of `every`

tl::unexpected<Error> wrong(const Model& model, std::string what) {
  return tl::unexpected(error_about(model.data(), ErrorKind::kInput, std::move(what)));
}

struct Rows {
  std::vector<MotionRow> rows;
  std::vector<double> drivers;  ///< of each row, in its unit
  std::vector<Event> events;
};

Result<Rows> rows_of(const Model& model, const RunSettings& settings) {
  auto analysis = model.start(settings);
  if (!analysis) {
    return tl::unexpected(analysis.error());
  }
  Rows rows;
  Row row;
  while (analysis->next(row)) {
    rows.rows.push_back(analysis->motion());
    rows.drivers.push_back(row.values.front());
  }
  rows.events = analysis->events();
  if (analysis->stopped()) {
    return wrong(model, "interrupted");
  }
  return rows;
}

RunSettings basic(const SceneSettings& wanted, const Model& model) {
  RunSettings settings;
  settings.tolerance = wanted.tolerance;
  settings.stop = wanted.stop;
  const std::string name = model.mechanism().drivers.empty() ? "" : model.mechanism().drivers.front().name;
  settings.columns = {name.empty() ? "driver" : "driver." + name};
  return settings;
}

Result<Rows> rows_at(const Model& model, const SceneSettings& wanted, std::vector<double> positions) {
  RunSettings settings = basic(wanted, model);
  settings.positions = std::move(positions);
  return rows_of(model, settings);
}

// All rows of the run, or so many as a picture needs.
Result<Rows> rows_of_run(const Model& model, const SceneSettings& wanted) {
  RunSettings settings = basic(wanted, model);
  const auto schedule = first_schedule(model.data());
  if (schedule && schedule->size() > kMostRows && model.profile().programs.front().positions.empty()) {
    settings.samples = kMostRows;
  }
  return rows_of(model, settings);
}

Result<Scenes> scene_at(const Model& model, const SceneSettings& wanted, const Rows& run, SceneMaker& maker) {
  Scenes scenes;
  if (!wanted.at) {
    const auto placed = std::find_if(run.rows.begin(), run.rows.end(), [](const MotionRow& row) {
      return row.status != RowStatus::kNotAssemblable;
    });
    scenes.scenes.push_back(maker.at(*placed));
    return scenes;
  }
  if (model.mechanism().drivers.size() > 1) {
    const auto nearest = std::min_element(run.drivers.begin(), run.drivers.end(), [&](double a, double b) {
      return std::abs(a - *wanted.at) < std::abs(b - *wanted.at);
    });
    scenes.scenes.push_back(maker.at(run.rows[static_cast<std::size_t>(nearest - run.drivers.begin())]));
    return scenes;
  }
  auto there = rows_at(model, wanted, {run.drivers.front(), *wanted.at});
  if (!there) {
    return tl::unexpected(there.error());
  }
  if (there->rows.back().status == RowStatus::kNotAssemblable) {
    const auto limit = std::find_if(there->events.begin(), there->events.end(), [](const Event& event) {
      return event.type == EventType::kLimitPosition;
    });
    if (limit == there->events.end()) {
      return wrong(model, fmt::format("cannot be assembled at driver = {}", *wanted.at));
    }
    scenes.limit = limit->driver;
    scenes.cause = limit->cause;
    there = rows_at(model, wanted, {run.drivers.front(), limit->driver});
    if (!there) {
      return tl::unexpected(there.error());
    }
  }
  scenes.scenes.push_back(maker.at(there->rows.back()));
  return scenes;
}

Result<Scenes> scenes_every(const Model& model, const SceneSettings& wanted, const Rows& run,
                            SceneMaker& maker) {
  const double from = run.drivers.front(), to = run.drivers.back(), step = *wanted.every;
  if (model.mechanism().drivers.size() > 1) {
    return wrong(model, "pictures at every so much of the driver are for a single driver");
  }
  if (!(step > 0) || !(std::abs(to - from) / step <= kMostScenes)) {
    return wrong(model, fmt::format("every {} from {} to {}: give a step > 0 that makes at most {} pictures",
                                    step, from, to, kMostScenes));
  }
  std::vector<double> positions;
  for (double k = 0; k * step <= std::abs(to - from) * (1 + 1e-12); ++k) {
    positions.push_back(from + std::copysign(k * step, to - from));
  }
  const auto rows = rows_at(model, wanted, positions);
  if (!rows) {
    return tl::unexpected(rows.error());
  }
  Scenes scenes;
  for (const MotionRow& row : rows->rows) {
    if (row.status != RowStatus::kNotAssemblable) scenes.scenes.push_back(maker.at(row));
  }
  return scenes;
}

}  // namespace

Result<PointRef> find_point(const Model& model, const std::string& name) {
  std::vector<std::string> names;
  const auto& bodies = model.mechanism().bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t p = 0; p < bodies[b].points.size(); ++p) {
      names.push_back(bodies[b].name + "." + bodies[b].points[p].name);
      if (names.back() == name) {
        return PointRef{static_cast<int>(b), static_cast<int>(p)};
      }
    }
  }
  return wrong(model, fmt::format("there is no point {}; {}", name, suggestion(name, names)));
}

Result<Scenes> scenes_of(const Model& model, const SceneSettings& settings) {
  std::vector<PointRef> traces;
  for (const std::string& name : settings.traces) {
    const auto point = find_point(model, name);
    if (!point) {
      return tl::unexpected(point.error());
    }
    traces.push_back(*point);
  }
  const auto run = rows_of_run(model, settings);
  if (!run) {
    return tl::unexpected(run.error());
  }
  SceneMaker maker(model.mechanism(), run->rows, traces);
  return settings.every ? scenes_every(model, settings, *run, maker) : scene_at(model, settings, *run, maker);
}

}  // namespace higherpair
