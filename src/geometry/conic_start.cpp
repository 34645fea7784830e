// Starting values for fits of conics: curves of least algebraic distance.
#include "boundary_fit.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "numeric/least_norm.hpp"
#include "numeric/least_squares.hpp"
#include "numeric/product.hpp"
#include "numeric/singular_values.hpp"

#include <cmath>

namespace higherpair::boundary_fit {
namespace {

constexpr int kAxes = 90;  // directions in which the axis of a parabola is tried

Eigen::MatrixXd monomial_rows(const std::vector<Vector2d>& points) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()), 6);
  for (std::size_t i = 0; i < points.size(); ++i) {
    rows.row(static_cast<Eigen::Index>(i)) = monomials(points[i]).transpose();
  }
  return rows;
}

}  // namespace

Coefficients monomials(const Vector2d& p) {
  Coefficients m;
  m << p.x() * p.x(), p.y() * p.y(), p.x() * p.y(), p.x(), p.y(), 1;
  return m;
}

Vector2d slope(const Coefficients& conic, const Vector2d& p) {
  return {2 * conic(0) * p.x() + conic(2) * p.y() + conic(3),
          2 * conic(1) * p.y() + conic(2) * p.x() + conic(4)};
}

// Minimises Σ F² relative to Σ |∇F|²: the constant term removes the means of the monomials, and the rest is
// the last singular vector in the metric of the slopes.
Coefficients taubin_conic(const std::vector<Vector2d>& points) {
  Eigen::MatrixXd rows = monomial_rows(points).leftCols(5);
  const Eigen::RowVectorXd mean = rows.colwise().mean();
  rows.rowwise() -= mean;
  Eigen::MatrixXd slopes(2 * rows.rows(), 5);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector2d& p = points[i];
    const auto k = 2 * static_cast<Eigen::Index>(i);
    slopes.row(k) << 2 * p.x(), 0, p.y(), 1, 0;
    slopes.row(k + 1) << 0, 2 * p.y(), p.x(), 0, 1;
  }
  const Eigen::MatrixXd metric = LeastNormSolver(triangular_factor(slopes), kSlopesRank).pseudoinverse();
  const SingularValues svd = singular_values(product(triangular_factor(rows), metric));
  const Eigen::VectorXd least = metric * svd.V.col(4);
  Coefficients conic;
  conic << least, -mean.dot(least);
  return conic.normalized();
}

// Minimises Σ F² for a given 4 A B - C² > 0: the linear terms are eliminated, and in the metric of the Σ F²
// that is left for the coefficients of the squares this form has one positive eigenvalue, whose vector is the
// ellipse.
std::optional<Coefficients> direct_ellipse(const std::vector<Vector2d>& points) {
  const Eigen::MatrixXd rows = monomial_rows(points);
  const Eigen::MatrixXd squares = rows.leftCols(3);
  const LeastNormSolver linear(rows.rightCols(3), kLinearRank);
  const Eigen::MatrixXd by_squares = -product(linear.pseudoinverse(), squares);
  const SingularValues left =
      singular_values(triangular_factor(squares + product(rows.rightCols(3), by_squares)));
  const Eigen::MatrixXd metric =
      left.V * left.values.cwiseMax(kLeastEllipseResidue * left.values(0)).cwiseInverse().asDiagonal();
  Eigen::MatrixXd form(3, 3);
  form << 0, 2, 0, 2, 0, 0, 0, 0, -1;
  const SingularValues signs = singular_values(product(metric.transpose(), product(form, metric)));
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (!(signs.U.col(k).dot(signs.V.col(k)) > 0)) continue;
    const Eigen::VectorXd a = metric * signs.V.col(k);
    Coefficients conic;
    conic << a, by_squares * a;
    return conic.normalized();
  }
  return std::nullopt;
}

// By linear least squares for each direction of the axis: u = a v² + b v + c.
Eigen::Vector4d algebraic_parabola(const std::vector<Vector2d>& points) {
  Eigen::Vector4d best(0, 0, 0, 1);
  double least = kInf;
  const auto n = static_cast<Eigen::Index>(points.size());
  for (int k = 0; k < kAxes; ++k) {
    const Vector2d axis = unit_vector(kPi * k / kAxes);
    Eigen::MatrixXd rows(n, 3);
    Eigen::VectorXd u(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Vector2d& p = points[i];
      const double v = cross(axis, p);
      rows.row(i) << v * v, v, 1;
      u(i) = axis.dot(p);
    }
    const Eigen::VectorXd by = LeastNormSolver(rows, kParabolaRank).solve(u);
    double sum = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double steepness = 2 * by(0) * rows(i, 1) + by(1);
      sum += std::pow(rows.row(i).dot(by) - u(i), 2) / (1 + steepness * steepness);
    }
    if (!(sum < least) || by(0) == 0) continue;
    least = sum;
    const double v = -by(1) / (2 * by(0));
    const Vector2d vertex = (by(2) + by(1) * v / 2) * axis + v * perp(axis);
    best << vertex, angle_of(by(0) > 0 ? axis : Vector2d(-axis)), 1 / (2 * std::abs(by(0)));
  }
  return best;
}

}  // namespace higherpair::boundary_fit
