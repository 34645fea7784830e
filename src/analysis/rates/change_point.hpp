#pragma once

#include "analysis/tolerances.hpp"
#include "group_expansion.hpp"
#include "higherpair/analysis/status.hpp"
#include "higherpair/mechanism/condition_system.hpp"
#include "numeric/singular_values.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

namespace higherpair {

/// A polynomial in τ as one in τ - ahead.
template <class D, int N>
[[nodiscard]] PowerSeries<D, N> moved(PowerSeries<D, N> series, double ahead) {
  std::size_t last = N;
  while (last > 0 && series.c[last] == D(0.0)) --last;
  for (std::size_t from = 0; from < last; ++from) {
    for (std::size_t k = last; k-- > from;) {
      series.c[k] += ahead * series.c[k + 1];
    }
  }
  return series;
}

template <class D, int N>
[[nodiscard]] Coordinates<PowerSeries<D, N>> moved(Coordinates<PowerSeries<D, N>> at, double ahead) {
  for (BodyAt<PowerSeries<D, N>>& body : at.bodies) {
    body.theta = moved(body.theta, ahead);
    body.X_WB = {Rotation<PowerSeries<D, N>>::from_angle(body.theta),
                 {moved(body.X_WB.p_WB.x(), ahead), moved(body.X_WB.p_WB.y(), ahead)}};
  }
  for (auto* all : {&at.phi, &at.arcs, &at.drivers, &at.held_angles}) {
    for (PowerSeries<D, N>& one : *all) {
      one = moved(one, ahead);
    }
  }
  return at;
}

/// A change point of a group near a place of a path, and the series of the group through it.
///
/// F(x(τ), τ) = 0 are the group's conditions along the path. At a change point J = ∂F/∂x has one null vector
/// c, and order k of the series,
///     J x_k = -(what lower orders leave of F at order k),
/// says nothing of x_k along c. But the next order has a solution only if b·F_{k+1} = 0, where b combines
/// conditions so that their derivatives vanish. That determines it: x_k enters in it as
///     b·(dJ/dτ) c,
/// for every k, the rate at which J regains its rank along the branch. Where branches cross at an angle that
/// is not small, and, unlike beside the change point, no order amplifies the rounding of the one before.
/// \tparam D  of the dimensions: double, or Partials by a parameter, of which the same holds
template <class D, int N>
class ChangePoint {
public:
  using Series = PowerSeries<D, N>;

  enum class Outcome {
    kNone,       ///< there is none so near that the series through it describes the place
    kReached,    ///< the group's coordinates are series about the place
    kRounding,   ///< branches come so near each other that rounding decides what the series are
    kDestroyed,  ///< the branches cross, but not with another value of the parameter
  };

  /// \param at     about the place: the series of known bodies, the group's own coordinates and first rates,
  ///               which say on which branch it is
  /// \param exact  false: its curves are those of the mechanism at the place only
  ChangePoint(const ConditionSystem& system, const Dimensions<D>& dimensions, Coordinates<Series>& at,
              bool exact)
      : group_(system, dimensions, at), beside_(at), exact_(exact) {
    beside_rates_ = group_.coefficient(1, 0);
    beside_place_ = group_.coefficient(0, 0);
  }

  [[nodiscard]] Outcome solve() {
    const Outcome outcome = find() ? pass_through() : Outcome::kNone;
    Coordinates<Series>& at = group_.at();
    Coordinates<Series> found = std::move(at);
    at = std::move(beside_);
    if (outcome == Outcome::kReached) {
      found = moved(std::move(found), -ahead_);
      for (const int body : group_.set().bodies) {
        at.bodies[body] = found.bodies[body];
      }
      for (const int contact : group_.set().contacts) {
        at.phi[contact] = found.phi[contact];
      }
    }
    return outcome;
  }

private:
  // Newton's method for the place on the branch at which J has lost its rank.
  [[nodiscard]] bool find() {
    for (int i = 0; i < kMostChangePointSteps; ++i) {
      if (!split()) {
        return false;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        add_order(k, 0);
      }
      const double step = -b_.dot(J_ * c_) / regained_;
      const double speed = length(1, 0) / group_.size();
      ahead_ += step;
      if (!(std::abs(ahead_) * speed <= kChangePointReach)) {
        return false;
      }
      group_.at() = moved(std::move(group_.at()), step);
      if (std::abs(step) * speed <= kAtChangePoint) {
        return split();
      }
    }
    return false;
  }

