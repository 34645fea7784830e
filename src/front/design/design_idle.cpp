// Variables and objectives without effect, and constraints that no variable changes.
#include "design_evaluator.hpp"
#include "design_setup.hpp"
#include "front/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

// Whether all numbers are equal.
bool same(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return a.size() == b.size() && (a.array() == b.array()).all();
}

// The k-th of values that are spread evenly over the ranges of the variables: multiples of the powers of an
// irrational number (Roberts, The unreasonable effectiveness of quasirandom sequences, 2018).
std::vector<double> spread_values(const DesignTask& task, int k) {
  const std::size_t count = task.variables.size();
  double base = 2;  // the root of bᵈ⁺¹ = b + 1
  for (int i = 0; i < 30; ++i) base = std::pow(1 + base, 1 / static_cast<double>(count + 1));
  std::vector<double> x;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = 0.5 + k * std::pow(base, -static_cast<double>(i + 1));
    const DesignVariable& range = task.variables[i].range;
    x.push_back(std::lerp(range.low, range.high, share - std::floor(share)));
  }
  return x;
}

// Changes one variable after the other to see what depends on it.
class IdleParts {
public:
  // \param x  values with which the mechanism assembles, and their score
  IdleParts(const DesignSetup& setup, ScoringEvaluator& evaluator, std::vector<double> x,
            const DesignScore& start)
      : setup_(setup),
        task_(setup.numbers.task()),
        evaluator_(evaluator),
        branch_(setup.start_branch.value_or(0)),
        start_(start),
        x_(std::move(x)),
        works_(x_.size(), false),
        changed_(task_.objectives.size(), false) {
    evaluator_.evaluate(x_, branch_, before_);
    for (const double constraint : start.constraints) idle_.push_back(std::isfinite(constraint));
  }

  void vary() {
    for (std::size_t i = 0; i < x_.size(); ++i) {
      bool assembled = false;
      const DesignVariable& range = task_.variables[i].range;
      for (const double share : kIdleShares) {
        const double step = share * (range.high - range.low);
        if (vary(i, x_[i] + (x_[i] + step <= range.high ? step : -step))) assembled = true;
      }
      if (!assembled) idle_.assign(idle_.size(), false);  // nothing is known then
    }
  }

  // Variables and objectives without effect.
  [[nodiscard]] Diagnostics without_effect() const {
    Diagnostics mistakes;
    for (std::size_t i = 0; i < works_.size(); ++i) {
      if (works_[i]) continue;
      mistakes.push_back(
          {task_.variables[i].place,
           fmt::format("design.variables.{}: changes no objective and no constraint: leave it out, or "
                       "ask for something that depends on {}",
                       task_.variables[i].name, task_.variables[i].paths.front())});
    }
    for (std::size_t k = 0; k < changed_.size(); ++k) {
      if (changed_[k]) continue;
      mistakes.push_back(
          {task_.objectives[k].place,
           fmt::format("{}: is the same whatever the variables: choose an objective that depends on "
                       "them, or other variables",
                       task_.objectives[k].path_of_key)});
    }
    return mistakes;
  }

  // Constraints that do not hold and that nothing changes, not even at the bounds of the variables.
  [[nodiscard]] Diagnostics hopeless() {
    Diagnostics mistakes;
    if (is_any_hopeless()) vary_to_bounds();
    for (std::size_t k = 0; k < idle_.size(); ++k) {
      if (!is_hopeless(k)) continue;
      mistakes.push_back(
          {task_.constraints[k].place,
           fmt::format("{}: is {:.9g} whatever the variables, and does not hold: choose another "
                       "limit, or variables on which it depends",
                       task_.constraints[k].path_of_key, start_.constraints[k])});
    }
    return mistakes;
  }

  [[nodiscard]] const std::vector<bool>& idle_constraints() const { return idle_; }

private:
  // False if the mechanism does not assemble with this value of a variable, which says nothing of
  // constraints.
  bool vary(std::size_t i, double value) {
    std::vector<double> other = x_;
    other[i] = value;
    evaluator_.evaluate(other, branch_, after_);
    works_[i] = works_[i] || before_.cost != after_.cost || !same(before_.residuals, after_.residuals) ||
                !same(before_.constraints, after_.constraints);
    const DesignScore score = evaluator_.score(other, branch_);
    for (std::size_t k = 0; k < changed_.size(); ++k) {
      changed_[k] = changed_[k] || !(score.objectives[k] == start_.objectives[k]);
    }
    if (!score.started) return false;
    for (std::size_t k = 0; k < idle_.size(); ++k) {
      idle_[k] = idle_[k] && std::abs(off(after_, k) - off(before_, k)) <= kNoConstraintChange;
    }
    return true;
  }

  void vary_to_bounds() {
    bool assembled = false;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      for (const double bound : {task_.variables[i].range.low, task_.variables[i].range.high}) {
        if (vary(i, bound)) assembled = true;
      }
    }
    if (!assembled) idle_.assign(idle_.size(), false);
  }

  // By how much the worse limit of a constraint is missed, relative to its scale.
  [[nodiscard]] double off(const DesignValues& values, std::size_t k) const {
    double worst = -kInf;
    const ConstraintPlace& places = setup_.constraint_places[k];
    for (const auto& place : {places.above, places.below}) {
      if (place) worst = std::max(worst, values.constraints(*place));
    }
    return worst;
  }

  // Events come and go at once, perhaps far from the start.
  [[nodiscard]] bool is_hopeless(std::size_t k) const {
    const DesignTask::Constraint& constraint = task_.constraints[k];
    const double slack = setup_.slack(k);
    const double value = start_.constraints[k];
    const bool holds =
        value >= constraint.above.value_or(-kInf) - slack && value <= constraint.below.value_or(kInf) + slack;
    return idle_[k] && !holds && !std::holds_alternative<DesignTask::Events>(constraint.of);
  }

  [[nodiscard]] bool is_any_hopeless() const {
    for (std::size_t k = 0; k < idle_.size(); ++k) {
      if (is_hopeless(k)) return true;
    }
    return false;
  }

  const DesignSetup& setup_;
  const DesignTask& task_;
  ScoringEvaluator& evaluator_;
  const int branch_;
  const DesignScore& start_;
  const std::vector<double> x_;
  DesignValues before_, after_;
  std::vector<bool> works_;    // for each variable: whether it changes anything
  std::vector<bool> changed_;  // for each objective: whether any variable changes it
  std::vector<bool> idle_;     // for each constraint: whether none does
};

}  // namespace

Diagnostics idle_parts(DesignSetup& setup) {
  const DesignTask& task = setup.numbers.task();
  const auto evaluator = evaluator_of(setup);
  for (int k = 0; k <= kMostIdleStarts; ++k) {
    const std::vector<double> x = k == 0 ? start_values(task) : spread_values(task, k);
    const DesignScore start =
        k == 0 ? setup.start_score : evaluator->score(x, setup.start_branch.value_or(0));
    if (!start.started || start.missing > 0) {
      continue;
    }
    IdleParts parts(setup, *evaluator, x, start);
    parts.vary();
    setup.idle = parts.idle_constraints();
    Diagnostics mistakes = k == 0 ? parts.without_effect() : Diagnostics();
    const Diagnostics hopeless = parts.hopeless();
    mistakes.insert(mistakes.end(), hopeless.begin(), hopeless.end());
    return mistakes;
  }
  return {};
}

}  // namespace higherpair
