#include "designs.hpp"

#include "cases.hpp"
#include "higherpair/front/model.hpp"

#include <cmath>
#include <random>
#include <string>

#include <fmt/core.h>

namespace higherpair::bench {
namespace {

constexpr int kPlaces = 100;
constexpr int kCandidates = 64;

// design_eighteen_points, where the points are on the path of its own linkage with a slightly shorter
// coupler.
Model hundred_places() {
  const auto shipped = Model::open(std::string(HIGHERPAIR_PROFILES) + "/design_eighteen_points.toml").value();
  const std::string end = fmt::format("{}", 360.0 * (kPlaces - 1) / kPlaces);
  const Model known =
      shipped
          .with(
              {{"driver.samples", double(kPlaces)}, {"driver.end", end}, {"bodies.coupler.points.B.0", 4.6}})
          .value();
  const Motion motion = known.run().value();
  std::string through = "[";
  for (int k = 0; k < kPlaces; ++k) {
    const auto row = static_cast<std::size_t>(k);
    through +=
        fmt::format("[{}, {}], ", motion.column("coupler.E.x")[row], motion.column("coupler.E.y")[row]);
  }
  return known.with({{"design.objectives.0.path.through", through + "]"}}).value();
}

void check_derivatives(DesignEvaluator& evaluator, const DesignProblem& problem, std::vector<double> x) {
  constexpr double kStep = 1e-5;
  DesignJacobian jacobian;
  require(evaluator.differentiate(x, problem.start_branch, jacobian), "design: no derivatives");
  DesignValues high, low;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double at = x[i];
    x[i] = at + kStep;
    evaluator.evaluate(x, problem.start_branch, high);
    x[i] = at - kStep;
    evaluator.evaluate(x, problem.start_branch, low);
    x[i] = at;
    const Eigen::VectorXd expected = (high.residuals - low.residuals) / (2 * kStep);
    const double off = (jacobian.residuals.col(static_cast<Eigen::Index>(i)) - expected).norm();
    require(off <= 1e-6 * (1 + expected.norm()), fmt::format("design: derivative {} is off by {}", i, off));
  }
}

}  // namespace

DesignCase checked_design() {
  DesignCase one{design_problem(hundred_places()).value(), {}};
  std::vector<double> start;
  for (const DesignVariable& variable : one.problem.variables) start.push_back(variable.start);
  const auto evaluator = one.problem.evaluator();
  DesignValues values;
  evaluator->evaluate(start, one.problem.start_branch, values);
  require(values.residuals.size() == Eigen::Index{2} * kPlaces && values.residuals.norm() < 1e-12,
          fmt::format("design: the known linkage misses its path by {}", values.residuals.norm()));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> near(-0.05, 0.05);
  for (int k = 0; k < kCandidates; ++k) {
    std::vector<double> x = start;
    for (double& number : x) number += near(random);
    check_derivatives(*evaluator, one.problem, x);
    one.candidates.push_back(std::move(x));
  }
  return one;
}

}  // namespace higherpair::bench
