#pragma once

#include "contact_points.hpp"

// One pass of the osculating iteration.
//
// For the normal n out of body 1, with t = n turned +90°, p1 and p2 the points of the curves with outward
// normals n and -n, w1, w2, w and z of the equivalent link, g = (p2 - p1)·n and s = (p2 - p1)·t:
//     C = 2 g + w (g² + s²)
// C = 0 means that the two osculating circles touch. If body 2 is moved by δ, C becomes a quadratic, of which
// the root on the wanted branch is taken; the next n is along the new line of centres.

namespace higherpair {

/// The step of body 2 and the next normal (not normalised).
struct PassStep {
  double discriminant;    ///< < 0: the circles cannot touch
  Rotation<double> turn;  ///< turning follower: rotation by δ
  double tan_half;        ///< tan(δ/2)
  double slide;           ///< sliding follower: δ
  Vector2d n_W;
};

// The root -C/(B + β√D) or (-B + β√D)/A' of A' x² + 2 B x + C = 0, whichever is free of cancellation.
[[nodiscard]] inline double branch_root(double A, double B, double C, double D, double beta) {
  const double root = std::sqrt(D > 0 ? D : 0);
  return beta * B >= 0 ? -C / (B + beta * root) : (beta * root - B) / A;
}

[[nodiscard]] inline PassStep turning_pass(const ContactPoints& at, const Vector2d& pivot_W, double beta) {
  const auto& [w1, w2, w, z] = at.link;
  const Vector2d m = at.p2_W - pivot_W;
  const Vector2d m1 = at.p1_W - pivot_W;
  const double m_n = m.dot(at.n_W);
  const double m_t = m.dot(at.t_W);
  const double C = 2 * at.g + w * (at.g * at.g + at.s * at.s);
  const double B = 2 * (w * (at.s * m_n - at.g * m_t) + w1 * at.s - m_t);
  const double A = 2 * (w * m.dot(m1) + w1 * m1.dot(at.n_W) - w2 * m_n - z);
  const double D = B * B - C * (C + 2 * A);
  // x = tan(δ/2) solves (C + 2 A) x² + 2 B x + C = 0.
  const double x = branch_root(C + 2 * A, B, C, D, beta);
  const double scale = 1 / (1 + x * x);
  const double sin = 2 * x * scale;
  const double cos_minus_1 = -x * sin;
  const double a = w * m_n + w1;
  const double b = w * m_t;
  const Vector2d n =
      (1 + w * at.g + cos_minus_1 * a - sin * b) * at.n_W + (w * at.s + cos_minus_1 * b + sin * a) * at.t_W;
  return {D, {cos_minus_1 + 1, sin}, x, 0, n};
}

[[nodiscard]] inline PassStep sliding_pass(const ContactPoints& at, const Vector2d& direction_W,
                                           double beta) {
  const double w = at.link.w;
  const double C = 2 * at.g + w * (at.g * at.g + at.s * at.s);
  const double B = (1 + w * at.g) * at.n_W.dot(direction_W) + w * at.s * at.t_W.dot(direction_W);
  const double D = B * B - w * C;
  const double x = branch_root(w, B, C, D, beta);
  const Vector2d n = (1 + w * at.g) * at.n_W + w * at.s * at.t_W + w * x * direction_W;
  return {D, {}, 0, x, n};
}

}  // namespace higherpair
