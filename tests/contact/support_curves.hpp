#pragma once

#include "higherpair/geometry/curve.hpp"
#include "higherpair/geometry/pose.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace higherpair::testing {

/// Smallest and largest cos(x) over an interval, from its ends and the multiples of π inside.
inline Bounds cosine_over(double low, double high) {
  Bounds range{std::min(std::cos(low), std::cos(high)), std::max(std::cos(low), std::cos(high))};
  for (long k = std::lround(std::ceil(low / kPi)); k <= std::lround(std::floor(high / kPi)); ++k) {
    range.low = k % 2 == 0 ? range.low : -1;
    range.high = k % 2 == 0 ? 1 : range.high;
  }
  return {range.low - 1e-14, range.high + 1e-14};
}

/// h = a + b cos 3φ, a cam of three lobes: ρ = a - 8 b cos 3φ, convex if 8 b < a, else with swallowtails. As
/// a ring its material is outside and the normal is reversed: h -> -h(φ + π).
class LobedCurve final : public SupportCurve {
public:
  LobedCurve(double a, double b, bool ring = false) : a_(a), b_(b), ring_(ring) {}

  [[nodiscard]] const std::vector<SupportPiece>& pieces() const override { return pieces_; }
  [[nodiscard]] SupportValue at(std::size_t, double phi) const override {
    // cos 3(φ + π) = -cos 3φ, so that the ring has -(a - b cos 3φ).
    const double s = ring_ ? -1 : 1;
    const double error = 1e-15 * (a_ + 5 * std::abs(b_) * (1 + std::abs(phi)));
    return {s * a_ + b_ * std::cos(3 * phi), -3 * b_ * std::sin(3 * phi), s * a_ - 8 * b_ * std::cos(3 * phi),
            24 * b_ * std::sin(3 * phi), error};
  }
  [[nodiscard]] Bounds radius(std::size_t, const Bounds& phi) const override {
    const Bounds c = cosine_over(3 * phi.low, 3 * phi.high);
    const double s = ring_ ? -1 : 1;
    const auto [low, high] = std::minmax({-8 * b_ * c.low, -8 * b_ * c.high});
    return {s * a_ + low - 1e-15 * a_, s * a_ + high + 1e-15 * a_};
  }

private:
  double a_;
  double b_;
  bool ring_;
  std::vector<SupportPiece> pieces_{{PieceKind::kClosed, {}, {}}};
};

/// An ellipse by its support function, without the library's closed forms: with g² = a² cos²ψ + b² sin²ψ, ψ =
/// φ - rotation, h = c·n ± g and ρ = ±a²b²/g³, + for the inside.
class EllipseBySupport final : public SupportCurve {
public:
  EllipseBySupport(const Vector2d& center, double a, double b, double rotation, bool outside = false)
      : center_(center), a_(a), b_(b), rotation_(rotation), s_(outside ? -1 : 1) {}

  [[nodiscard]] const std::vector<SupportPiece>& pieces() const override { return pieces_; }
  [[nodiscard]] SupportValue at(std::size_t, double phi) const override {
    const Vector2d n = unit_vector(phi);
    const Vector2d m = unit_vector(phi - rotation_);
    const double g = std::hypot(a_ * m.x(), b_ * m.y());
    const double dg = (b_ * b_ - a_ * a_) * m.x() * m.y() / g;
    const double rho = s_ * a_ * a_ * b_ * b_ / (g * g * g);
    const double error = 1e-15 * (center_.norm() + 4 * a_ + 4 * b_) * (1 + std::abs(phi));
    return {center_.dot(n) + s_ * g, center_.dot(perp(n)) + s_ * dg, rho, -3 * rho * dg / g, error};
  }
  [[nodiscard]] Bounds radius(std::size_t, const Bounds& phi) const override {
    // g² = (a² + b²)/2 + (a² - b²)/2 cos 2ψ
    const Bounds c = cosine_over(2 * (phi.low - rotation_), 2 * (phi.high - rotation_));
    const auto rho = [&](double cosine) {
      const double g = std::sqrt((a_ * a_ + b_ * b_ + (a_ * a_ - b_ * b_) * cosine) / 2);
      return s_ * a_ * a_ * b_ * b_ / (g * g * g);
    };
    const auto [low, high] = std::minmax({rho(c.low), rho(c.high)});
    return {low - 1e-13 * std::abs(low), high + 1e-13 * std::abs(high)};
  }

private:
  Vector2d center_;
  double a_, b_, rotation_, s_;
  std::vector<SupportPiece> pieces_{{PieceKind::kClosed, {}, {}}};
};

/// An oval gear's pitch curve of n lobes about the origin, r = p/(1 - e cos nθ), convex if e < 1/(n² - 1).
/// With u = 1/r the angle of the normal is φ = θ + atan(u′/u), and ρ = (u² + u′²)^{3/2}/(u³ (u + u″)).
class LobedOval final : public SupportCurve {
public:
  LobedOval(int n, double p, double e) : n_(n), p_(p), e_(e) {}

