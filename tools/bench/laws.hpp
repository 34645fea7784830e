#pragma once

#include "higherpair/cam/motion_law.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace higherpair::bench {

/// Value and derivatives of a cycloidal rise over a quarter turn, a dwell, a return and a dwell, as they
/// would be written by hand: the standard of comparison for motion laws.
struct CamByHand {
  double rise;

  struct Motion {
    double s, v, a, j;
  };

  [[nodiscard]] Motion at(double x) const {
    const double quarter = kPi / 2;
    const double turn = x - 2 * kPi * std::floor(x / (2 * kPi));
    const bool back = turn >= 2 * quarter;
    const double local = back ? turn - 2 * quarter : turn;
    const double base = back ? rise : 0;
    const double h = back ? -rise : rise;
    if (local >= quarter) {
      return {base + h, 0, 0, 0};
    }
    const double u = local / quarter;
    const double sine = std::sin(2 * kPi * u);
    const double cosine = std::cos(2 * kPi * u);
    return {base + h * (u - sine / (2 * kPi)), h / quarter * (1 - cosine),
            h / (quarter * quarter) * 2 * kPi * sine,
            h / (quarter * quarter * quarter) * 4 * kPi * kPi * cosine};
  }
};

inline constexpr CamByHand kCam{0.02};

struct LawCase {
  std::string name;
  MotionLaw law;
};

/// Laws with the rise and quarters of kCam. Ends the program if the cycloidal one differs from that by hand,
/// or the spline through its points deviates too much from it.
[[nodiscard]] std::vector<LawCase> checked_laws();

}  // namespace higherpair::bench
