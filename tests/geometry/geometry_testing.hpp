#pragma once

#include "higherpair/geometry/curve.hpp"
#include "higherpair/geometry/pose.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <ostream>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair::testing {

inline constexpr double kDegree = kPi / 180;

/// Remembers the worst of many errors; a NaN stays the worst.
class Worst {
public:
  void see(double error) {
    if (!(error <= value_)) value_ = error;
  }
  void see(const Vector2d& error) { see(error.norm()); }
  [[nodiscard]] double value() const { return value_; }

private:
  double value_ = 0;
};

#define EXPECT_AT_MOST(error, bound) EXPECT_TRUE((error) <= (bound)) << #error " = " << (error)

/// Uniform numbers with a fixed seed.
class Random {
public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  double angle() { return between(-kPi, kPi); }
  double sign() { return between(-1, 1) < 0 ? -1 : 1; }
  Vector2d vector(double size) { return {between(-size, size), between(-size, size)}; }
  Pose<double> pose(double size) { return {Rotation<double>::from_angle(angle()), vector(size)}; }
  int index(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }

private:
  std::mt19937_64 engine_;
};

/// A conic by its textbook parametrisation, which shares nothing with the vertex form of Curve: the reference
/// for all tests of curves. It runs counter-clockwise about the convex side.
///   ellipse (a cos t, b sin t), parabola (a t², -2a t), hyperbola (a cosh t, -b sinh t) about `origin_B`,
/// turned by `rotation`.
struct NaturalConic {
  CurveKind kind = CurveKind::kCircle;
  Vector2d origin_B = Vector2d::Zero();  ///< centre; vertex of a parabola
  double a = 1;                          ///< first semi-axis; focal length of a parabola
  double b = 1;                          ///< second semi-axis
  double rotation = 0;
  Side side = Side::kInside;

  [[nodiscard]] Vector2d turned(double x, double y) const {
    return Rotation<double>::from_angle(rotation) * Vector2d(x, y);
  }
  [[nodiscard]] Vector2d point(double t) const {
    if (kind == CurveKind::kParabola) return origin_B + turned(a * t * t, -2 * a * t);
    if (kind == CurveKind::kHyperbola) return origin_B + turned(a * std::cosh(t), -b * std::sinh(t));
    return origin_B + turned(a * std::cos(t), b * std::sin(t));
  }
  [[nodiscard]] Vector2d first(double t) const {
    if (kind == CurveKind::kParabola) return turned(2 * a * t, -2 * a);
    if (kind == CurveKind::kHyperbola) return turned(a * std::sinh(t), -b * std::cosh(t));
    return turned(-a * std::sin(t), b * std::cos(t));
  }
  [[nodiscard]] Vector2d second(double t) const {
    if (kind == CurveKind::kParabola) return turned(2 * a, 0);
    if (kind == CurveKind::kHyperbola) return turned(a * std::cosh(t), -b * std::sinh(t));
    return turned(-a * std::cos(t), -b * std::sin(t));
  }
  /// +1 where the body is the convex side.
  [[nodiscard]] double sense() const { return side == Side::kInside ? 1 : -1; }
  /// Outward unit normal of the body.
  [[nodiscard]] Vector2d normal(double t) const { return -sense() * perp(first(t)).normalized(); }
  /// Signed radius of curvature of the body.
  [[nodiscard]] double radius(double t) const {
    const Vector2d v = first(t);
    return sense() * v.squaredNorm() * v.norm() / cross(v, second(t));
  }

  [[nodiscard]] Curve curve() const {
    switch (kind) {
      case CurveKind::kCircle:
        return make_circle(origin_B, a, side).value();
      case CurveKind::kParabola:
        return make_parabola(origin_B, a, rotation, side).value();
      case CurveKind::kHyperbola:
        return make_hyperbola(origin_B, {a, b}, rotation, side).value();
      default:
        return make_ellipse(origin_B, {a, b}, rotation, side).value();
    }
  }

  /// The six coefficients, computed with 100 bits more than double has and rounded once.
  [[nodiscard]] std::array<double, 6> coefficients() const;

  friend void PrintTo(const NaturalConic& conic, std::ostream* out) {
    *out << "kind " << static_cast<int>(conic.kind) << " at " << conic.origin_B.transpose() << ", a "
         << conic.a << ", b " << conic.b << ", turned by " << conic.rotation;
  }
};

/// Sizes 0.1 … 1 and positions up to 1, both in units of `size`; the kinds take turns.
inline NaturalConic random_conic(Random& random, int number, double size = 1) {
  static constexpr std::array kKinds{CurveKind::kCircle, CurveKind::kEllipse, CurveKind::kParabola,
                                     CurveKind::kHyperbola};
  NaturalConic conic;
  conic.kind = kKinds[static_cast<std::size_t>(number) % 4];
  conic.origin_B = random.vector(size);
  conic.a = size * random.between(0.1, 1);
  conic.b = conic.kind == CurveKind::kCircle ? conic.a : size * random.between(0.1, 1);
  conic.rotation = random.angle();
  conic.side = number / 4 % 2 == 0 ? Side::kInside : Side::kOutside;
  return conic;
}

/// A parameter on the whole ellipse; on an open curve, not far beyond its size.
inline double random_parameter(Random& random, const NaturalConic& conic) {
  return conic.kind == CurveKind::kCircle || conic.kind == CurveKind::kEllipse ? random.angle()
                                                                               : random.between(-2, 2);
}

inline double value_at(const std::array<double, 6>& k, const Vector2d& p) {
  return (k[0] * p.x() + k[2] * p.y() + k[3]) * p.x() + (k[1] * p.y() + k[4]) * p.y() + k[5];
}

inline Vector2d gradient_at(const std::array<double, 6>& k, const Vector2d& p) {
  return {2 * k[0] * p.x() + k[2] * p.y() + k[3], 2 * k[1] * p.y() + k[2] * p.x() + k[4]};
}

/// First and second derivative of a function at t, by seven-point central differences (sixth order).
template <class F>
auto differentiate(const F& value, double t, double h) {
  using Value = std::decay_t<decltype(value(t))>;
  const auto odd = [&](int k) -> Value { return value(t + k * h) - value(t - k * h); };
  const auto even = [&](int k) -> Value {
    return (value(t + k * h) - value(t)) + (value(t - k * h) - value(t));
  };
  const Value first = (45 * odd(1) - 9 * odd(2) + odd(3)) / (60 * h);
  const Value second = (270 * even(1) - 27 * even(2) + 2 * even(3)) / (180 * h * h);
  return std::pair<Value, Value>{first, second};
}

}  // namespace higherpair::testing
