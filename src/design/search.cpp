#include "search.hpp"

#include "higherpair/numeric/special_values.hpp"
#include "numeric/eigen_index.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

// Replaces values that are not finite; far larger than any real one.
constexpr double kRefused = 1e30;

}  // namespace

bool DesignEvaluator::differentiate(std::span<const double> /*x*/, int /*branch*/,
                                    DesignJacobian& /*jacobian*/) {
  return false;
}

double objective_of(const DesignValues& values) {
  return values.cost + values.residuals.squaredNorm();
}

Eigen::RowVectorXd objective_slope(const DesignValues& values, const DesignJacobian& jacobian) {
  return jacobian.cost + 2 * values.residuals.transpose() * jacobian.residuals;
}

double violation_of(const DesignValues& values) {
  return values.constraints.size() == 0 ? 0 : values.constraints.maxCoeff();
}

bool is_better(const DesignPoint& a, const DesignPoint& b) {
  const bool a_holds = a.violation <= kConstraintTolerance;
  const bool b_holds = b.violation <= kConstraintTolerance;
  if (a_holds != b_holds) {
    return a_holds;
  }
  return a_holds ? a.objective < b.objective : a.violation < b.violation;
}

double from_unit(const DesignVariable& variable, double u) {
  if (u <= 0) {
    return variable.low;
  }
  if (u >= 1) {
    return variable.high;
  }
  const double x = variable.log ? variable.low * std::pow(variable.high / variable.low, u)
                                : variable.low + u * (variable.high - variable.low);
  return std::clamp(x, variable.low, variable.high);
}

double to_unit(const DesignVariable& variable, double x) {
  const double u = variable.log ? std::log(std::max(x, variable.low) / variable.low) /
                                      std::log(variable.high / variable.low)
                                : (x - variable.low) / (variable.high - variable.low);
  return std::clamp(u, 0.0, 1.0);
}

Search::Search(const DesignProblem& problem, int branch, const Deadline& deadline)
    : problem_(problem),
      evaluator_(problem.evaluator()),
      deadline_(deadline),
      x_(problem.variables.size()),
      fixed_x_(problem.variables.size()),
      fixed_(problem.variables.size(), false) {
  use_branch(branch);
}

void Search::use_branch(int branch) {
  branch_ = branch;
  values_at_.resize(0);
  jacobian_at_.resize(0);
  best_ = {};
  best_.branch = branch;
  best_.objective = best_.violation = kInf;
}

void Search::fix(std::size_t variable, double value) {
  values_at_.resize(0);
  jacobian_at_.resize(0);
  fixed_[variable] = true;
  fixed_x_[variable] = value;
}

Eigen::VectorXd Search::unit_of(const std::vector<double>& x) const {
  Eigen::VectorXd u(size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    u(eigen_index(i)) = to_unit(problem_.variables[i], x[i]);
  }
  return u;
}

Eigen::VectorXd Search::best_unit() const {
  return unit_of(best_.x);
}

void Search::set_x(const Eigen::VectorXd& u) {
  for (std::size_t i = 0; i < x_.size(); ++i) {
    x_[i] = fixed_[i] ? fixed_x_[i] : from_unit(problem_.variables[i], u(eigen_index(i)));
  }
}

const DesignValues& Search::evaluate(const Eigen::VectorXd& u) {
  if (values_at_.size() == 0 || values_at_ != u) {
    work_out(u, values_);
    values_at_ = u;
  }
  return values_;
}

void Search::work_out(const Eigen::VectorXd& u, DesignValues& values) {
  bool finite = u.allFinite();  // a minimiser may step to what is no number where nothing changes its values
  if (finite) {
    set_x(u);
    evaluator_->evaluate(x_, branch_, values);
    ++evaluations_;
    finite = std::isfinite(values.cost) && values.residuals.allFinite() && values.constraints.allFinite();
  }
  if (!finite) {
    values.cost = problem_.has_cost ? kRefused : 0;
    values.residuals.setConstant(problem_.residuals, std::sqrt(kRefused));
    values.constraints.setConstant(problem_.constraints, kRefused);
  } else {
    note(values);
  }
}

void Search::note(const DesignValues& values) {
  const DesignPoint point{x_, branch_, objective_of(values), violation_of(values)};
  if (best_.x.empty() || is_better(point, best_)) {
    best_ = point;
  }
}

double Search::slope(std::size_t i) const {
  const DesignVariable& variable = problem_.variables[i];
  return variable.log ? x_[i] * std::log(variable.high / variable.low) : variable.high - variable.low;
}

const DesignJacobian& Search::differentiate(const Eigen::VectorXd& u) {
  if (jacobian_at_.size() > 0 && jacobian_at_ == u) {
    return jacobian_;
  }
  jacobian_at_ = u;
  if (u.allFinite()) {
    set_x(u);
  }
  if (!u.allFinite() || !evaluator_->differentiate(x_, branch_, jacobian_)) {
    by_differences(u);
    return jacobian_;
  }
  ++evaluations_;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const auto column = eigen_index(i);
    const double scale = fixed_[i] ? 0 : slope(i);
    jacobian_.cost(column) *= scale;
    jacobian_.residuals.col(column) *= scale;
    jacobian_.constraints.col(column) *= scale;
  }
  return jacobian_;
}

// Central differences; at a bound one-sided ones of second order.
void Search::by_differences(const Eigen::VectorXd& u) {
  jacobian_.cost.setZero(size());
  jacobian_.residuals.setZero(problem_.residuals, size());
  jacobian_.constraints.setZero(problem_.constraints, size());
  for (Eigen::Index i = 0; i < size(); ++i) {
    if (fixed_[i]) {
      continue;
    }
    const double at = std::clamp(u(i), 0.0, 1.0);
    const double h = at > 0.5 ? -kDesignDifference : kDesignDifference;
    const bool central = at - std::abs(h) >= 0 && at + std::abs(h) <= 1;
    const auto add = [&](double offset, double weight) {
      Eigen::VectorXd there = u;
      there(i) = at + offset;
      work_out(there, near_values_);
      jacobian_.cost(i) += weight / h * near_values_.cost;
      jacobian_.residuals.col(i) += weight / h * near_values_.residuals;
      jacobian_.constraints.col(i) += weight / h * near_values_.constraints;
    };
    add(h, central ? 0.5 : 2);
    central ? add(-h, -0.5) : add(2 * h, -0.5);
    if (!central) {
      add(0, -1.5);
    }
  }
}

}  // namespace higherpair
