#include "higherpair/contact/rolling.hpp"

#include "contact/freedoms.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::pivot;

// Equal ellipses a = 5, c = 3 about foci 10 apart: q = -2 atan(4 tan(u/2)), through both change points.
TEST(Rolling, TurnsEqualEllipsesAboutTheirFociThroughTheChangePoints) {
  const Curve ellipse = make_ellipse(Vector2d(3, 0), {5, 4}, 0).value();
  const ContactPair pair = {ellipse, pivot(0, 0), ellipse, pivot(10, 0)};
  RollingTrack track;
  const RollingResult start = start_rolling(track, pair, 0, 0, Vector2d::UnitX());
  ASSERT_TRUE(start.converged);
  EXPECT_LE(start.mismatch, 1e-14);
  for (int k = 0; k <= 720; ++k) {
    const double u = k * kPi / 180;
    const RollingResult result = roll_to(track, u);
    ASSERT_TRUE(result.converged) << k;
    EXPECT_LE(result.mismatch, 2e-13) << k;
    const double turns = std::round(u / (2 * kPi));
    const double rest = u - 2 * kPi * turns;
    const double q = -2 * std::atan2(4 * std::sin(rest / 2), std::cos(rest / 2)) - 2 * kPi * turns;
    EXPECT_LE(std::abs(track.at.q - q), 1e-12) << k;
    const double r1 = 3.2 / (1 - 0.6 * std::cos(u));
    EXPECT_LE(std::abs(track.at.dq + r1 / (10 - r1)), 1e-12) << k;
    EXPECT_LE(std::abs(track.at.sliding), 1e-11) << k;
  }
}

// The more slender the ellipses, the faster the follower turns on at the far end: up to 500 times as fast as
// the driver. With the normal one turn on and the follower two, the difference of the arcs is the same.
TEST(Rolling, TurnsSlenderEllipsesOnInAnyStepsOfTheDriver) {
  for (const double b : {1.9, 1.4, 1.0, 0.5, 0.2}) {
    const double c = std::sqrt(25 - b * b);
    const Curve ellipse = make_ellipse(Vector2d(c, 0), {5, b}, 0).value();
    const ContactPair pair = {ellipse, pivot(0, 0), ellipse, pivot(10, 0)};
    for (const int steps : {1, 2, 5, 7, 12, 60}) {
      RollingTrack track;
      ASSERT_TRUE(start_rolling(track, pair, 0, 0, Vector2d::UnitX()).converged);
      for (int k = 0; k <= steps; ++k) {
        const double u = 6.0 * k / steps - 3;
        const RollingResult result = roll_to(track, u);
        ASSERT_TRUE(result.converged) << b << " " << steps << " " << k;
        EXPECT_LE(result.mismatch, 1e-11) << b << " " << steps << " " << k;
        EXPECT_NEAR(track.at.q, -2 * std::atan((5 + c) / (5 - c) * std::tan(u / 2)), 1e-11)
            << b << " " << steps << " " << k;
      }
    }
  }
}

TEST(Rolling, TurnsDiscsAboutTheirCentresByTheRatioOfTheirRadii) {
  const ContactPair pair = {make_circle(Vector2d::Zero(), 0.031).value(), pivot(0, 0),
                            make_circle(Vector2d::Zero(), 0.0127).value(), pivot(0.031 + 0.0127, 0)};
  RollingTrack track;
  ASSERT_LE(start_rolling(track, pair, 0.2, 0.7, Vector2d::UnitX()).mismatch, 1e-16);
  EXPECT_EQ(track.at.q, 0.7);
  ASSERT_TRUE(roll_to(track, 5.2).converged);
  EXPECT_LE(std::abs(track.at.q - (0.7 - 5 * 0.031 / 0.0127)), 1e-13);
  EXPECT_LE(std::abs(track.at.d2q), 1e-12);
}

TEST(Rolling, MovesARackByTheArcOfItsPinion) {
  OneFreedom slide;
  slide.turns = false;
  slide.p_WO = Vector2d(0, 0.02);
  const ContactPair pair = {make_circle(Vector2d::Zero(), 0.02).value(), pivot(0, 0),
                            make_line(Vector2d::Zero(), Vector2d(0, -1)).value(), slide};
  RollingTrack track;
  ASSERT_LE(start_rolling(track, pair, 0, 0.003, Vector2d::UnitY()).mismatch, 1e-16);
  ASSERT_TRUE(roll_to(track, 3.3).converged);
  EXPECT_LE(std::abs(track.at.q - (0.003 - 3.3 * 0.02)), 1e-15);
}

TEST(Rolling, LeavesAMismatchForAPairThatCannotRoll) {
  const ContactPair pair = {make_circle(Vector2d(0.01, 0), 0.02).value(), pivot(0, 0),
                            make_circle(Vector2d(-0.06, 0), 0.015).value(), pivot(0.08, 0)};
  RollingTrack track;
  const RollingResult start = start_rolling(track, pair, 0.3, -0.6, Vector2d(0.5, 0.8).normalized());
  EXPECT_TRUE(!start.converged || start.mismatch > 1e-4);
}

}  // namespace
}  // namespace higherpair
