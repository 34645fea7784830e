#include "design_placement.hpp"

#include <cmath>

namespace higherpair {

PathPlacement::PathPlacement(const DesignTask::PointPath& path, std::span<const Vector2d> places)
    : path_(path) {
  const auto count = static_cast<Eigen::Index>(places.size());
  P_.resize(count);
  T_.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    P_(i) = {places[k].x(), places[k].y()};
    T_(i) = {path.through[k].x(), path.through[k].y()};
  }
  if (path.free_position) {
    P_.array() -= P_.mean();
    T_.array() -= T_.mean();
  }
  sum_ = P_.dot(T_);  // conjugates its first factor
  size2_ = P_.squaredNorm();
  const double far = std::abs(sum_);
  if (path.free_turn && path.free_scale) {
    z_ = size2_ > 0 ? sum_ / size2_ : 0;
  } else if (path.free_turn) {
    z_ = far > 0 ? sum_ / far : 1;
  } else if (path.free_scale) {
    z_ = size2_ > 0 ? sum_.real() / size2_ : 0;
  }
}

Eigen::VectorXd PathPlacement::misses() const {
  Eigen::VectorXd misses(2 * P_.size());
  for (Eigen::Index i = 0; i < P_.size(); ++i) {
    const Complex off = z_ * P_(i) - T_(i);
    misses.segment<2>(2 * i) << off.real(), off.imag();
  }
  return misses;
}

Eigen::MatrixXd PathPlacement::miss_slopes(const Eigen::MatrixXd& place_slopes) const {
  Eigen::MatrixXd slopes(place_slopes.rows(), place_slopes.cols());
  Eigen::VectorXcd dP(P_.size());
  for (Eigen::Index k = 0; k < place_slopes.cols(); ++k) {
    for (Eigen::Index i = 0; i < dP.size(); ++i) {
      dP(i) = {place_slopes(2 * i, k), place_slopes(2 * i + 1, k)};
    }
    if (path_.free_position) dP.array() -= dP.mean();
    const Complex sum = dP.dot(T_);
    const double size2 = 2 * P_.dot(dP).real();
    const double far = std::abs(sum_);
    Complex z = 0;
    if (path_.free_turn && path_.free_scale) {
      z = size2_ > 0 ? (sum - z_ * size2) / size2_ : 0;
    } else if (path_.free_turn) {
      z = far > 0 ? (sum - z_ * (std::conj(z_) * sum).real()) / far : 0;
    } else if (path_.free_scale) {
      z = size2_ > 0 ? (sum.real() - z_ * size2) / size2_ : 0;
    }
    for (Eigen::Index i = 0; i < dP.size(); ++i) {
      const Complex off = z * P_(i) + z_ * dP(i);
      slopes(2 * i, k) = off.real();
      slopes(2 * i + 1, k) = off.imag();
    }
  }
  return slopes;
}

}  // namespace higherpair
