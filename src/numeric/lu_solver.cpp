#include "lu_solver.hpp"

namespace higherpair {

void LuSolver::compute(const Eigen::MatrixXd& A) {
  factors_.compute(A);
}

Eigen::MatrixXd LuSolver::solve(const Eigen::MatrixXd& b) const {
  return factors_.solve(b);
}

int LuSolver::sign() const {
  const auto negative = (pivots().array() < 0).count();
  return static_cast<int>(factors_.permutationP().determinant()) * (negative % 2 == 0 ? 1 : -1);
}

}  // namespace higherpair
