#include "least_norm.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {

void LeastNormSolver::compute(const Eigen::MatrixXd& J) {
  decomposition_.compute(J);
}

double LeastNormSolver::least_sine(const Eigen::MatrixXd& J) const {
  if (rank() < columns()) {
    return 0;
  }
  double least = 1;
  for (Eigen::Index i = 0; i < columns(); ++i) {
    const double length = J.col(decomposition_.colsPermutation().indices()(i)).norm();
    least = std::min(least, std::abs(decomposition_.matrixQTZ()(i, i)) / length);
  }
  return least;
}

Eigen::VectorXd LeastNormSolver::solve(const Eigen::VectorXd& b) const {
  return solve_all(b);
}

Eigen::MatrixXd LeastNormSolver::pseudoinverse() const {
  return solve_all(Eigen::MatrixXd::Identity(decomposition_.rows(), decomposition_.rows()));
}

Eigen::MatrixXd LeastNormSolver::solve_all(const Eigen::MatrixXd& b) const {
  return decomposition_.solve(b);
}

int rank_of(const Eigen::MatrixXd& matrix, double floor) {
  if (matrix.rows() == 0 || matrix.cols() == 0) {
    return 0;
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
  if (qr.maxPivot() <= floor) {
    return 0;
  }
  qr.setThreshold(floor / qr.maxPivot());
  return static_cast<int>(qr.rank());
}

}  // namespace higherpair
