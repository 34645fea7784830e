#include "design_setup.hpp"

#include "analysis_impl.hpp"
#include "higherpair/numeric/contains.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

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

bool has_row_at(const DriverSchedule& schedule, double position) {
  for (std::int64_t k = 0; k < schedule.size(); ++k) {
    const double there = schedule.state(k).profile.position;
    if (std::abs(there - position) <= kSamePosition * (1 + std::abs(there))) return true;
  }
  return false;
}

void check_path(const DesignTask::Objective& objective, const DriverSchedule& schedule,
                Diagnostics& mistakes) {
  const DesignTask::PointPath& path = *objective.path;
  const auto rows = static_cast<std::size_t>(schedule.size());
  if (!path.timed && schedule.driver_count() > 1) {
    mistakes.push_back(
        {objective.place, fmt::format("{}.path: with several drivers a path has to be timed: each "
                                      "point belongs to a row",
                                      objective.path_of_key)});
  }
  if (path.timed && path.at.empty() && path.through.size() != rows) {
    mistakes.push_back(
        {objective.place,
         fmt::format("{}.path: {} points, but the driver has {} rows: give it as many positions or "
                     "samples, or say `at` which of its positions each point belongs",
                     objective.path_of_key, path.through.size(), rows)});
  }
  for (const double position : path.at) {
    if (!has_row_at(schedule, position)) {
      mistakes.push_back(
          {objective.place, fmt::format("{}.path.at: {} is none of the driver's positions; let "
                                        "driver.samples or driver.positions have a row there",
                                        objective.path_of_key, position)});
    }
  }
}

Diagnostics mistakes_in(const Model& model, const DesignTask& task, const DriverSchedule& schedule) {
  Diagnostics mistakes;
  for (const DesignTask::Objective& objective : task.objectives) {
    if (objective.path) check_path(objective, schedule, mistakes);
  }
  std::vector<BodyMotion> bodies(model.mechanism().bodies.size());
  for (const DesignTask::Constraint& constraint : task.constraints) {
    if (constraint.transmission &&
        !transmission_sine(*model.data().plan, constraint.transmission->joint, bodies)) {
      mistakes.push_back(
          {constraint.place,
           fmt::format("{}.transmission = \"{}\": this pin does not join two links whose other ends "
                       "are pins of known bodies, as coupler and rocker of a four-bar are; of a rod that "
                       "moves a slide limit the angle, column = \"ROD.angle\", of = \"maxabs\"",
                       constraint.path_of_key, constraint.transmission->pin)});
    }
  }
  return mistakes;
}

// Whether all numbers are equal.
bool same(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return a.size() == b.size() && (a.array() == b.array()).all();
}

// Openings of contacts are found from forces, which the run has to compute then.
RunSettings run_wanted_by(const DesignTask& task) {
  RunSettings wanted;
  for (const DesignTask::Constraint& constraint : task.constraints) {
    const std::vector<EventType>& types = constraint.without;
    if (contains(types, EventType::kContactOpen)) wanted.forces = true;
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
  std::vector<Measure> measures = measures_of(*task);
  auto settings = settings_for(model, measures, run_wanted_by(*task));
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
  auto setup = std::make_shared<DesignSetup>(DesignSetup{DesignNumbers(model, *task),
                                                         quantities_of(*task),
                                                         std::move(measures),
                                                         *std::move(settings),
                                                         *std::move(schedule),
                                                         1,
                                                         {},
                                                         1});
  setup->branches = branch_count(*model.data().plan);
  setup->size = model.data().plan->size;
  if (const auto start = model.start(setup->settings)) {
    setup->start_branch = branch_of(start->impl().run);
  }
  const auto table = columns_of(model.data(), setup->settings, model.units());
  if (!table) {
    return tl::unexpected(table.error());
  }
  if (Diagnostics mistakes =
          complete_quantities(model, *task, setup->measures, table->columns(), setup->quantities);
      !mistakes.empty()) {
    return wrong(std::move(mistakes));
  }
  set_scales(*setup);
  if (Diagnostics mistakes = idle_parts(*setup); !mistakes.empty()) {
    return wrong(std::move(mistakes));
  }
  return setup;
}

Diagnostics idle_parts(const DesignSetup& setup) {
  const DesignTask& task = setup.numbers.task();
  const DesignProblem problem =
      problem_of(std::shared_ptr<const DesignSetup>(std::shared_ptr<void>(), &setup));
  const auto evaluator = problem.evaluator();
  const std::vector<double> x = start_values(task);
  const int branch = problem.start_branch;
  const DesignScore start = score_of(setup, x, branch);
  Diagnostics mistakes;
  if (!start.started || start.missing > 0) {
    return mistakes;
  }
  DesignValues before, after;
  evaluator->evaluate(x, branch, before);
  std::vector<bool> changed(task.objectives.size(), false);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const DesignVariable& range = task.variables[i].range;
    bool does_something = false;
    for (const double share : kIdleShares) {
      std::vector<double> other = x;
      const double way = share * (range.high - range.low);
      other[i] += other[i] + way <= range.high ? way : -way;
      evaluator->evaluate(other, branch, after);
      does_something = does_something || before.cost != after.cost ||
                       !same(before.residuals, after.residuals) ||
                       !same(before.constraints, after.constraints);
      const DesignScore score = score_of(setup, other, branch);
      for (std::size_t k = 0; k < changed.size(); ++k) {
        changed[k] = changed[k] || !(score.objectives[k] == start.objectives[k]);
      }
    }
    if (!does_something) {
      mistakes.push_back(
          {task.variables[i].place,
           fmt::format("design.variables.{}: changes no objective and no constraint: leave it out, or "
                       "ask for something that depends on {}",
                       task.variables[i].name, task.variables[i].paths.front())});
    }
  }
  for (std::size_t k = 0; k < changed.size(); ++k) {
    if (!changed[k]) {
      mistakes.push_back(
          {task.objectives[k].place,
           fmt::format("{}: is the same whatever the variables: choose an objective that depends on "
                       "them, or other variables",
                       task.objectives[k].path_of_key)});
    }
  }
  return mistakes;
}

}  // namespace higherpair
