#include "higherpair/front/polygon.hpp"

#include "analysis_impl.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "model_data.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace higherpair {
namespace {

// A row of a run, and how it came about.
struct Reached {
  Run run;
  double driver = 0;
  std::vector<Event> events;
};

std::string first_driver(const Model& model) {
  const auto& drivers = model.mechanism().drivers;
  return drivers.empty() || drivers.front().name.empty() ? "driver" : "driver." + drivers.front().name;
}

RunSettings basic(const Model& model, const PolygonSettings& wanted) {
  RunSettings settings;
  settings.columns = {first_driver(model)};
  settings.tolerance = wanted.tolerance;
  settings.stop = wanted.stop;
  return settings;
}

// The row of a run in which the first driver is nearest to a position.
Result<Reached> nearest_row(const Model& model, const RunSettings& settings, double at) {
  auto analysis = model.start(settings);
  if (!analysis) {
    return tl::unexpected(std::move(analysis.error()));
  }
  std::optional<Reached> best;
  Row row;
  while (analysis->next(row)) {
    if (!best || std::abs(row.values[0] - at) < std::abs(best->driver - at)) {
      best = Reached{analysis->impl().run, row.values[0], {}};
    }
  }
  if (!best) {
    return tl::unexpected(error_about(model.data(), ErrorKind::kInput, "interrupted"));
  }
  best->events = analysis->events();
  return *std::move(best);
}

// Where the driver comes when it goes from its first position to another.
Result<Reached> go_to(const Model& model, RunSettings settings, double at) {
  const auto schedule = first_schedule(model.data());
  if (!schedule) {
    return tl::unexpected(schedule.error());
  }
  settings.positions = {schedule->state(0).profile.position, at};
  auto analysis = model.start(settings);
  if (!analysis) {
    return tl::unexpected(std::move(analysis.error()));
  }
  Row row;
  while (analysis->next(row)) {
  }
  return Reached{analysis->impl().run, at, analysis->events()};
}

void to_units(std::vector<Polygon>& polygons, const Units& units) {
  for (Polygon& polygon : polygons) {
    const Dimension& of = polygon.kind == Polygon::Kind::kVelocity       ? dimension::kVelocity
                          : polygon.kind == Polygon::Kind::kAcceleration ? dimension::kAcceleration
                                                                         : dimension::kForce;
    convert(polygon, from_si(of, units).apply(1), unit_text(of, units));
  }
}

}  // namespace

Result<Polygons> polygons_of(const Model& model, const PolygonSettings& wanted) {
  const RunSettings settings = basic(model, wanted);
  const bool single = model.mechanism().drivers.size() <= 1;
  auto reached = single ? go_to(model, settings, wanted.at) : nearest_row(model, settings, wanted.at);
  if (!reached) {
    return tl::unexpected(std::move(reached.error()));
  }
  Polygons all;
  if (single && reached->run.row.status == RowStatus::kNotAssemblable) {
    const auto limit = std::find_if(reached->events.begin(), reached->events.end(), [](const Event& event) {
      return event.type == EventType::kLimitPosition;
    });
    if (limit == reached->events.end()) {
      return tl::unexpected(error_about(model.data(), ErrorKind::kMechanism,
                                        fmt::format("cannot be assembled at driver = {}", wanted.at)));
    }
    all.limit = limit->cause;
    const double last = limit->driver;
    reached = go_to(model, settings, last);
    if (!reached) {
      return tl::unexpected(std::move(reached.error()));
    }
  }
  const Run& run = reached->run;
  all.driver = reached->driver;
  const auto joint = static_cast<std::size_t>(run.mechanism.drivers.front().joint);
  all.driver_unit = unit_text(
      has_angle(run.mechanism.joints[joint].type) ? dimension::kAngle : dimension::kLength, model.units());
  all.polygons = {velocity_polygon(run.mechanism, run.row), acceleration_polygon(run.mechanism, run.row)};
  if (wanted.forces) {
    InverseDynamics dynamics(run);
    for (Polygon& polygon : force_polygons(run.mechanism, run.row, dynamics.solve(run))) {
      all.polygons.push_back(std::move(polygon));
    }
  }
  to_units(all.polygons, model.units());
  return all;
}

}  // namespace higherpair
