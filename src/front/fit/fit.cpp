#include "higherpair/front/fit.hpp"

#include "fit_report.hpp"
#include "fit_search.hpp"
#include "fit_units.hpp"
#include "front/analysis_impl.hpp"
#include "front/design/design_setup.hpp"
#include "front/tolerances.hpp"
#include "higherpair/analysis/branch_run.hpp"

#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

RunSettings status_alone() {
  RunSettings settings;
  settings.columns = {"status"};
  return settings;
}

// The branch on which the profile starts.
Result<int> branch_of_model(const Model& model) {
  auto run = model.start(status_alone());
  if (!run) {
    return tl::unexpected(std::move(run.error()));
  }
  return branch_of(run->impl().run);
}

// Variables on which no measured value depends.
Diagnostics idle_variables(const FitProblem& problem, const Eigen::VectorXd& x) {
  Diagnostics mistakes;
  const auto jacobian = problem.jacobian(x);
  if (!jacobian) return mistakes;
  const Eigen::MatrixXd J = problem.spread_scales().asDiagonal() * *jacobian;
  const std::vector<DesignTask::Variable>& variables = problem.data().variables->variables;
  Eigen::VectorXd effects = J.colwise().norm();
  for (std::size_t i = 0; i < variables.size(); ++i) effects(eigen_index(i)) *= problem.motion().scale(i);
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (effects(eigen_index(i)) > kNoFitChange * effects.maxCoeff()) continue;
    mistakes.push_back(
        {variables[i].place,
         fmt::format("design.variables.{}: changes none of the measured columns: leave it out, or measure "
                     "something that depends on {}",
                     variables[i].name, variables[i].paths.front())});
  }
  return mistakes;
}

// Shifts angles by whole turns where the instrument counts within one turn, or from another one.
void unwrap_angles(FitData& data, const FitProblem& problem, const Eigen::VectorXd& x) {
  for (std::size_t c = 0; c < data.columns.size(); ++c) {
    const std::vector<double> values = problem.unwrapped(c, x);
    int moved = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      moved += std::abs(values[k] - data.columns[c].values[k]) > 0 ? 1 : 0;
    }
    if (moved == 0) continue;
    data.columns[c].values = values;
    data.notes.push_back(
        fmt::format("{}: {} of its angles are taken as so many whole turns more or less, near "
                    "the profile's motion",
                    data.columns[c].name, moved));
  }
}

// The text of the new profile, verified by reading it again and running it through the rows.
Result<std::string> verified_text(const FitProblem& problem, const FitSolution& solution, FitReport& report) {
  const FitData& data = problem.data();
  const std::vector<double> x(solution.x.data(), solution.x.data() + data.variables->variables.size());
  auto text = text_of_design(problem.motion().numbers(), status_alone(), x, problem.motion().branch());
  if (!text) {
    return text;
  }
  const Model::Data& before = data.model.data();
  auto model = Model::from_text(*text, before.profile.source);
  if (!model) {
    return tl::unexpected(std::move(model.error()));
  }
  FitData again = data;
  again.model = *model;
  again.variables = model->profile().design;
  const auto branch = branch_of_model(*model);
  bool same = branch.has_value();
  if (same) {
    const FitMotion motion(again, *branch);
    const FitProblem reread(again, motion);
    const auto residuals = reread.residuals(solution.x);
    same = residuals.has_value();
    for (std::size_t i = 0; same && i < problem.values().size(); ++i) {
      same = std::abs((*residuals)(eigen_index(i)) - solution.residuals(eigen_index(i))) <=
             kSameMotion * problem.largest(problem.values()[i].column);
    }
  }
  if (!same) {
    report.good = false;
    report.notes.push_back("the profile that was written, read again, does not move as was fitted");
  }
  return text;
}

}  // namespace

Result<FitReport> fit(const Model& model, const MeasuredTable& measured, const FitSettings& settings) {
  auto data = fit_data(model, measured, settings);
  if (!data) {
    return tl::unexpected(data.error());
  }
  const auto branch = branch_of_model(model);
  if (!branch) {
    return tl::unexpected(branch.error());
  }
  FitMotion motion(*data, *branch);
  {
    const FitProblem as_measured(*data, motion);
    unwrap_angles(*data, as_measured, as_measured.start());
  }
  const FitProblem problem(*data, motion);
  if (Diagnostics suspicions = unit_suspicions(problem); !suspicions.empty()) {
    return wrong(std::move(suspicions));
  }
  const Eigen::VectorXd start = problem.start();
  std::vector<double> variables(start.data(), start.data() + data->variables->variables.size());
  motion.choose_derivatives(variables, std::vector<double>(data->where.size(), 0.0));
  if (Diagnostics mistakes = idle_variables(problem, start); !mistakes.empty()) {
    return wrong(std::move(mistakes));
  }
  const FitSolution solution = solve_fit(problem, settings);
  if (!solution.started) {
    return tl::unexpected(error_about(model.data(), ErrorKind::kMechanism,
                                      "the mechanism cannot be run through the rows of the table"));
  }
  FitReport report = fit_report(problem, solution);
  return verified_text(problem, solution, report).map([&](std::string text) {
    report.text = std::move(text);
    return std::move(report);
  });
}

}  // namespace higherpair
