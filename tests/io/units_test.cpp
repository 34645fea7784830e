#include "higherpair/io/units.hpp"

#include "higherpair/geometry/pose.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

constexpr Unit kLast = Unit::kPoundForce;

std::vector<Unit> all_units() {
  std::vector<Unit> units;
  for (int i = 0; i <= static_cast<int>(kLast); ++i) units.push_back(static_cast<Unit>(i));
  return units;
}

Units with(Unit unit) {
  Units units;
  const Dimension dimension = dimension_of(unit);
  (dimension.length  ? units.length
   : dimension.angle ? units.angle
   : dimension.mass  ? units.mass
   : dimension.time  ? units.time
                     : units.force) = unit;
  return units;
}

double si(double value, Unit unit) {
  return to_si(dimension_of(unit), with(unit)).apply(value);
}

double spacing(double value) {
  return std::nextafter(std::abs(value), std::numeric_limits<double>::infinity()) - std::abs(value);
}

TEST(Units, EveryUnitHasItsLegalSize) {
  EXPECT_EQ(si(3, Unit::kMetre), 3);
  EXPECT_EQ(si(3, Unit::kCentimetre), 0.03);
  EXPECT_EQ(si(3, Unit::kMillimetre), 0.003);
  EXPECT_EQ(si(3, Unit::kMicrometre), 3e-6);
  EXPECT_EQ(si(3, Unit::kKilometre), 3000);
  EXPECT_EQ(si(3, Unit::kInch), 0.0762);
  EXPECT_EQ(si(3, Unit::kFoot), 0.9144);
  EXPECT_EQ(si(90, Unit::kDegree), kPi / 2);
  EXPECT_EQ(si(3, Unit::kRadian), 3);
  EXPECT_EQ(si(3, Unit::kRevolution), 6 * kPi);
  EXPECT_EQ(si(3, Unit::kKilogram), 3);
  EXPECT_EQ(si(3, Unit::kGram), 0.003);
  EXPECT_EQ(si(3, Unit::kPound), 1.36077711);
  EXPECT_EQ(si(3, Unit::kSecond), 3);
  EXPECT_EQ(si(3, Unit::kMillisecond), 0.003);
  EXPECT_EQ(si(3, Unit::kMinute), 180);
  EXPECT_EQ(si(3, Unit::kNewton), 3);
  EXPECT_EQ(si(3, Unit::kKilonewton), 3000);
  EXPECT_EQ(si(3, Unit::kPoundForce), 13.3446648457815);
}

TEST(Units, TheDefaultsAreMillimetresDegreesKilogramsSecondsAndNewtons) {
  EXPECT_EQ(unit_text(dimension::kLength, Units{}), "mm");
  EXPECT_EQ(unit_text(dimension::kAngle, Units{}), "deg");
  EXPECT_EQ(unit_text(dimension::kMass, Units{}), "kg");
  EXPECT_EQ(unit_text(dimension::kTime, Units{}), "s");
  EXPECT_EQ(unit_text(dimension::kForce, Units{}), "N");
}

TEST(Units, NamesLeadBackToTheirUnits) {
  for (const Unit unit : all_units()) {
    EXPECT_EQ(find_unit(name_of(unit)), unit);
  }
  EXPECT_EQ(find_unit("furlong"), std::nullopt);
  EXPECT_EQ(find_unit("MM"), std::nullopt);
  EXPECT_EQ(find_unit(""), std::nullopt);
}

// The compiler turns a decimal literal into the nearest double; dividing two exact integers gives the same
// rounding.
TEST(Units, MillimetresBecomeTheNearestDoubles) {
  const Scaling scaling = to_si(dimension::kLength, Units{});
  for (int i = -20'000; i <= 20'000; ++i) {
    ASSERT_EQ(scaling.apply(i), i / 1000.0) << i;
  }
}

TEST(Units, QuarterTurnsAreExact) {
  const Scaling scaling = to_si(dimension::kAngle, Units{});
  EXPECT_EQ(scaling.apply(45), kPi / 4);
  EXPECT_EQ(scaling.apply(90), kPi / 2);
  EXPECT_EQ(scaling.apply(180), kPi);
  EXPECT_EQ(scaling.apply(360), 2 * kPi);
  EXPECT_EQ(scaling.apply(-90), -kPi / 2);
  const Scaling back = from_si(dimension::kAngle, Units{});
  EXPECT_EQ(back.apply(kPi / 2), 90);
  EXPECT_EQ(back.apply(2 * kPi), 360);
}

// Degrees in radians, compared with an arithmetic of more digits.
TEST(Units, DegreesAreRoundedCorrectly) {
  if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "no longer type to compare with";
  constexpr long double kLongPi = 3.14159265358979323846264338327950288L;
  const Scaling scaling = to_si(dimension::kAngle, Units{});
  for (int i = 0; i <= 36'000; ++i) {
    const double angle = i / 100.0;
    const long double exact = angle * kLongPi / 180;
    const double converted = scaling.apply(angle);
    // Half a spacing of doubles, and the rounding of the comparison itself.
    ASSERT_LE(std::abs(static_cast<double>(converted - exact)), 0.501 * spacing(converted)) << angle;
  }
}

