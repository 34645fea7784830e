#include "higherpair/front/design.hpp"

#include "design_report.hpp"
#include "design_setup.hpp"
#include "front/demands.hpp"
#include "front/model_data.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace higherpair {
namespace {

constexpr int kStarts = 200;
constexpr std::int64_t kEvaluations = 2'000'000;

DesignOptions options_of(const DesignTask& task, const DesignSettings& settings) {
  DesignOptions options;
  static_cast<DesignRun&>(options) = settings;
  options.method = task.method;
  options.seed = settings.seed.value_or(task.seed.value_or(1));
  options.starts = settings.starts.value_or(task.starts.value_or(kStarts));
  options.evaluations = settings.evaluations.value_or(kEvaluations);
  options.target = task.target;
  options.alternatives = settings.best;
  return options;
}

std::string fault_of(const DesignSettings& settings) {
  return first_unmet({at_least(1, "setting starts", settings.starts.value_or(1)),
                      at_least(1, "setting evaluations", settings.evaluations.value_or(1)),
                      at_least(1, "setting best", settings.best),
                      at_least(0.0, "setting seconds", settings.seconds)});
}

std::string_view method_text(DesignMethod method, bool has_cost) {
  switch (method) {
    case DesignMethod::kCobyla:
      return "COBYLA";
    case DesignMethod::kBobyqa:
      return "BOBYQA";
    case DesignMethod::kIsres:
      return "ISRES";
    case DesignMethod::kAuto:
    case DesignMethod::kLeastSquares:
      if (!has_cost) return "least squares (Levenberg-Marquardt), SLSQP at constraints";
      [[fallthrough]];
    default:
      return "SLSQP";
  }
}

}  // namespace

Result<DesignReport> design(const Model& model, const DesignSettings& settings) {
  if (!model.data().document) {
    return wrong(model, "was built and has no profile that a design could be written into");
  }
  if (std::string fault = fault_of(settings); !fault.empty()) {
    return wrong(model, std::move(fault));
  }
  const auto setup = design_setup(model);
  if (!setup) {
    return tl::unexpected(setup.error());
  }
  const DesignTask& task = (*setup)->numbers.task();
  const DesignProblem problem = problem_of(*setup);
  const DesignOutcome outcome = optimise(problem, options_of(task, settings));
  if (outcome.best.x.empty()) {
    return tl::unexpected(error_about(
        model.data(), ErrorKind::kMechanism,
        "no candidate within the bounds could be worked out; change `min` and `max` of design.variables"));
  }
  return design_report(**setup, outcome).map([&](DesignReport report) {
    report.method = method_text(task.method, problem.has_cost);
    return report;
  });
}

}  // namespace higherpair
