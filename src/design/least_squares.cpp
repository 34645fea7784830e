#include "numeric/least_squares.hpp"

#include "search.hpp"

namespace higherpair {
namespace {

// Weight of a violated constraint, in the first and the second pass.
constexpr double kWeights[] = {10, 1e3};

constexpr int kMostIterations = 150;  // in one pass, counted in Jacobians

// The residuals, followed by the weighted violation of each constraint.
LeastSquaresProblem squares_of(Search& search, double weight) {
  LeastSquaresProblem squares;
  squares.low = Eigen::VectorXd::Zero(search.size());
  squares.high = Eigen::VectorXd::Ones(search.size());
  squares.residuals = [&search, weight](const Eigen::VectorXd& u, Eigen::VectorXd& r) {
    if (search.stopped()) return false;
    const DesignValues& values = search.evaluate(u);
    r.resize(values.residuals.size() + values.constraints.size());
    r << values.residuals, weight * values.constraints.cwiseMax(0.0);
    return true;
  };
  squares.jacobian = [&search, weight](const Eigen::VectorXd& u, Eigen::MatrixXd& J) {
    const Eigen::VectorXd violated = (search.evaluate(u).constraints.array() > 0).cast<double>();
    const DesignJacobian& jacobian = search.differentiate(u);
    J.resize(jacobian.residuals.rows() + violated.size(), u.size());
    J << jacobian.residuals, weight * violated.asDiagonal() * jacobian.constraints;
    return true;
  };
  return squares;
}

}  // namespace

Eigen::VectorXd fit_least_squares(Search& search, const Eigen::VectorXd& u) {
  Eigen::VectorXd from = u;
  for (const double weight : kWeights) {
    LeastSquaresOptions options;
    options.iterations = kMostIterations;
    from = least_squares(squares_of(search, weight), from, options).x;
    // Without a violation the weight makes no difference.
    if (search.stopped() || search.best().violation <= kConstraintTolerance) {
      break;
    }
  }
  return from;
}

}  // namespace higherpair
