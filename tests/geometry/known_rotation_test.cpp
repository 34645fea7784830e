#include "higherpair/geometry/known_rotation.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

// Against the cosine and sine of the difference in long double.
double error_of(const Rotation<double>& R, double angle) {
  const long double exact = angle;
  return static_cast<double>(std::max(std::abs(R.cos - std::cos(exact)), std::abs(R.sin - std::sin(exact))));
}

TEST(KnownRotation, GivesRotationsNearItToRounding) {
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