  // Sets J, c, b and the rate at which J regains its rank; false unless the rest of J is regular.
  [[nodiscard]] bool split() {
    if (!group_.jacobian(J_) || J_.rows() < J_.cols() || J_.cols() < 2) {
      return false;
    }
    const Eigen::Index n = J_.cols();
    svd_ = singular_values(J_);
    c_ = svd_.V.col(n - 1);
    // F_2 is quadratic in x_1, so that its derivative is this difference.
    const double h = std::max(length(1, 0), group_.size());
    group_.add(1, 0, h * c_);
    Eigen::VectorXd by_c = group_.conditions(2, 0);
    group_.add(1, 0, -2 * h * c_);
    by_c -= group_.conditions(2, 0);
    group_.add(1, 0, h * c_);
    const auto left = svd_.U.rightCols(J_.rows() - n + 1);
    b_ = left * (left.transpose() * by_c) / (2 * h);
    regained_ = b_.norm();
    b_ /= regained_;
    return b_.allFinite() && svd_.values(n - 2) > kOneLostRank * svd_.values(0);
  }

  // Adds to x_k what its own order lacks, and along c what the next one does.
  void add_order(std::size_t k, std::size_t i) {
    const Eigen::Index rank = J_.cols() - 1;
    const Eigen::VectorXd lacks = svd_.U.leftCols(rank).transpose() * group_.conditions(k, i);
    group_.add(k, i, -svd_.V.leftCols(rank) * lacks.cwiseQuotient(svd_.values.head(rank)));
    group_.add(k, i, -b_.dot(group_.conditions(k + 1, i)) / regained_ * c_);
  }

  [[nodiscard]] Outcome pass_through() {
    double destroyed = 0;
    for (std::size_t i = 0; i < kParts<D>; ++i) {
      const double before = largest(group_.conditions(0, i));
      for (std::size_t k = 0; k < N; ++k) {
        add_order(k, i);
      }
      destroyed = i == 1 && before > 0 ? largest(group_.conditions(0, i)) / before : 0;
    }
    const double apart = largest(group_.conditions(0, 0)) / group_.size();
    if (!converges() || !(apart <= kMeetsNoLonger)) {
      return Outcome::kNone;
    }
    if (!(apart <= kCrosses) || !exact_ || !is_on_branch()) {
      return Outcome::kRounding;
    }
    return destroyed > kKeepsChangePoint ? Outcome::kDestroyed : Outcome::kReached;
  }

  // Whether the last terms of the derivatives beside the change point hardly count.
  [[nodiscard]] bool converges() {
    for (std::size_t i = 0; i < kParts<D>; ++i) {
      for (std::size_t k = 0; k <= kHighestDerivative; ++k) {
        double all = 0, last = 0, factor = 1;  // (n over k) ahead^(n-k)
        for (std::size_t n = k; n < N; ++n) {
          last = std::max(n + 2 < N ? 0 : last, factor * length(n, i));
          all = std::max(all, factor * length(n, i));
          factor *= std::abs(ahead_) * static_cast<double>(n + 1) / static_cast<double>(n + 1 - k);
        }
        if (!(last <= kLastTerms * all)) {
          return false;
        }
      }
    }
    return true;
  }

  // Whether the series leads through the place that it was to describe, and as fast.
  [[nodiscard]] bool is_on_branch() {
    Eigen::VectorXd place = Eigen::VectorXd::Zero(beside_place_.size()), rates = place;
    double power = 1;
    for (std::size_t k = 0; k < N; ++k) {
      place += power * group_.coefficient(k, 0);
      rates += power * static_cast<double>(k + 1) * group_.coefficient(k + 1, 0);
      power *= -ahead_;
    }
    return largest(place - beside_place_) <= kSameBranch * group_.size() &&
           largest(rates - beside_rates_) <= kSameBranch * largest(beside_rates_);
  }

  [[nodiscard]] static double largest(const Eigen::VectorXd& v) { return v.lpNorm<Eigen::Infinity>(); }
  [[nodiscard]] double length(std::size_t k, std::size_t i) { return largest(group_.coefficient(k, i)); }

  GroupExpansion<D, N> group_;
  Coordinates<Series> beside_;
  Eigen::VectorXd beside_place_, beside_rates_;
  bool exact_;
  double ahead_ = 0;  // of the change point from the place
  Eigen::MatrixXd J_;
  SingularValues svd_;
  Eigen::VectorXd b_, c_;
  double regained_ = 0;  // b·(dJ/dτ) c
};

}  // namespace higherpair
