#include "higherpair/geometry/pose.hpp"
#include "higherpair/io/units.hpp"
#include "support/texts.hpp"

#include <array>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;

double si(std::string_view text, const Dimension& dimension) {
  const auto quantity = parse_quantity(text, dimension, Units{});
  EXPECT_TRUE(quantity) << text << ": " << (quantity ? "" : quantity.error());
  return quantity ? quantity->si : -1;
}

double profile(std::string_view text, const Dimension& dimension, const Units& units = {}) {
  const auto quantity = parse_quantity(text, dimension, units);
  EXPECT_TRUE(quantity) << text << ": " << (quantity ? "" : quantity.error());
  return quantity ? quantity->profile : -1;
}

std::string error(std::string_view text, const Dimension& dimension) {
  const auto quantity = parse_quantity(text, dimension, Units{});
  EXPECT_FALSE(quantity) << text;
  return quantity ? "" : quantity.error();
}

TEST(Quantity, OfEveryDimensionIsReadInItsOwnUnit) {
  EXPECT_EQ(si("25.4 mm", dimension::kLength), 0.0254);
  EXPECT_EQ(si("1 in", dimension::kLength), 0.0254);
  EXPECT_EQ(si("300 rpm", dimension::kAngularVelocity), 10 * kPi);
  EXPECT_EQ(si("9.81 m/s^2", dimension::kAcceleration), 9.81);
  EXPECT_EQ(si("0.2 N m", dimension::kTorque), 0.2);
  EXPECT_EQ(si("3 N/mm", dimension::kStiffness), 3000);
  EXPECT_EQ(si("2 in/s", dimension::kVelocity), 0.0508);
  EXPECT_EQ(si("2.1e-4 kg m^2", dimension::kInertia), 2.1e-4);
  EXPECT_EQ(si("5 N m/rad", dimension::kAngularStiffness), 5);
  EXPECT_EQ(si("5 N s/m", dimension::kDamping), 5);
  EXPECT_EQ(si("5 N m s/rad", dimension::kAngularDamping), 5);
  EXPECT_EQ(si("0.25 rev", dimension::kAngle), kPi / 2);
  EXPECT_EQ(si("2 rev/s^2", dimension::kAngularAcceleration), 4 * kPi);
  EXPECT_EQ(si("12 lbf", dimension::kForce), 53.378659383126);
  EXPECT_EQ(si("0.5 lb", dimension::kMass), 0.226796185);
  EXPECT_EQ(si("90 ms", dimension::kTime), 0.09);
}

TEST(Quantity, InEveryUnitOfTheFormatIsTheSameLength) {
  for (const char* text :
       {"3.048 m", "304.8 cm", "3048 mm", "3048000 um", "0.003048 km", "120 in", "10 ft"}) {
    EXPECT_EQ(si(text, dimension::kLength), 3.048) << text;
    EXPECT_EQ(profile(text, dimension::kLength), 3048) << text;
  }
}

TEST(Quantity, MayBeSpelledInSeveralWays) {
  for (const char* text : {"0.2 N m", "0.2 N*m", "0.2N m", " 0.2  N * m ", "+0.2 N m", "2e-1 m N", "200 N mm",
                           "0.2 N m^2/m", "0.2 kg m^2/s^2", "0.2 kg m^2 s^-2", "0.2 N / m^-1"}) {
    EXPECT_EQ(si(text, dimension::kTorque), 0.2) << text;
  }
  EXPECT_EQ(si("4 1/s", dimension::kNumber / dimension::kTime), 4);
  EXPECT_EQ(si("4 /s", dimension::kNumber / dimension::kTime), 4);
  EXPECT_EQ(si("4", dimension::kNumber), 4);
}

TEST(Quantity, MayHaveTheBlanksOfDocuments) {
  for (const std::string blank : {"\u00a0", "\u202f", "\u2009", "\u2007"}) {
    EXPECT_EQ(si("30" + blank + "mm", dimension::kLength), 0.030);
    EXPECT_EQ(si(blank + "2 N" + blank + "m" + blank, dimension::kTorque), 2);
    EXPECT_TRUE(contains(error("1" + blank + "000 mm", dimension::kLength), "write 1000: no separator"));
  }
}

