#include "design_setup.hpp"

#include "design_candidates.hpp"
#include "front/analysis_impl.hpp"
#include "higherpair/numeric/contains.hpp"
#include "nearest_rows.hpp"

#include <cmath>
#include <tuple>
#include <utility>
#include <variant>

#include <fmt/core.h>

namespace higherpair {
namespace {

// What a design needs and the task lacks; a fit can do without it.
Diagnostics missing_in(const DesignTask& task) {
  Diagnostics mistakes;
  if (task.objectives.empty()) {
    mistakes.push_back(
        {task.place, "design.objectives is missing: expected what is to be small, [[design.objectives]]"});
  }
  for (const DesignTask::Variable& variable : task.variables) {
    for (const auto& [bound, key, what] : {std::tuple(variable.range.low, "min", "smallest"),
                                           std::tuple(variable.range.high, "max", "largest")}) {
      if (std::isfinite(bound)) continue;
      mistakes.push_back(
          {variable.place,
           fmt::format("design.variables.{}.{} is missing: expected the {} value, in the unit in which the "
                       "number stands",
                       variable.name, key, what)});
    }
  }
  return mistakes;
}

void check_path(const DesignTask::Objective& objective, const DriverSchedule& schedule,
                Diagnostics& mistakes) {
  const DesignTask::PointPath& path = *objective.path();
  const std::vector<double> positions = places_of(schedule);
  const auto rows = rows_at(path.at, positions);
  if (!path.timed && schedule.driver_count() > 1) {
    mistakes.push_back(
        {objective.place, fmt::format("{}.path: with several drivers a path has to be timed: each "
                                      "point belongs to a row",
                                      objective.path_of_key)});
  }
  if (const auto row = path.closed ? turning_row(positions) : std::nullopt) {
    mistakes.push_back(
        {objective.place, fmt::format("{}.path.closed: the driver turns back at {}: let it go one way around "
                                      "the path, or leave `closed` out",
                                      objective.path_of_key, positions[*row])});
  }
  if (path.timed && path.at.empty() && path.through.size() != positions.size()) {
    mistakes.push_back(
        {objective.place,
         fmt::format("{}.path: {} points, but the driver has {} rows: give it as many positions or "
                     "samples, or say `at` which of its positions each point belongs",
                     objective.path_of_key, path.through.size(), positions.size())});
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i]) {
      mistakes.push_back(
          {objective.place, fmt::format("{}.path.at: {} is none of the driver's positions; let "
                                        "driver.samples or driver.positions have a row there",
                                        objective.path_of_key, path.at[i])});
    }
  }
}

Diagnostics mistakes_in(const Model& model, const DesignTask& task, const DriverSchedule& schedule) {
  Diagnostics mistakes;
  for (const DesignTask::Objective& objective : task.objectives) {
    if (objective.path()) check_path(objective, schedule, mistakes);
  }
  std::vector<BodyMotion> bodies(model.mechanism().bodies.size());
  for (const DesignTask::Constraint& constraint : task.constraints) {
    const auto* transmission = constraint.transmission();
    if (transmission && !transmission_sine(*model.data().plan, transmission->joint, bodies)) {
      mistakes.push_back(
          {constraint.place,
           fmt::format("{}.transmission = \"{}\": this pin does not join two links whose other ends "
                       "are pins of known bodies, as coupler and rocker of a four-bar are; of a rod that "
                       "moves a slide limit the angle, column = \"ROD.angle\", of = \"maxabs\"",
                       constraint.path_of_key, transmission->pin)});
    }
  }
  return mistakes;
}

// Openings of contacts are found from forces, which the run has to compute then.
RunSettings run_wanted_by(const DesignTask& task) {
  RunSettings wanted;
  for (const DesignTask::Constraint& constraint : task.constraints) {
    const auto* events = std::get_if<DesignTask::Events>(&constraint.of);
    if (events && contains(events->types, EventType::kContactOpen)) wanted.forces = true;
  }
  return wanted;
}

}  // namespace

Result<std::shared_ptr<const DesignSetup>> design_setup(const Model& model) {
  const std::shared_ptr<const DesignTask>& task = model.profile().design;
  if (task == nullptr) {
    return wrong(model, "no [design]: it says which numbers may be chosen and for what");
  }
  if (Diagnostics mistakes = missing_in(*task); !mistakes.empty()) {
    return wrong(std::move(mistakes));
  }
  if (auto refusal = refuse_to_start(model.data())) {
    return tl::unexpected(*std::move(refusal));
  }
  DesignQuantities quantities = quantities_of(*task);
  auto settings = settings_for(model, quantities.measures_at_all_places(), run_wanted_by(*task));
  if (!settings) {
    return tl::unexpected(std::move(settings.error()));
  }
  auto schedule = schedule_of(model.data(), *settings);
  if (!schedule) {
    return tl::unexpected(std::move(schedule.error()));
  }
  if (Diagnostics mistakes = mistakes_in(model, *task, *schedule); !mistakes.empty()) {
    return wrong(std::move(mistakes));
  }
  if (const auto text = model.data().document->text_with({}); !text) {
    return wrong(model, text.error());
  }
  const Plan& plan = *model.data().plan;
  auto setup = std::make_shared<DesignSetup>(DesignSetup{.numbers = DesignNumbers(model, *task),
                                                         .quantities = std::move(quantities.all),
                                                         .measures = std::move(quantities.measures),
                                                         .numbers_measured = quantities.numbers,
                                                         .settings = *std::move(settings),
                                                         .schedule = *std::move(schedule),
                                                         .branches = branch_count(plan),
                                                         .closures = closure_count(plan),
                                                         .size = plan.size});
  set_places(*setup);
  if (const auto start = model.start(setup->settings)) {
    setup->start_branch = branch_of(start->impl().run);
  }
  const auto table = columns_of(model.data(), setup->settings, model.units());
  if (!table) {
    return tl::unexpected(table.error());
  }
  if (Diagnostics mistakes = complete_quantities(model, setup->measures, table->columns(), setup->quantities);
      !mistakes.empty()) {
    return wrong(std::move(mistakes));
  }
  setup->start_score = score_of(*setup, start_values(*task), setup->start_branch.value_or(0));
  set_scales(*setup);
  if (Diagnostics mistakes = idle_parts(*setup); !mistakes.empty()) {
    return wrong(std::move(mistakes));
  }
  return setup;
}

}  // namespace higherpair
