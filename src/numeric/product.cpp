#include "product.hpp"

namespace higherpair {

Eigen::MatrixXd product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return A * B;
}

}  // namespace higherpair
