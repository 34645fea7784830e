#include "laws.hpp"

#include "cases.hpp"

#include <fmt/core.h>

namespace higherpair::bench {
namespace {

MotionLaw segments(LawType type) {
  const double quarter = kPi / 2;
  LawDescription description;
  description.segments = {{type, quarter, kCam.rise},
                          {LawType::kDwell, quarter},
                          {type, quarter, -kCam.rise},
                          {LawType::kDwell, quarter}};
  description.repeats = true;
  return MotionLaw::make(description).value();
}

MotionLaw spline(int points) {
  LawDescription description;
  for (int i = 0; i <= points; ++i) {
    const double x = 2 * kPi * i / points;
    description.points.emplace_back(x, i == points ? 0 : kCam.at(x).s);
  }
  description.ends = SplineEnds::kPeriodic;
  description.repeats = true;
  return MotionLaw::make(description).value();
}

// Compares over a turn, at points between the jumps of the jerk.
// \param allowed  relative to the largest values
void check(const LawCase& one, double allowed) {
  const double largest[] = {1, 2, 2 * kPi, 4 * kPi * kPi};
  for (int k = 0; k < kStepsPerTurn; ++k) {
    const double x = driver_position(k) + 0.3 * driver_position(1);
    const CamByHand::Motion hand = kCam.at(x);
    const double expected[] = {hand.s, hand.v, hand.a, hand.j};
    double scale = kCam.rise;
    for (int order = 0; order < 3; ++order) {
      const double error = std::abs(one.law.derivative(order, x) - expected[order]);
      require(error <= allowed * scale * largest[order],
              fmt::format("law {}: derivative {} at {} is off by {}", one.name, order, x, error));
      scale /= kPi / 2;
    }
  }
}

}  // namespace

std::vector<LawCase> checked_laws() {
  const LawCase cycloidal{"cycloidal", segments(LawType::kCycloidal)};
  const LawCase through_points{"spline_of_720", spline(720)};
  check(cycloidal, 1e-14);
  check(through_points, 1e-2);
  return {cycloidal,
          {"modified_sine", segments(LawType::kModifiedSine)},
          {"polynomial_4567", segments(LawType::kPolynomial4567)},
          through_points};
}

}  // namespace higherpair::bench
