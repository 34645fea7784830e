#pragma once

#include <cmath>

namespace higherpair::bench {

/// A four-bar as it would be written by hand for one mechanism: crank r2 turning at unit speed about the
/// origin, coupler r3, rocker r4 about (r1, 0). Angles in, angles and rates out, without any checks. It is
/// the standard of comparison for one step of any contact pair.
struct FourBarByHand {
  double r1, r2, r3, r4;
  double sigma;  ///< ±1: side of the diagonal, from crank end to rocker pivot, on which the joint is

  struct Motion {
    double theta3, theta4, omega3, omega4, alpha3, alpha4;
  };

  [[nodiscard]] Motion at(double theta2) const {
    const double ax = r2 * std::cos(theta2);
    const double ay = r2 * std::sin(theta2);
    const double dx = r1 - ax;
    const double dy = -ay;
    const double d2 = dx * dx + dy * dy;
    const double along = (r3 * r3 - r4 * r4 + d2) / (2 * d2);
    const double across = sigma * std::sqrt(r3 * r3 / d2 - along * along);
    const double bx = along * dx - across * dy;  // coupler
    const double by = along * dy + across * dx;
    const double cx = bx - dx;  // rocker
    const double cy = by - dy;
    // Velocities: perp(a) + ω3 perp(b) = ω4 perp(c); accelerations: -a - ω3² b + α3 perp(b) = -ω4² c + α4
    // perp(c).
    const double det = bx * cy - by * cx;  // perp(b)·c
    const double omega3 = (ay * cx - ax * cy) / det;
    const double omega4 = (ay * bx - ax * by) / det;
    const double bc = bx * cx + by * cy;
    const double alpha3 =
        (ax * cx + ay * cy + omega3 * omega3 * bc - omega4 * omega4 * (cx * cx + cy * cy)) / det;
    const double alpha4 =
        (ax * bx + ay * by + omega3 * omega3 * (bx * bx + by * by) - omega4 * omega4 * bc) / det;
    return {std::atan2(by, bx), std::atan2(cy, cx), omega3, omega4, alpha3, alpha4};
  }
};

}  // namespace higherpair::bench