  [[nodiscard]] const std::vector<SupportPiece>& pieces() const override { return pieces_; }
  [[nodiscard]] SupportValue at(std::size_t, double phi) const override {
    double theta = phi;
    Inverse u = inverse(theta);
    for (int i = 0; i < 60; ++i) {
      const double step = (phi - theta - std::atan2(u.d1, u.u)) / (u.u * (u.u + u.d2)) * u.squared();
      theta += std::clamp(step, -0.2, 0.2);
      u = inverse(theta);
      if (std::abs(step) < 1e-15) break;
    }
    const double square = u.squared();
    const double bend = u.u + u.d2;
    const double rho = square * std::sqrt(square) / (u.u * u.u * u.u * bend);
    // dρ/dφ = ρ (d ln ρ/dθ)/(dφ/dθ).
    const double per_theta = 3 * u.d1 * bend / square - 3 * u.d1 / u.u - (u.d1 + u.d3) / bend;
    return {std::cos(theta - phi) / u.u, std::sin(theta - phi) / u.u, rho,
            rho * per_theta * square / (u.u * bend), 1e-14 * p_ * (1 + std::abs(phi))};
  }
  // From the radii at the tips of the lobes and at their waists, with a margin of 2.
  [[nodiscard]] Bounds radius(std::size_t, const Bounds&) const override {
    const double m = n_ * n_ - 1;
    return {0.5 * p_ / (1 + m * e_), 2 * p_ / (1 - m * e_)};
  }

private:
  struct Inverse {
    double u = 0, d1 = 0, d2 = 0, d3 = 0;
    [[nodiscard]] double squared() const { return u * u + d1 * d1; }
  };
  [[nodiscard]] Inverse inverse(double theta) const {
    const double c = e_ * std::cos(n_ * theta) / p_;
    const double s = e_ * std::sin(n_ * theta) / p_;
    return {1 / p_ - c, n_ * s, n_ * n_ * c, -n_ * n_ * n_ * s};
  }

  double n_, p_, e_;
  std::vector<SupportPiece> pieces_{{PieceKind::kClosed, {}, {}}};
};

/// An involute of the circle of radius r about the origin, h = r φ: its normals touch the circle (h′ = r).
class InvoluteBySupport final : public SupportCurve {
public:
  InvoluteBySupport(double r, const Bounds& phi) : r_(r), pieces_{{PieceKind::kArc, phi, {}}} {}

  [[nodiscard]] const std::vector<SupportPiece>& pieces() const override { return pieces_; }
  [[nodiscard]] SupportValue at(std::size_t, double phi) const override {
    return {r_ * phi, r_, r_ * phi, r_, 1e-15 * r_ * (1 + std::abs(phi))};
  }
  [[nodiscard]] Bounds radius(std::size_t, const Bounds& phi) const override {
    return {r_ * phi.low * (1 - 1e-15), r_ * phi.high * (1 + 1e-15)};
  }

private:
  double r_;
  std::vector<SupportPiece> pieces_;
};

/// Two half circles of radius r about (±half, 0) and the two flats between, counter-clockwise.
class Racetrack final : public SupportCurve {
public:
  Racetrack(double half, double r) : half_(half), r_(r) {
    const auto flat = [&](double phi) {
      return SupportPiece{PieceKind::kFace, {phi - 1e-15, phi + 1e-15}, {-half, half}};
    };
    pieces_ = {{PieceKind::kArc, {-kPi / 2, kPi / 2}, {}},
               flat(kPi / 2),
               {PieceKind::kArc, {kPi / 2, 3 * kPi / 2}, {}},
               flat(3 * kPi / 2)};
  }

  [[nodiscard]] const std::vector<SupportPiece>& pieces() const override { return pieces_; }
  [[nodiscard]] SupportValue at(std::size_t piece, double phi) const override {
    const double x = piece == 0 ? half_ : piece == 2 ? -half_ : 0;
    const double error = 4e-15 * (half_ + r_);
    if (pieces_[piece].kind == PieceKind::kFace) {
      // The middle of the flat, (0, ±r), as a corner.
      const double y = piece == 1 ? r_ : -r_;
      return {y * std::sin(phi), y * std::cos(phi), 0, 0, error};
    }
    return {x * std::cos(phi) + r_, -x * std::sin(phi), r_, 0, error};
  }
  [[nodiscard]] Bounds radius(std::size_t piece, const Bounds&) const override {
    const double rho = pieces_[piece].kind == PieceKind::kFace ? 0 : r_;
    return {rho, rho};
  }

private:
  double half_;
  double r_;
  std::vector<SupportPiece> pieces_;
};

}  // namespace higherpair::testing
