#pragma once

#include <Eigen/Core>

namespace higherpair {

/// A B, for matrices of any size.
[[nodiscard]] Eigen::MatrixXd product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

}  // namespace higherpair
