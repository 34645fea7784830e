#include "higherpair/cam/hertz.hpp"

#include "higherpair/geometry/pose.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

constexpr ElasticMaterial kSteel = {206e9, 0.3};
constexpr ElasticMaterial kBronze = {110e9, 0.34};

// Timoshenko's form for two cylinders of one material with ν = 0.3: p0 = 0.418 √(P E (1/R1 + 1/R2)), where
// 0.418 is √(1/(2π 0.91)).
TEST(LinePressure, OfTwoSteelRollersIsThatOfHandbooks) {
  const double pressure = line_pressure(1000 / 0.010, 1 / 0.020 + 1 / 0.010, contact_modulus(kSteel, kSteel));
  EXPECT_NEAR(pressure * 1e-6, std::sqrt(100 * 206e3 * 0.15 / (2 * std::acos(-1.0) * 0.91)), 1e-9);
  EXPECT_NEAR(pressure * 1e-6, 735.1376, 5e-5);
  EXPECT_NEAR(pressure * 1e-6, 0.418 * std::sqrt(100 * 206e3 * 0.15), 1);
}

// The load is the integral of the semi-elliptical pressure: P = π b p0/2.
TEST(LinePressure, OverTheWidthOfTheStripIsTheLoad) {
  const double modulus = contact_modulus(kSteel, kBronze);
  const double greatest = line_pressure(73e3, 31.7, modulus);
  const double half_width = std::sqrt(4 * 73e3 / (31.7 * kPi * modulus));  // Johnson 4.43: b² = 4 P R/(π E*)
  constexpr int kParts = 200000;
  double load = 0;
  for (int i = 0; i < kParts; ++i) {
    const double x = (i + 0.5) / kParts;
    load += 2 * half_width / kParts * greatest * std::sqrt(1 - x * x);
  }
  EXPECT_NEAR(load / 73e3, 1, 1e-7);
}

TEST(LinePressure, OfABodyThatDoesNotGiveWayIsThatOfTheOtherAlone) {
  const double stiff = contact_modulus(kSteel, {1e30, 0});
  EXPECT_NEAR(stiff / (206e9 / 0.91), 1, 1e-15);
  EXPECT_EQ(contact_modulus(kSteel, kBronze), contact_modulus(kBronze, kSteel));
}

TEST(LinePressure, IsNoneWhereNothingPresses) {
  for (const double load : {0.0, -5.0}) {
    EXPECT_EQ(line_pressure(load, 30, 1e11), 0);
  }
}

}  // namespace
}  // namespace higherpair
