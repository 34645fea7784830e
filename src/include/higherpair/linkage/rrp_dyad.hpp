#pragma once

#include "higherpair/linkage/moving_guide.hpp"
#include "higherpair/linkage/reach.hpp"

#include <optional>

namespace higherpair {

/// A leg from a point A = (x, y) to a straight line, in the line's frame (x along it):
///     A + leg u_leg = (along, 0).
/// The leg has to span -y across the line: sin = -y/leg, cos = σ√(leg² - y²)/leg.
/// Mode σ = +1: the leg's foot is ahead (+x) of A. Its reach: stretch = leg + y, fold = leg - y [m].
template <class T>
struct RrpPosition {
  Rotation<T> u_leg;
  T along{0};  ///< position on the line where the leg ends [m]
  Reach<T> reach;
};

template <class T>
struct RrpRates {
  T omega_leg{0};
  T alpha_leg{0};
  T along_dot{0};
  T along_ddot{0};
};

/// \param x      of A [m]; y is contained in `reach`, supplied by the caller, who may know it more
/// accurately.
/// \pre leg > 0.
template <class T>
[[nodiscard]] RrpPosition<T> rrp_position(T x, T leg, const Reach<T>& reach, T sigma) {
  const T inv_leg = T(1) / leg;
  const Rotation<T> u_leg =
      Rotation<T>{sigma * root_of(reach) * inv_leg, T(0.5) * (reach.fold - reach.stretch) * inv_leg}
          .normalised();
  return {u_leg, x + leg * u_leg.cos, reach};
}

/// With λ the leg's angle, from the derivatives of y + leg sin λ = 0 and x + leg cos λ = along:
///     leg ω cos λ = -ẏ,   leg α cos λ = -ÿ + leg ω² sin λ.
/// Finite but meaningless where cos λ = 0.
template <class T>
[[nodiscard]] RrpRates<T> rrp_rates(const RrpPosition<T>& position, T leg, const Vector2<T>& A_dot,
                                    const Vector2<T>& A_ddot) {
  const Rotation<T>& u_leg = position.u_leg;
  const T inv = safe_inverse(leg * u_leg.cos);
  RrpRates<T> rates;
  rates.omega_leg = -A_dot.y() * inv;
  const T pull = leg * rates.omega_leg * rates.omega_leg;
  rates.alpha_leg = (pull * u_leg.sin - A_ddot.y()) * inv;
  rates.along_dot = A_dot.x() - leg * rates.omega_leg * u_leg.sin;
  rates.along_ddot = A_ddot.x() - leg * rates.alpha_leg * u_leg.sin - pull * u_leg.cos;
  return rates;
}

/// \name A and the line both move
/// @{

/// A link from a moving point A to a point C that runs on a moving guide, C = P + s u.
struct RrpMotion {
  struct Rates {
    double omega = 0;  ///< of the link [rad/s]
    double alpha = 0;  ///< [rad/s²]
    double s_dot = 0;  ///< relative to the guide [m/s]
    double s_ddot = 0;
    Vector2d v_WC = Vector2d::Zero();  ///< [m/s]
    Vector2d a_WC = Vector2d::Zero();  ///< [m/s²]
  };
  LinkageStatus status = LinkageStatus::kNotAssemblable;
  Reach<double> reach;               ///< [m]; valid with every status
  Rotation<double> u_link;           ///< unit direction from A to C
  double s = 0;                      ///< coordinate of C on the guide [m]
  Vector2d p_WC = Vector2d::Zero();  ///< [m]
  std::optional<Rates> rates;        ///< with kOk only
};

/// \param r     length of the link [m]
/// \param mode  kPlus: C is ahead of A, (C - A)·u > 0.
/// kSingular: the link is perpendicular to the guide to within rounding.
/// \pre r > 0: without length the link has no direction, and A itself must run on the guide.
[[nodiscard]] RrpMotion rrp_dyad(const PointMotion& A, const GuideMotion& guide, double r, AssemblyMode mode);
/// @}

}  // namespace higherpair