TEST(Quantity, FactorsAfterTheSlashAllDivide) {
  EXPECT_DOUBLE_EQ(si("3 m/s s", dimension::kAcceleration), 3);
}

TEST(Quantity, InTheUnitOfTheProfileKeepsItsDigits) {
  EXPECT_EQ(profile("0.1 mm", dimension::kLength), 0.1);
  EXPECT_EQ(profile("77.7 deg", dimension::kAngle), 77.7);
  EXPECT_EQ(profile("77.7 deg/s", dimension::kAngularVelocity), 77.7);
  EXPECT_EQ(profile("300 rpm", dimension::kAngularVelocity), 1800);
  EXPECT_EQ(profile("0.7 N*mm*s/deg", dimension::kAngularDamping), 0.7);
  Units minutes;
  minutes.time = Unit::kMinute;
  minutes.angle = Unit::kRevolution;
  EXPECT_EQ(profile("299.9 rpm", dimension::kAngularVelocity, minutes), 299.9);
}

TEST(Quantity, ReadsBackTheUnitTextsOfTables) {
  const std::array<Units, 2> systems = {
      Units{}, Units{Unit::kInch, Unit::kRevolution, Unit::kPound, Unit::kMinute, Unit::kPoundForce}};
  for (const Units& units : systems) {
    for (const Dimension& dimension :
         {dimension::kLength, dimension::kAngle, dimension::kTorque, dimension::kInertia,
          dimension::kStiffness, dimension::kAngularStiffness, dimension::kDamping,
          dimension::kAngularDamping, dimension::kVelocity, dimension::kAngularAcceleration,
          dimension::kForce, dimension::kMass, dimension::kTime}) {
      const auto quantity = parse_quantity("0.3 " + unit_text(dimension, units), dimension, units);
      ASSERT_TRUE(quantity) << unit_text(dimension, units);
      EXPECT_EQ(quantity->profile, 0.3);
      EXPECT_EQ(quantity->si, to_si(dimension, units).apply(0.3)) << unit_text(dimension, units);
    }
  }
}

TEST(Quantity, OfAnotherDimensionIsRefusedWithBothNames) {
  EXPECT_EQ(error("3 kg", dimension::kLength), "kg is a mass, expected a length, such as mm");
  EXPECT_EQ(error("3 N m", dimension::kAngularStiffness),
            "N m is a torque, expected an angular stiffness, such as N*mm/deg");
  EXPECT_EQ(error("3 kg", dimension::kForce), "kg is a mass, expected a force, such as N");
  EXPECT_EQ(error("3 rad", dimension::kNumber), "rad is an angle, expected a pure number, such as 1");
}

TEST(Quantity, WithoutAUnitIsRefused) {
  EXPECT_EQ(error("3", dimension::kAngle),
            "has no unit; expected an angle, such as \"25.4 deg\", or the number without quotes for deg");
}

TEST(Quantity, UnknownUnitsAreAnsweredWithUnitsOfTheQuantity) {
  const std::string lengths = " is no unit (there are m, cm, mm, um, km, in, ft); expected a length, such as";
  for (const std::string unit : {"nm", "dm", "h", "mn", "J"}) {
    EXPECT_TRUE(contains(error("3 " + unit, dimension::kLength), unit + lengths));
  }
  EXPECT_TRUE(contains(error("3 MM", dimension::kLength), "MM is no unit (did you mean `mm`?)"));
  EXPECT_TRUE(contains(error("3 μm", dimension::kLength), "μm is no unit: write um"));
  EXPECT_TRUE(contains(error("3 degs", dimension::kAngle), "degs is no unit (did you mean `deg`?)"));
  EXPECT_TRUE(contains(error("3 degs", dimension::kAngularVelocity), "(did you mean `deg/s`?)"));
  EXPECT_TRUE(contains(error("3 r/min", dimension::kAngularVelocity), "r is no unit: write rev, or rpm"));
  EXPECT_TRUE(contains(error("3 nm", dimension::kTorque), "nm is no unit (did you mean `N m`?)"));
  EXPECT_TRUE(contains(error("3 kgm2", dimension::kInertia), "kgm is no unit (did you mean `kg m^2`?)"));
  EXPECT_TRUE(contains(error("3 Nm/degrees", dimension::kAngularStiffness), "(did you mean `N m/deg`?)"));
  EXPECT_TRUE(contains(error("3 km/h", dimension::kVelocity), "h is no unit; expected a velocity"));
  EXPECT_TRUE(contains(error("3 Hz", dimension::kLength), "Hz is no unit (there are m, cm, "));
}

