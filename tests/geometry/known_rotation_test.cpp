#include "higherpair/geometry/known_rotation.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

// Compared with the cosine and sine in long double.
double error_of(const Rotation<double>& R, double angle) {
  const long double exact = angle;
  return static_cast<double>(std::max(std::abs(R.cos - std::cos(exact)), std::abs(R.sin - std::sin(exact))));
}

TEST(KnownRotation, GivesRotationsNearItToWithinRounding) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> anywhere(-20, 20);
  std::uniform_real_distribution<double> near(-0.0316, 0.0316);
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const double known = anywhere(random);
    const double angle = known + near(random);
    const KnownRotation rotation(known);
    ASSERT_TRUE(rotation.is_near(angle));
    worst = std::max(worst, error_of(rotation.at(angle), angle));
  }
  EXPECT_LE(worst, 2e-16);
}

TEST(KnownRotation, GivesAnglesNearItToWithinRounding) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> near(-0.0316, 0.0316);
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const double angle = near(random);
    const KnownRotation rotation(0);
    worst = std::max(worst, std::abs(rotation.angle_of(Rotation<double>::from_angle(angle), 0) - angle));
  }
  EXPECT_LE(worst, 2e-17);
}

TEST(KnownRotation, FollowsATurningBodyThroughManyTurnsWithoutDrift) {
  KnownRotation known;
  const double step = 0.0123;
  for (int k = 1; k <= 200000; ++k) {
    const double angle = k * step;
    known = known.renewed_at(angle);
    const Rotation<double> R = known.at(angle);
    ASSERT_TRUE(known.is_near(angle));
    ASSERT_LE(error_of(R, angle), 2e-16) << k;
    ASSERT_NEAR(known.angle_of(R, angle - step), angle, 3e-16 * (1 + angle)) << k;
  }
  // A jump is followed as well, to the turn that is asked for.
  EXPECT_NEAR(known.angle_of(Rotation<double>::from_angle(1), 7), 1 + 2 * kPi, 1e-15);
}

TEST(KnownRotation, GivesRotationsFarFromItAsWell) {
  const KnownRotation rotation(0.3);
  for (const double angle : {0.34, -5.0, 3e6}) {
    EXPECT_FALSE(rotation.is_near(angle));
    EXPECT_LE(error_of(rotation.at(angle), angle), 1.2e-16);
  }
  EXPECT_EQ(KnownRotation().at(0).cos, 1);
}

}  // namespace
}  // namespace higherpair
