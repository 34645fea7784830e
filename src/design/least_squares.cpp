#include "search.hpp"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/LevenbergMarquardt>

namespace higherpair {
namespace {

// So heavy is a constraint that does not hold, in the first of two passes and in the second.
constexpr double kWeights[] = {10, 1e3};

constexpr int kMostIterations = 300;  // evaluations of one pass, gradients apart

// Bounds by u = (1 - cos z)/2, which has no ends. At a bound itself the derivative is 0, from where no step
// leads: starts keep this distance.
constexpr double kFromBound = 1e-3;

Eigen::VectorXd unbounded(const Eigen::VectorXd& u) {
  return u.unaryExpr([](double v) { return std::acos(1 - 2 * std::clamp(v, kFromBound, 1 - kFromBound)); });
}

Eigen::VectorXd bounded(const Eigen::VectorXd& z) {
  return z.unaryExpr([](double v) { return (1 - std::cos(v)) / 2; });
}

// The residuals and, for each constraint, what it misses by; rows of 0 where there are fewer than variables,
// which MINPACK's method does not take.
class Fit : public Eigen::DenseFunctor<double> {
public:
  Fit(Search& search, double weight)
      : DenseFunctor(static_cast<int>(search.size()),
                     static_cast<int>(
                         std::max(search.size(), search.problem().residuals + search.problem().constraints))),
        search_(search),
        weight_(weight) {}

  int operator()(const Eigen::VectorXd& z, Eigen::VectorXd& f) const {
    if (search_.stopped()) {
      return -1;
    }
    const DesignValues& values = search_.evaluate(bounded(z));
    f.setZero(this->values());
    f.head(values.residuals.size()) = values.residuals;
    f.segment(values.residuals.size(), values.constraints.size()) =
        weight_ * values.constraints.cwiseMax(0.0);
    return 0;
  }

  int df(const Eigen::VectorXd& z, Eigen::MatrixXd& J) const {
    const Eigen::VectorXd u = bounded(z);
    const Eigen::VectorXd constraints = search_.evaluate(u).constraints;
    const DesignJacobian& jacobian = search_.differentiate(u);
    J.setZero(this->values(), inputs());
    J.topRows(jacobian.residuals.rows()) = jacobian.residuals;
    for (Eigen::Index k = 0; k < constraints.size(); ++k) {
      if (constraints(k) > 0) {
        J.row(jacobian.residuals.rows() + k) = weight_ * jacobian.constraints.row(k);
      }
    }
    J *= (z.array().sin() / 2).matrix().asDiagonal();
    return J.allFinite() ? 0 : -1;
  }

private:
  Search& search_;
  double weight_;
};

}  // namespace

void fit_least_squares(Search& search, const Eigen::VectorXd& u) {
  Eigen::VectorXd z = unbounded(u);
  for (const double weight : kWeights) {
    Fit fit(search, weight);
    Eigen::LevenbergMarquardt<Fit> method(fit);
    method.setMaxfev(kMostIterations);
    method.setFtol(1e-15);
    method.setXtol(1e-15);
    method.setFactor(1);
    (void)method.minimize(z);
    // Without a violation the weight makes no difference.
    if (search.stopped() || search.best().violation <= kConstraintTolerance) {
      return;
    }
  }
}

}  // namespace higherpair
