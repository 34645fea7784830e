#include "design_placement.hpp"

#include "numeric/eigen_index.hpp"
#include "numeric/least_norm.hpp"
#include "numeric/similarity.hpp"

#include <cmath>

namespace higherpair {
namespace {

using Complex = PathPlacement::Complex;

constexpr Complex kQuarterTurn = {0, 1};

double dot(const Complex& a, const Complex& b) {
  return a.real() * b.real() + a.imag() * b.imag();
}

}  // namespace

PathPlacement::PathPlacement(const DesignTask::PointPath& path, std::span<const Vector2d> places)
    : path_(path) {
  const auto count = eigen_index(places.size());
  P_.resize(count);
  T_.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    P_(i) = {places[k].x(), places[k].y()};
    T_(i) = {path.through[k].x(), path.through[k].y()};
  }
  if (path.free_position) {
    P_mean_ = P_.mean();
    T_mean_ = T_.mean();
    P_.array() -= P_mean_;
    T_.array() -= T_mean_;
  }
  sum_ = P_.dot(T_);  // conjugates its first factor
  size2_ = P_.squaredNorm();
  z_ = best_similarity(sum_, size2_, path.free_turn, path.free_scale);
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
      z = sum_.real() > 0 ? (sum.real() - z_ * size2) / size2_ : 0;
    }
    for (Eigen::Index i = 0; i < dP.size(); ++i) {
      const Complex off = z * P_(i) + z_ * dP(i);
      slopes(2 * i, k) = off.real();
      slopes(2 * i + 1, k) = off.imag();
    }
  }
  return slopes;
}

// Unit normals of the placed path; where it has no tangent, or is a point, the direction of the miss.
std::vector<Complex> PathPlacement::normals(std::span<const Vector2d> along) const {
  std::vector<Complex> normals;
  for (Eigen::Index i = 0; i < P_.size(); ++i) {
    const Vector2d& tangent = along[i];
    const Complex off = z_ * P_(i) - T_(i);
    const Complex turned = kQuarterTurn * z_ * Complex(tangent.x(), tangent.y());
    const Complex normal = std::abs(turned) > 0 ? turned : off;
    normals.push_back(std::abs(normal) > 0 ? normal / std::abs(normal) : 0);
  }
  return normals;
}

Eigen::VectorXd PathPlacement::distances(std::span<const Vector2d> along) const {
  const std::vector<Complex> n = normals(along);
  Eigen::VectorXd distances(P_.size());
  for (Eigen::Index i = 0; i < P_.size(); ++i) {
    distances(i) = dot(n[i], z_ * P_(i) - T_(i));
  }
  return distances;
}

// Derivatives of the distances by the free parameters of the placement.
Eigen::MatrixXd PathPlacement::freedoms(std::span<const Complex> normals) const {
  const auto count = eigen_index(normals.size());
  Eigen::MatrixXd J(count,
                    (path_.free_position ? 2 : 0) + (path_.free_turn ? 1 : 0) + (path_.free_scale ? 1 : 0));
  for (Eigen::Index i = 0; i < count; ++i) {
    const Complex& n = normals[i];
    Eigen::Index k = 0;
    if (path_.free_position) {
      J(i, k++) = n.real();
      J(i, k++) = n.imag();
    }
    if (path_.free_turn) J(i, k++) = dot(n, kQuarterTurn * z_ * P_(i));
    if (path_.free_scale) J(i, k++) = dot(n, z_ * P_(i));
  }
  return J;
}

std::pair<Complex, Complex> PathPlacement::moved_by_tangents(std::span<const Vector2d> along) const {
  const std::vector<Complex> n = normals(along);
  const Eigen::VectorXd step = LeastNormSolver(freedoms(n)).solve(-distances(along));
  Eigen::Index k = 0;
  Complex moved = T_mean_;
  if (path_.free_position) {
    moved += Complex(step(0), step(1));
    k = 2;
  }
  const double turn = path_.free_turn ? step(k++) : 0;
  const double scale = path_.free_scale ? step(k) : 0;
  const Complex z = z_ * std::exp(Complex(scale, turn));
  return {z, moved - z * P_mean_};
}

Eigen::MatrixXd PathPlacement::distance_slopes(std::span<const Vector2d> along,
                                               const Eigen::MatrixXd& place_slopes) const {
  const std::vector<Complex> n = normals(along);
  Eigen::MatrixXd slopes(P_.size(), place_slopes.cols());
  for (Eigen::Index k = 0; k < place_slopes.cols(); ++k) {
    for (Eigen::Index i = 0; i < P_.size(); ++i) {
      const Complex dP = {place_slopes(2 * i, k), place_slopes(2 * i + 1, k)};
      slopes(i, k) = dot(n[i], z_ * dP);
    }
  }
  const Eigen::MatrixXd J = freedoms(n);
  const LeastNormSolver solver(J);
  for (auto column : slopes.colwise()) {
    column -= J * solver.solve(column);
  }
  return slopes;
}

}  // namespace higherpair
