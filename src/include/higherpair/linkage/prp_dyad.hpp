#pragma once

#include "higherpair/linkage/moving_guide.hpp"
#include "higherpair/linkage/reach.hpp"

#include <optional>

namespace higherpair {

/// A pin C between two sliders, each on a moving guide: C is where the guides cross,
///     C = P1 + s1 u1 = P2 + s2 u2.
/// There is one assembly. With q = u1 × u2, the sine of the angle from guide 1 to guide 2,
///     s1 u1 - s2 u2 = W   has   s1 = W × u2/q,  s2 = W × u1/q,
/// for positions with W = P2 - P1, for rates with W the difference in velocity (acceleration) of the points
/// fixed in the two bodies that are momentarily at C, including the Coriolis term.
///
/// An RPP group (a body pinned at A, which slides on a body that slides on a known guide) is the same:
/// neither body turns relative to the guide, so guide 2 is the line through A given by `guide_through`.
struct PrpMotion {
  struct Rates {
    double s1_dot = 0;  ///< each relative to its guide [m/s]
    double s2_dot = 0;
    double s1_ddot = 0;  ///< [m/s²]
    double s2_ddot = 0;
    Vector2d v_WC = Vector2d::Zero();  ///< [m/s]
    Vector2d a_WC = Vector2d::Zero();  ///< [m/s²]
  };
  /// kNotAssemblable: the guides are parallel to within rounding, and apart. kSingular: they coincide; one of
  /// infinitely many positions is given, C = P2.
  LinkageStatus status = LinkageStatus::kNotAssemblable;
  double sine = 0;       ///< q; valid, like its rate, with every status. C goes to infinity where q = 0
  double sine_rate = 0;  ///< (ω2 - ω1) u1·u2 [1/s]
  double s1 = 0;         ///< [m]
  double s2 = 0;
  Vector2d p_WC = Vector2d::Zero();  ///< [m]
  std::optional<Rates> rates;        ///< with kOk only
};

/// The position of the pin and, where the guides cross, its rates, from the motion of both guides in ground
/// W.
[[nodiscard]] PrpMotion prp_dyad(const GuideMotion& guide1, const GuideMotion& guide2);

/// For an RPP group: the line through A that turns with `guide`, along u_G relative to it. With it as guide
/// 2, s1 is the slide of the middle body on the guide, and -s2 that of A's body on the middle one, from C
/// along u_G: A = P + s1 u + (-s2) u u_G.
[[nodiscard]] inline GuideMotion guide_through(const PointMotion& A, const GuideMotion& guide,
                                               const Rotation<double>& u_G) {
  return {A, guide.u * u_G, guide.omega, guide.alpha};
}

template <class T>
struct GuideSplit {
  T s1{0};
  T s2{0};
};

/// The kernel: W = s1 u1 - s2 u2. Finite but meaningless where q = 0.
template <class T>
[[nodiscard]] GuideSplit<T> split_along(const Rotation<T>& u1, const Rotation<T>& u2, const Vector2<T>& W) {
  const T inv = safe_inverse(u1.cos * u2.sin - u1.sin * u2.cos);
  return {(W.x() * u2.sin - W.y() * u2.cos) * inv, (W.x() * u1.sin - W.y() * u1.cos) * inv};
}

}  // namespace higherpair
