// The point of a conic nearest to a given one.
#include "higherpair/geometry/boundary_fit.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "higherpair/numeric/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Core>

namespace higherpair {
namespace {

// Foot points p' = (I + 2 t Q)⁻¹ (p - t g) in the axes of Q, with F(p') = 0. Where I + 2 t Q is positive
// definite, F falls with t, and its zero gives the nearest foot; at the ends of that interval there is one
// only if p is on an axis, beyond the centre of curvature.
class Foot {
public:
  Foot(const std::array<double, 6>& c, const Vector2d& p) {
    const double mean = (c[0] + c[1]) / 2, difference = (c[0] - c[1]) / 2, mixed = c[2] / 2;
    const double root = std::hypot(difference, mixed);
    const double major = mean + std::copysign(root, mean);
    const double minor = major != 0 ? (c[0] * c[1] - mixed * mixed) / major : 0;
    lambda_ = {std::min(minor, major), std::max(minor, major)};
    axes_.col(1) = unit_vector(std::atan2(mixed, difference) / 2);
    axes_.col(0) = perp(Vector2d(axes_.col(1)));
    u_ = axes_.transpose() * p;
    g_ = axes_.transpose() * Vector2d(c[3], c[4]);
    constant_ = c[5];
  }

  [[nodiscard]] Vector2d find() const {
    const auto [low, high] = interval();
    const double at = zero_between(low, high);
    Vector2d foot = foot_at(at);
    if (!foot.allFinite() || std::abs(value(foot)) > kFootOffConic * size(foot)) on_axis(low, high, foot);
    return axes_ * foot;
  }

private:
  [[nodiscard]] std::pair<double, double> interval() const {
    const double most = std::max(std::abs(lambda_(0)), std::abs(lambda_(1)));
    const double far = kFarthestMultiplier / std::max(most, kNeverZero);
    return {lambda_(1) > 0 ? -0.5 / lambda_(1) : -far, lambda_(0) < 0 ? -0.5 / lambda_(0) : far};
  }

  [[nodiscard]] Vector2d foot_at(double t) const {
    return (u_ - t * g_).cwiseQuotient(Vector2d(1 + 2 * t * lambda_(0), 1 + 2 * t * lambda_(1)));
  }
  [[nodiscard]] double value(const Vector2d& p) const {
    return p.dot(lambda_.cwiseProduct(p)) + g_.dot(p) + constant_;
  }
  [[nodiscard]] double size(const Vector2d& p) const {
    return p.cwiseAbs2().dot(lambda_.cwiseAbs()) + g_.cwiseAbs().dot(p.cwiseAbs()) + std::abs(constant_);
  }

  // Newton's method; bisection where a step leaves the bracket.
  [[nodiscard]] double zero_between(double low, double high) const {
    double t = 0;
    for (int step = 0; step < 200; ++step) {
      const Vector2d foot = foot_at(t);
      const double F = value(foot);
      if (F == 0) return t;
      (F > 0 ? low : high) = t;
      const Vector2d gradient = 2 * lambda_.cwiseProduct(foot) + g_;
      const double fall =
          gradient.cwiseAbs2().dot(Vector2d(1 / (1 + 2 * t * lambda_(0)), 1 / (1 + 2 * t * lambda_(1))));
      double next = t + F / fall;
      if (!(next > low && next < high)) next = low + (high - low) / 2;
      if (next == t || next == low || next == high) return next;
      if (std::abs(next - t) <= kMultiplierSettled * std::abs(next)) return next;
      t = next;
    }
    return t;
  }

  // The foot at an end of the interval, where one coordinate does not follow from t.
  void on_axis(double low, double high, Vector2d& foot) const {
    double nearest = kInf;
    for (const Eigen::Index free : {Eigen::Index{1}, Eigen::Index{0}}) {
      const double t = free == 1 ? low : high;
      if (lambda_(free) == 0) continue;
      const Eigen::Index other = 1 - free;
      Vector2d candidate;
      candidate(other) = (u_(other) - t * g_(other)) / (1 + 2 * t * lambda_(other));
      const double rest =
          lambda_(other) * candidate(other) * candidate(other) + g_(other) * candidate(other) + constant_;
      const double half = -g_(free) / (2 * lambda_(free));
      const double square = half * half - rest / lambda_(free);
      if (!(square >= 0)) continue;
      candidate(free) = half + std::sqrt(square);
      const double distance = (candidate - u_).norm();
      if (distance < nearest) {
        nearest = distance;
        foot = candidate;
      }
    }
  }

  Eigen::Matrix2d axes_;
  Vector2d lambda_;  // ascending
  Vector2d u_, g_;
  double constant_ = 0;
};

}  // namespace

Vector2d nearest_on_conic(const std::array<double, 6>& coefficients, const Vector2d& p) {
  return Foot(coefficients, p).find();
}

}  // namespace higherpair
