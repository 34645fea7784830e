#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

namespace higherpair {

/// Solves A x = b for a square A of any size by LU decomposition with row exchanges. Finite only if A is
/// regular.
class LuSolver {
public:
  LuSolver() = default;
  explicit LuSolver(const Eigen::MatrixXd& A) { compute(A); }

  void compute(const Eigen::MatrixXd& A);

  /// Any number of right-hand sides, as columns.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;
  [[nodiscard]] auto pivots() const { return factors_.matrixLU().diagonal(); }
  /// Sign of the determinant, -1 or 1.
  [[nodiscard]] int sign() const;

private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace higherpair
