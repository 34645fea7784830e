#pragma once

#include "higherpair/geometry/support.hpp"

// One pass of the osculating iteration.
//
// For the normal n out of body 1, with t = n turned +90°, p1 and p2 the points of the curves with outward
// normals n and -n, κ their curvatures and K = κ1 + κ2:
//     w1 = κ1/K   w2 = κ2/K   w = κ1 κ2/K   z = 1/K      g = (p2 - p1)·n   s = (p2 - p1)·t   C = 2 g + w (g²
//     + s²)
// C = 0 says that the two osculating circles touch. Moving body 2 by δ changes C into a quadratic whose root
// of the wanted branch is taken; then n goes along the new line of centres.

namespace higherpair {

template <class T>
struct PairWeights {
  T w1, w2, w, z;
};

template <class T>
[[nodiscard]] inline PairWeights<T> weights_of_curved(const T& rho1, const T& rho2) {
  const T w = T(1) / (rho1 + rho2);
  return {rho2 * w, rho1 * w, w, rho1 * rho2 * w};
}

template <class T>
struct PassGeometry {
  Vector2<T> n, t, p1, p2;
  PairWeights<T> weights;
  T g, s;
};

/// The step of body 2 and the next normal (not normalised).
template <class T>
struct PassStep {
  T discriminant;    ///< < 0: the circles cannot touch
  Rotation<T> turn;  ///< turning follower: rotation by δ
  T tan_half;        ///< tan(δ/2)
  T slide;           ///< sliding follower: δ
  Vector2<T> n;
};

// The root -C/(B + β√D) or (-B + β√D)/A', whichever does not cancel; A' x² + 2 B x + C = 0.
template <class T>
[[nodiscard]] inline T branch_root(const T& A, const T& B, const T& C, const T& root, double beta) {
  const auto same_sign = T(beta) * B >= T(0);
  return select(same_sign, -C, beta * root - B) / select(same_sign, B + beta * root, A);
}

template <class T>
[[nodiscard]] inline PassStep<T> turning_pass(const PassGeometry<T>& at, const Vector2<T>& pivot_W,
                                              double beta) {
  using std::sqrt;
  const auto& [w1, w2, w, z] = at.weights;
  const Vector2<T> m = at.p2 - pivot_W;
  const Vector2<T> m1 = at.p1 - pivot_W;
  const T m_n = m.dot(at.n);
  const T m_t = m.dot(at.t);
  const T C = T(2) * at.g + w * (at.g * at.g + at.s * at.s);
  const T B = T(2) * (w * (at.s * m_n - at.g * m_t) + w1 * at.s - m_t);
  const T A = T(2) * (w * m.dot(m1) + w1 * m1.dot(at.n) - w2 * m_n - z);
  const T D = B * B - C * (C + T(2) * A);
  // Half of B, so that the quadratic in tan(δ/2) is A' x² + 2 (B/2) … written with B and 2x: x = tan(δ/2).
  const T x = branch_root(T(C + T(2) * A), B, C, T(sqrt(select(D > T(0), D, T(0)))), beta);
  const T scale = T(1) / (T(1) + x * x);
  const T sin = T(2) * x * scale;
  const T cos_minus_1 = -x * sin;
  const T a = w * m_n + w1;
  const T b = w * m_t;
  const Vector2<T> n =
      (T(1) + w * at.g + cos_minus_1 * a - sin * b) * at.n + (w * at.s + cos_minus_1 * b + sin * a) * at.t;
  return {D, {cos_minus_1 + T(1), sin}, x, T(0), n};
}

template <class T>
[[nodiscard]] inline PassStep<T> sliding_pass(const PassGeometry<T>& at, const Vector2<T>& direction_W,
                                              double beta) {
  using std::sqrt;
  const T w = at.weights.w;
  const T C = T(2) * at.g + w * (at.g * at.g + at.s * at.s);
  const T B = (T(1) + w * at.g) * at.n.dot(direction_W) + w * at.s * at.t.dot(direction_W);
  const T D = B * B - w * C;
  const T x = branch_root(T(w), B, C, T(sqrt(select(D > T(0), D, T(0)))), beta);
  const Vector2<T> n = (T(1) + w * at.g) * at.n + w * at.s * at.t + w * x * direction_W;
  return {D, {}, T(0), x, n};
}

}  // namespace higherpair
