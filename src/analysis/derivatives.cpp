#include "higherpair/analysis/derivatives.hpp"

#include "series_conditions.hpp"

#include <algorithm>
#include <cassert>

#include <Eigen/QR>

namespace higherpair {
namespace {

constexpr double kRankTolerance = 1e-10;

// The coefficients of order k of the conditions.
Eigen::VectorXd order_of(const std::vector<Series>& values, std::size_t k) {
  Eigen::VectorXd order(static_cast<Eigen::Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    order(static_cast<Eigen::Index>(i)) = coefficient(values[i], k);
  }
  return order;
}

// Column by column what the conditions change with a coordinate.
Eigen::MatrixXd jacobian_of(const SeriesConditions& conditions, const Eigen::VectorXd& start) {
  Eigen::MatrixXd J;
  for (Eigen::Index column = 0; column < conditions.columns(); ++column) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(conditions.columns(), column);
    const Eigen::VectorXd change = order_of(conditions.along({start, unit}, false), 1);
    J.conservativeResize(change.size(), conditions.columns());
    J.col(column) = change;
  }
  return J;
}

BodyDerivatives derivatives_at(const std::vector<Eigen::VectorXd>& x, Eigen::Index column, double size) {
  BodyDerivatives body;
  body.p_WB.fill(Vector2d::Zero());
  body.theta.fill(0);
  for (std::size_t k = 0; k < x.size(); ++k) {
    body.p_WB[k] = kFactorials[k] * x[k].segment<2>(column);
    body.theta[k] = kFactorials[k] * x[k](column + 2) / size;
  }
  return body;
}

}  // namespace

std::optional<std::vector<BodyDerivatives>> derivatives_of(const Run& run,
                                                           const std::vector<DriverMotion>& drivers,
                                                           int order) {
  assert(order >= 1 && order <= kHighestDerivative);
  const MotionRow& row = run.row;
  if (row.status == RowStatus::kNotAssemblable || !row.all_rates) {
    return std::nullopt;
  }
  const SeriesConditions conditions(run, drivers);
  std::vector<Eigen::VectorXd> x{conditions.start()};
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(kRankTolerance);
  solver.compute(jacobian_of(conditions, x.front()));
  if (solver.rank() < conditions.columns()) {
    return std::nullopt;
  }
  for (int k = 1; k <= order; ++k) {
    const Eigen::VectorXd left = order_of(conditions.along(x, true), static_cast<std::size_t>(k));
    x.push_back(solver.solve(-left));
    if (!x.back().allFinite()) {
      return std::nullopt;
    }
  }
  std::vector<BodyDerivatives> bodies(1);
  bodies[0].p_WB.fill(Vector2d::Zero());
  bodies[0].theta.fill(0);
  for (std::size_t i = 1; i < row.bodies.size(); ++i) {
    bodies.push_back(derivatives_at(x, 3 * (static_cast<Eigen::Index>(i) - 1), run.plan.size));
  }
  return bodies;
}

Vector2d point_derivative(const BodyDerivatives& body, const Vector2d& p_B, int k) {
  Coefficients x{}, y{}, angle{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = body.p_WB[i].x() / kFactorials[i];
    y[i] = body.p_WB[i].y() / kFactorials[i];
    angle[i] = body.theta[i] / kFactorials[i];
  }
  const Series c = cos(series_of(angle));
  const Series s = sin(series_of(angle));
  const auto order = static_cast<std::size_t>(k);
  return {(series_of(x) + p_B.x() * c - p_B.y() * s).derivative(order),
          (series_of(y) + p_B.x() * s + p_B.y() * c).derivative(order)};
}

}  // namespace higherpair
