#include "least_norm.hpp"

namespace higherpair {

void LeastNormSolver::compute(const Eigen::MatrixXd& J) {
  decomposition_.compute(J);
}

Eigen::VectorXd LeastNormSolver::solve(const Eigen::VectorXd& b) const {
  return decomposition_.solve(b);
}

Eigen::MatrixXd LeastNormSolver::pseudoinverse() const {
  return decomposition_.pseudoInverse();
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
