#include "reach.hpp"

#include "front/analysis_impl.hpp"
#include "front/model_data.hpp"
#include "higherpair/drawing/picture.hpp"
#include "higherpair/drawing/scene_maker.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/mechanism/driver_name.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

Result<Reached> nearest_row(const Model& model, const RunSettings& settings, double at) {
  auto analysis = model.start(settings);
  if (!analysis) {
    return tl::unexpected(std::move(analysis.error()));
  }
  std::optional<Reached> best;
  std::int64_t best_row = 0;
  Row row;
  while (analysis->next(row)) {
    const double driver = row.values.front();
    if (has_place(analysis->impl().run.row) &&
        (!best || std::abs(driver - at) < std::abs(best->driver - at))) {
      best = Reached{analysis->impl().run, driver, std::nullopt, {}};
      best_row = row.number;
    }
  }
  if (analysis->stopped()) {
    return wrong(model, "interrupted");
  }
  if (!best) {
    return tl::unexpected(*nothing_to_draw(model, {}));
  }
  best->passed = analysis->impl().faults_before(best_row);
  return *std::move(best);
}

// Positions have the bounds of those of a profile.
std::optional<Error> out_of_range(const Model& model, double at) {
  const Dimension of_driver = driver_dimension(model.mechanism());
  if (can_be_position(at, of_driver, model.units())) {
    return std::nullopt;
  }
  return error_about(
      model.data(), ErrorKind::kInput,
      fmt::format("driver = {}: expected a position of at most {}", at, farthest_position(of_driver)));
}

// The run after its last row, and the last limit position on the path.
Result<Reached> go_to(const Model& model, RunSettings settings, double from, double at) {
  settings.positions = {from, at};
  auto analysis = model.start(settings);
  if (!analysis) {
    return tl::unexpected(std::move(analysis.error()));
  }
  Row row;
  while (analysis->next(row)) {
  }
  if (analysis->stopped()) {
    return wrong(model, "interrupted");
  }
  Reached reached{analysis->impl().run, at, std::nullopt, analysis->impl().faults_before(row.number)};
  // The last one: earlier ones may be ends of curves from which the contact went on over the edge.
  const auto limit = std::find_if(analysis->events().rbegin(), analysis->events().rend(),
                                  [](const Event& event) { return loses_motion(event.type); });
  if (limit != analysis->events().rend()) {
    reached.limit = *limit;
  }
  return reached;
}

}  // namespace

RunSettings driver_alone(const Model& model, double tolerance, const std::atomic<bool>* stop) {
  const auto& drivers = model.mechanism().drivers;
  RunSettings settings;
  settings.columns = {drivers.empty() ? "driver" : driver_name(drivers.front())};
  settings.tolerance = tolerance;
  settings.stop = stop;
  return settings;
}

Result<Reached> reach(const Model& model, const RunSettings& settings, double at) {
  if (model.mechanism().drivers.size() > 1) {
    return nearest_row(model, settings, at);
  }
  const auto schedule = first_schedule(model.data());
  if (!schedule) {
    return tl::unexpected(schedule.error());
  }
  if (auto error = out_of_range(model, at)) {
    return tl::unexpected(*std::move(error));
  }
  const double from = schedule->state(0).profile.position;
  auto reached = go_to(model, settings, from, at);
  if (!reached) {
    return reached;
  }
  if (has_place(reached->run.row)) {
    reached->limit.reset();
    return reached;
  }
  if (!reached->limit) {
    return tl::unexpected(error_about(model.data(), ErrorKind::kMechanism,
                                      fmt::format("cannot be assembled at driver = {}", at)));
  }
  const Event limit = *reached->limit;
  reached = go_to(model, settings, from, limit.driver);
  if (reached) {
    reached->limit = limit;
    reached->passed.clear();
  }
  return reached;
}

std::optional<Error> nothing_to_draw(const Model& model, const std::vector<MotionRow>& rows) {
  if (std::any_of(rows.begin(), rows.end(), has_place)) {
    return std::nullopt;
  }
  return error_about(model.data(), ErrorKind::kMechanism, "no row has a position that could be drawn");
}

}  // namespace higherpair
