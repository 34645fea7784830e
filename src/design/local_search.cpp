#include "numeric/eigen_index.hpp"
#include "numeric/least_norm.hpp"
#include "search.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

DesignMethod method_for(const DesignProblem& problem, DesignMethod method) {
  if (method == DesignMethod::kAuto) {
    method = !problem.smooth    ? DesignMethod::kCobyla
             : problem.has_cost ? DesignMethod::kSlsqp
                                : DesignMethod::kLeastSquares;
  }
  return method == DesignMethod::kLeastSquares && problem.has_cost ? DesignMethod::kSlsqp : method;
}

bool gains(const DesignPoint& before, const DesignPoint& after) {
  return after.violation < before.violation - kConstraintTolerance ||
         after.objective < before.objective - kWorthwhileGain * std::abs(before.objective);
}

// Looks for something better at small steps along each variable: where an extreme passes from one place to
// another the objective has a kink, at which its gradient may show no way down although there is one.
bool looks_around(Search& search) {
  const DesignPoint before = search.best();
  const Eigen::VectorXd u = search.best_unit();
  for (Eigen::Index i = 0; i < u.size() && !search.stopped(); ++i) {
    for (const double step : {-kLookAround, kLookAround}) {
      Eigen::VectorXd near = u;
      near(i) = std::clamp(u(i) + step, 0.0, 1.0);
      if (!search.is_fixed(static_cast<std::size_t>(i))) (void)search.evaluate(near);
    }
  }
  return gains(before, search.best());
}

// Starts again from the best point as long as that brings a gain: a new start discards a bad local model.
void repeat(Search& search, DesignMethod method, std::uint64_t seed) {
  constexpr int kMostRounds = 4;  // each costs as much as the search itself; one search in five needs all
  const bool kinks = method == DesignMethod::kSlsqp && search.problem().has_cost;
  for (int round = 0; round < kMostRounds && !search.stopped(); ++round) {
    const DesignPoint before = search.best();
    search_by_nlopt(search, search.best_unit(), method, seed);
    if (!gains(before, search.best()) && !(kinks && looks_around(search))) {
      return;
    }
  }
}

// How far a number is from the nearest multiple of a step, in steps.
double off_step(const DesignVariable& variable, double x) {
  return std::abs(x - variable.step * std::round(x / variable.step)) / variable.step;
}

// The multiples of its step next to a number, within the range of its variable.
std::vector<double> multiples_beside(const DesignVariable& variable, double x) {
  const double slack = kOnDesignStep * variable.step;  // of a bound that is itself a multiple, for rounding
  std::vector<double> values;
  for (const double count :
       {std::floor(x / variable.step + kOnDesignStep), std::ceil(x / variable.step - kOnDesignStep)}) {
    const double multiple = variable.step * count;
    if (multiple >= variable.low - slack && multiple <= variable.high + slack) {
      values.push_back(std::clamp(multiple, variable.low, variable.high));
    }
  }
  return values;
}

// The best design near `point`, in its branch, with variable i at the best of some values, at which it is
// fixed; `point` itself, with the variable fixed as it is, if there is none.
DesignPoint fixed_at_best(Search& search, const DesignPoint& point, std::size_t i,
                          const std::vector<double>& values, DesignMethod method) {
  DesignPoint best;
  double kept = point.x[i];
  for (const double value : values) {
    search.fix(i, value);
    search.use_branch(point.branch);
    search_locally(search, search.unit_of(point.x), method, 1);
    if (!search.best().x.empty() && (best.x.empty() || is_better(search.best(), best))) {
      best = search.best();
      kept = value;
    }
  }
  search.fix(i, kept);
  return best.x.empty() ? point : best;
}

}  // namespace

void search_locally(Search& search, const Eigen::VectorXd& u, DesignMethod method, std::uint64_t seed) {
  const DesignMethod chosen = method_for(search.problem(), method);
  (void)search.evaluate(u);
  if (search.best().x.empty()) {
    return;
  }
  if (chosen == DesignMethod::kLeastSquares) {
    const Eigen::VectorXd end = fit_least_squares(search, u);
    if (search.problem().constraints == 0) {
      return;
    }
    // The best point seen may be inside the constraints although the end of the least squares lies against
    // one.
    const bool inside = search.best().violation <= -kActiveConstraint;
    if (inside && violation_of(search.evaluate(end)) > -kActiveConstraint) {
      search_by_nlopt(search, end, DesignMethod::kSlsqp, seed);
    }
    if (!inside || search.best().violation > -kActiveConstraint) {
      repeat(search, DesignMethod::kSlsqp, seed);
    }
    return;
  }
  search_by_nlopt(search, u, chosen, seed);
  repeat(search, chosen == DesignMethod::kIsres ? DesignMethod::kCobyla : chosen, seed);
}

// One variable after the other, beginning with the one nearest to a multiple of its step: both neighbouring
// multiples are tried, the free variables are optimised again for each, and the better one is kept.
DesignPoint rounded_to_steps(Search& search, const DesignPoint& point, DesignMethod method) {
  const std::vector<DesignVariable>& variables = search.problem().variables;
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (variables[i].step > 0) left.push_back(i);
  }
  DesignPoint at = point;
  while (!left.empty()) {
    const auto off = [&](std::size_t i) { return off_step(variables[i], at.x[i]); };
    const auto next = std::min_element(left.begin(), left.end(),
                                       [&](std::size_t a, std::size_t b) { return off(a) < off(b); });
    const std::size_t i = *next;
    left.erase(next);
    at = fixed_at_best(search, at, i, multiples_beside(variables[i], at.x[i]), method);
  }
  return at;
}

// At an optimum the gradient of the objective is -Σ λ times the gradients of the active constraints and
// bounds, with λ >= 0. Solved by least squares; constraints with λ < 0 are dropped, the most negative one
// first.
std::vector<double> multipliers_at(Search& search, const DesignPoint& point) {
  const Eigen::VectorXd u = search.unit_of(point.x);
  search.use_branch(point.branch);
  const DesignValues values = search.evaluate(u);
  std::vector<double> multipliers(static_cast<std::size_t>(values.constraints.size()), 0.0);
  std::vector<Eigen::Index> active;
  for (Eigen::Index k = 0; k < values.constraints.size(); ++k) {
    if (values.constraints(k) > -kActiveConstraint) active.push_back(k);
  }
  if (!search.problem().smooth || active.empty()) {
    return multipliers;
  }
  const DesignJacobian jacobian = search.differentiate(u);
  const Eigen::VectorXd slope = objective_slope(values, jacobian).transpose();
  Eigen::VectorXd free = Eigen::VectorXd::Ones(u.size());
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    if (u(i) < kActiveConstraint || u(i) > 1 - kActiveConstraint) free(i) = 0;
  }
  while (!active.empty()) {
    Eigen::MatrixXd A(u.size(), eigen_index(active.size()));
    for (std::size_t k = 0; k < active.size(); ++k) {
      A.col(eigen_index(k)) = free.cwiseProduct(jacobian.constraints.row(active[k]).transpose());
    }
    const Eigen::VectorXd lambda = LeastNormSolver(A).solve(-free.cwiseProduct(slope));
    Eigen::Index worst = 0;
    if (lambda.minCoeff(&worst) >= 0) {
      for (std::size_t k = 0; k < active.size(); ++k) {
        multipliers[active[k]] = lambda(eigen_index(k));
      }
      break;
    }
    active.erase(active.begin() + worst);
  }
  return multipliers;
}

}  // namespace higherpair
