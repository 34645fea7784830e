#pragma once

#include <Eigen/Core>

namespace higherpair {

/// matrix = U diag(values) Vᵀ: U and V square and orthogonal, the values in decreasing order. Two-sided
/// Jacobi rotations, which keep small singular values accurate.
struct SingularValues {
  Eigen::MatrixXd U;
  Eigen::VectorXd values;
  Eigen::MatrixXd V;
};

[[nodiscard]] SingularValues singular_values(const Eigen::MatrixXd& matrix);

}  // namespace higherpair
