#pragma once

#include "higherpair/geometry/pose.hpp"
#include "higherpair/linkage/reach.hpp"

#include <optional>

namespace higherpair {

/// A body pinned at A with a straight guide, and a pin B that runs in the guide (or a block pinned at B):
///     s u + e u⊥ = D,   D = B - A,   d = |D|,   u⊥ = u turned +90°.
/// s is the coordinate of B along the guide from the foot of A on it; the offset e of the guide from A has a
/// sign, positive where the guide lies left of u. Mode σ = +1: s > 0. Its reach is s² = d² - e² [m²], as both
/// stretch and fold.
template <class T>
struct RprPosition {
  Rotation<T> u;
  T s{0};
  Reach<T> reach;  ///< stretch and fold are both s², negative where B is closer to A than the guide
};

template <class T>
struct RprRates {
  T omega{0};
  T alpha{0};
  T s_dot{0};
  T s_ddot{0};
};

/// u = D turned back by the angle of (s, e); D = 0: u along +x. `reach` is supplied by the caller, who may
/// know it more accurately than it follows from |D|.
template <class T>
[[nodiscard]] RprPosition<T> rpr_position(const Vector2<T>& D, T e, const Reach<T>& reach, T sigma) {
  using std::max;
  using std::sqrt;
  const T s = sigma * sqrt(max(reach.fold, T(0)));
  const T d2 = D.x() * D.x() + D.y() * D.y();
  const T inv_d = safe_inverse(sqrt(d2));
  const T body2 = s * s + e * e;
  const T inv_body = safe_inverse(sqrt(body2));
  const Rotation<T> pin{select(d2 > T(0), D.x() * inv_d, T(1)), D.y() * inv_d};
  const Rotation<T> body{select(body2 > T(0), s * inv_body, T(1)), e * inv_body};
  return {(pin * body.inverse()).normalised(), s, reach};
}

/// s ω = Ḋ·u⊥,  ṡ = Ḋ·u + e ω,  s α = D̈·u⊥ - 2 ṡ ω + e ω²,  s̈ = D̈·u + s ω² + e α.
/// Finite but meaningless where s = 0.
template <class T>
[[nodiscard]] RprRates<T> rpr_rates(const RprPosition<T>& position, T e, const Vector2<T>& D_dot,
                                    const Vector2<T>& D_ddot) {
  const Vector2<T> v = position.u.inverse() * D_dot;
  const Vector2<T> a = position.u.inverse() * D_ddot;
  const T inv = safe_inverse(position.s);
  RprRates<T> rates;
  rates.omega = v.y() * inv;
  rates.s_dot = v.x() + e * rates.omega;
  const T square = rates.omega * rates.omega;
  rates.alpha = (a.y() - T(2) * rates.s_dot * rates.omega + e * square) * inv;
  rates.s_ddot = a.x() + position.s * square + e * rates.alpha;
  return rates;
}

/// d² - e² as a product.
/// \param extent  largest coordinate that D was computed from [m]: its rounding limits the precision of the
/// points
template <class T>
[[nodiscard]] Reach<T> rpr_reach(const Vector2<T>& D, T e, T extent) {
  using std::abs;
  using std::sqrt;
  const T d = sqrt(D.x() * D.x() + D.y() * D.y());
  const T square = (d - e) * (d + e);
  const T eps(kEpsilonOf<T>);
  return {square, square, T(kReachRoundings) * eps * (d * (d + extent) + eps * (e * e + extent * extent))};
}

/// A link with a guide between two moving pins.
struct RprMotion {
  struct Rates {
    double omega = 0;  ///< of the guide [rad/s]
    double alpha = 0;  ///< [rad/s²]
    double s_dot = 0;  ///< relative to the guide [m/s]
    double s_ddot = 0;
  };
  LinkageStatus status = LinkageStatus::kNotAssemblable;
  Reach<double> reach;         ///< [m²]; valid with every status
  Rotation<double> u;          ///< unit direction of the guide
  double s = 0;                ///< [m]
  std::optional<Rates> rates;  ///< with kOk only
};

/// \param e     offset of the guide from A, with sign [m]
/// \param mode  kPlus: s > 0.
/// kSingular: s = 0 to within rounding. With e = 0 this is where B meets A: a change point, and one of
/// infinitely many positions is given.
[[nodiscard]] RprMotion rpr_dyad(const PointMotion& A, const PointMotion& B, double e, AssemblyMode mode);

}  // namespace higherpair
