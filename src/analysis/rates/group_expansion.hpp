#pragma once

#include "higherpair/geometry/expansion.hpp"
#include "higherpair/mechanism/condition_system.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// The parts of a coefficient of a series, which are solved for one after the other: the number, and its
/// partial by a parameter.
template <class D>
inline constexpr std::size_t kParts = 1;
template <>
inline constexpr std::size_t kParts<Partials<double, 1>> = 2;

inline double& part(double& coefficient, std::size_t /*i*/) {
  return coefficient;
}
inline double& part(Partials<double, 1>& coefficient, std::size_t i) {
  return coefficient.c[i];
}

/// The coordinates of a group as power series among those of a whole mechanism: x_k is the k-th coefficient
/// of the unknowns of a ConditionSystem. Rotations of its bodies are worked out up to the coefficient that is
/// asked for: every sum of a series of high order has as many terms.
template <class D, int N>
class GroupExpansion {
public:
  using Series = PowerSeries<D, N>;

  GroupExpansion(const ConditionSystem& system, const Dimensions<D>& dimensions, Coordinates<Series>& at)
      : system_(system), dimensions_(dimensions), at_(at) {}

  /// The Jacobian of the conditions by x_0; false where they have none.
  [[nodiscard]] bool jacobian(Eigen::MatrixXd& J) {
    turn_up_to(0);
    Eigen::VectorXd values;
    return system_.evaluate(values_of(at_), values, J) && J.allFinite();
  }

  /// The coefficients of the conditions at the order k.
  [[nodiscard]] Eigen::VectorXd conditions(std::size_t k, std::size_t i) {
    turn_up_to(k);
    values_.clear();
    append_conditions(dimensions_, system_.set(), at_, system_.size(), values_);
    Eigen::VectorXd left(system_.row_count());
    for (Eigen::Index row = 0; row < left.size(); ++row) {
      left(row) = part(values_[row].c[k], i);
    }
    return left;
  }

  [[nodiscard]] Eigen::VectorXd coefficient(std::size_t k, std::size_t i) {
    Eigen::VectorXd x(system_.column_count());
    each_unknown(k, i, [&](Eigen::Index column, double& value, double unit) { x(column) = unit * value; });
    return x;
  }

  /// Adds to x_k.
  void add(std::size_t k, std::size_t i, const Eigen::VectorXd& x) {
    each_unknown(k, i, [&](Eigen::Index column, double& value, double unit) { value += x(column) / unit; });
    turned_ = std::min(turned_, k);
  }

  /// Completes the rotations of its bodies.
  void complete() { turn_up_to(N); }

  [[nodiscard]] const ConditionSet& set() const { return system_.set(); }
  [[nodiscard]] double size() const { return system_.size(); }
  [[nodiscard]] Coordinates<Series>& at() { return at_; }

private:
  void turn_up_to(std::size_t k) {
    for (; turned_ <= k; ++turned_) {
      for (const int index : system_.set().bodies) {
        auto& [X_WB, theta] = at_.bodies[index];
        if (turned_ > 0) {
          set_coefficient(turned_, theta, X_WB.R_WB.cos, X_WB.R_WB.sin);
        } else {
          const auto first = Rotation<D>::from_angle(theta.c[0]);
          X_WB.R_WB.cos.c[0] = first.cos;
          X_WB.R_WB.sin.c[0] = first.sin;
        }
      }
    }
  }

  // \param f  of a column, the coordinate's coefficient and its unit in m
  template <class F>
  void each_unknown(std::size_t k, std::size_t i, F f) {
    const double size = system_.size();
    for (const int index : system_.set().bodies) {
      BodyAt<Series>& body = at_.bodies[index];
      const Eigen::Index column = system_.body_column(index);
      f(column, part(body.X_WB.p_WB.x().c[k], i), 1.0);
      f(column + 1, part(body.X_WB.p_WB.y().c[k], i), 1.0);
      f(column + 2, part(body.theta.c[k], i), size);
    }
    for (const int contact : system_.set().contacts) {
      f(system_.contact_column(contact), part(at_.phi[contact].c[k], i), size);
    }
  }

  const ConditionSystem& system_;
  const Dimensions<D>& dimensions_;
  Coordinates<Series>& at_;
  std::vector<Series> values_;
  std::size_t turned_ = N + 1;  // coefficients of rotations that are those of the angles
};

}  // namespace higherpair