TEST(Quantity, MistakesOfSpellingAreNamed) {
  EXPECT_TRUE(contains(error("3 lbs", dimension::kMass), "lbs is no unit: write lb"));
  EXPECT_TRUE(contains(error("300 U/min", dimension::kAngularVelocity), "U is no unit: write rev, or rpm"));
  EXPECT_TRUE(
      contains(error("3 rads", dimension::kAngularVelocity), "rads is no unit (did you mean `rad/s`?)"));
  EXPECT_TRUE(contains(error("3 Nm", dimension::kTorque), "Nm is no unit (did you mean `N m`?)"));
  EXPECT_TRUE(contains(error("3 m/s2", dimension::kAcceleration),
                       "has `2` where a unit is expected: a power is written with ^, as in mm^2"));
  EXPECT_TRUE(
      contains(error("3 N/mm^2", dimension::kStiffness), "N/mm^2 is a pressure, expected a stiffness"));
  EXPECT_TRUE(contains(error("3 N.m", dimension::kTorque), "has `.` between two units: write * or a space"));
  EXPECT_TRUE(contains(error("3 m/s/s", dimension::kAcceleration), "more than one `/`"));
  EXPECT_TRUE(contains(error("3 m^", dimension::kLength), "no integer from -9 to 9"));
  EXPECT_TRUE(contains(error("3 m^99999999999", dimension::kLength), "no integer from -9 to 9"));
  EXPECT_TRUE(contains(error("3 m^10", dimension::kLength), "no integer from -9 to 9"));
  EXPECT_TRUE(contains(error("3 *m", dimension::kLength), "`*` without a unit before it"));
  EXPECT_TRUE(contains(error("3 m/", dimension::kLength), "ends where a unit is expected"));
  EXPECT_TRUE(contains(error("3 m*/s", dimension::kVelocity), "has `/s` where a unit is expected"));
  EXPECT_TRUE(contains(error("3 °", dimension::kAngle), "has the sign °: write deg"));
  EXPECT_TRUE(contains(error("mm", dimension::kLength), "does not begin with a number"));
  EXPECT_TRUE(contains(error("", dimension::kLength), "does not begin with a number"));
  EXPECT_TRUE(
      contains(error("1,000 mm", dimension::kLength),
               "a decimal number is written with a point: 1.000; if thousands are meant, write 1000;"));
  EXPECT_TRUE(contains(error("1.000,5 mm", dimension::kLength),
                       "write 1000.5: no separator of thousands, and a point for decimals;"));
  EXPECT_TRUE(contains(error("1'000", dimension::kLength), "write 1000: no separator of thousands;"));
  EXPECT_TRUE(contains(error("1/4 in", dimension::kLength),
                       "nothing is worked out here: write 0.25 in; expected a length"));
  EXPECT_TRUE(contains(error("-1 1/4 in", dimension::kLength), "write -1.25 in"));
  EXPECT_TRUE(contains(error("1_000 mm", dimension::kLength), "where a unit is expected"));
}

TEST(Quantity, MustBeFiniteInEveryUnit) {
  EXPECT_TRUE(contains(error("nan mm", dimension::kLength), "must be a finite number"));
  EXPECT_TRUE(contains(error("-inf mm", dimension::kLength), "must be a finite number"));
  EXPECT_TRUE(contains(error("1e999 mm", dimension::kLength), "out of the range of a double"));
  EXPECT_TRUE(contains(error("1e308 km", dimension::kLength), "out of the range of a double"));
}

}  // namespace
}  // namespace higherpair
