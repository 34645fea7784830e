#pragma once

#include <Eigen/Core>
#include <Eigen/QR>

namespace higherpair {

/// Solves J x = b for J of any shape and rank: in the least-squares sense where there are more conditions
/// than unknowns, and with the solution of least norm where freedom is left (complete orthogonal
/// decomposition).
class LeastNormSolver {
public:
  /// \param rank_tolerance  a pivot below it, as a fraction of the largest one, counts as zero
  explicit LeastNormSolver(double rank_tolerance) { decomposition_.setThreshold(rank_tolerance); }
  LeastNormSolver(const Eigen::MatrixXd& J, double rank_tolerance) : LeastNormSolver(rank_tolerance) {
    compute(J);
  }
  /// With a tolerance for rounding only.
  explicit LeastNormSolver(const Eigen::MatrixXd& J) { compute(J); }

  void compute(const Eigen::MatrixXd& J);

  [[nodiscard]] Eigen::Index rank() const { return decomposition_.rank(); }
  /// The smallest sine of the angle between a column of J and those before it, in the order of the pivots,
  /// whatever the lengths of the columns; 0 where the rank is less than their number.
  [[nodiscard]] double least_sine(const Eigen::MatrixXd& J) const;
  [[nodiscard]] Eigen::Index columns() const { return decomposition_.cols(); }
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  [[nodiscard]] Eigen::MatrixXd pseudoinverse() const;

private:
  [[nodiscard]] Eigen::MatrixXd solve_all(const Eigen::MatrixXd& b) const;

  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition_;
};

/// Number of independent rows of a matrix: pivots of its QR decomposition above an absolute `floor`.
[[nodiscard]] int rank_of(const Eigen::MatrixXd& matrix, double floor);

}  // namespace higherpair