// Two neighbouring numbers in profile units may have to share one SI double where doubles are spaced more
// widely; everywhere else every value must be restored exactly.
TEST(Units, ThereAndBackIsTheIdentityWhereverTheDoublesLieDenseEnough) {
  std::mt19937_64 random(20240817);
  std::uniform_real_distribution<double> uniform(-1000, 1000);
  for (const Unit unit : all_units()) {
    const Scaling there = to_si(dimension_of(unit), with(unit));
    const Scaling back = from_si(dimension_of(unit), with(unit));
    const double factor = there.apply(1);
    int identical = 0;
    for (int i = 0; i < 5000; ++i) {
      const double value = i % 2 == 0 ? std::round(uniform(random) * 100) / 100 : uniform(random);
      const double converted = there.apply(value);
      const double returned = back.apply(converted);
      identical += returned == value ? 1 : 0;
      ASSERT_LE(std::abs(returned - value), spacing(value)) << name_of(unit);
      if (spacing(converted) < spacing(value) * factor) {
        ASSERT_EQ(returned, value) << name_of(unit);
      }
    }
    EXPECT_GT(identical, 3500) << name_of(unit);
  }
}

TEST(Units, ScalingPassesOnWhatIsNotFiniteAndOverflowsToInfinity) {
  Units kilometres;
  kilometres.length = Unit::kKilometre;
  const Scaling scaling = to_si(dimension::kLength, kilometres);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(scaling.apply(-kInfinity), -kInfinity);
  EXPECT_EQ(scaling.apply(1e306), kInfinity);
  EXPECT_TRUE(std::isnan(scaling.apply(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_EQ(scaling.apply(0), 0);
}

TEST(Units, SiUnitsConvertToThemselves) {
  for (const Dimension& dimension : {dimension::kTorque, dimension::kAngularDamping, dimension::kInertia}) {
    EXPECT_EQ(to_si(dimension, kSiUnits).apply(0.1), 0.1);
    EXPECT_EQ(from_si(dimension, kSiUnits).apply(0.1), 0.1);
  }
}

TEST(Units, CompoundQuantitiesAreProductsOfTheBaseUnits) {
  const Units units;
  EXPECT_EQ(to_si(dimension::kTorque, units).apply(40), 0.04);
  EXPECT_EQ(to_si(dimension::kInertia, units).apply(210), 2.1e-4);
  EXPECT_EQ(to_si(dimension::kStiffness, units).apply(1.5), 1500);
  EXPECT_EQ(to_si(dimension::kDamping, units).apply(0.3), 300);
  EXPECT_EQ(to_si(dimension::kAcceleration, units).apply(-9810), -9.81);
  EXPECT_EQ(to_si(dimension::kAngularVelocity, units).apply(360), 2 * kPi);
  EXPECT_DOUBLE_EQ(to_si(dimension::kAngularStiffness, units).apply(30), 30e-3 * 180 / kPi);
  const Units imperial = {Unit::kInch, Unit::kRevolution, Unit::kPound, Unit::kMinute, Unit::kPoundForce};
  EXPECT_EQ(to_si(dimension::kTorque, imperial).apply(1), 0.1129848290276167);  // NIST SP 811: lbf in
  EXPECT_EQ(to_si(dimension::kAngularVelocity, imperial).apply(60), 2 * kPi);
  EXPECT_EQ(to_si(dimension::kVelocity, imperial).apply(60), 0.0254);
}

TEST(Units, TextsAreAsciiProducts) {
  const Units units;
  EXPECT_EQ(unit_text(dimension::kNumber, units), "1");
  EXPECT_EQ(unit_text(dimension::kVelocity, units), "mm/s");
  EXPECT_EQ(unit_text(dimension::kAcceleration, units), "mm/s^2");
  EXPECT_EQ(unit_text(dimension::kAngularVelocity, units), "deg/s");
  EXPECT_EQ(unit_text(dimension::kAngularAcceleration, units), "deg/s^2");
  EXPECT_EQ(unit_text(dimension::kTorque, units), "N*mm");
  EXPECT_EQ(unit_text(dimension::kInertia, units), "kg*mm^2");
  EXPECT_EQ(unit_text(dimension::kStiffness, units), "N/mm");
  EXPECT_EQ(unit_text(dimension::kAngularStiffness, units), "N*mm/deg");
  EXPECT_EQ(unit_text(dimension::kDamping, units), "N*s/mm");
  EXPECT_EQ(unit_text(dimension::kAngularDamping, units), "N*mm*s/deg");
  EXPECT_EQ(unit_text(dimension::kNumber / dimension::kLength, units), "1/mm");
  EXPECT_EQ(unit_text(dimension::kTorque,
                      {Unit::kFoot, Unit::kRadian, Unit::kPound, Unit::kMinute, Unit::kPoundForce}),
            "lbf*ft");
}

TEST(Units, DimensionsAreDescribedInWords) {
  EXPECT_EQ(describe(dimension::kLength), "a length");
  EXPECT_EQ(describe(dimension::kAngularVelocity), "an angular velocity");
  EXPECT_EQ(describe({.length = 5}), "a quantity in mm^5");
}

}  // namespace
}  // namespace higherpair
