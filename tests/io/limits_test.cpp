#include "higherpair/io/tasks.hpp"
#include "io/profile_testing.hpp"
#include "support/texts.hpp"

#include <string>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using ::testing::AllOf;
using testing::contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kCamProfile;
using testing::lines_are;
using testing::messages;
using testing::part;
using testing::read;

std::vector<std::string> messages_with(const std::string& limits) {
  return messages(kCamProfile + limits);
}

double value_of(const LimitSet& set, LimitKey key) {
  return set[static_cast<std::size_t>(key)].value().value;
}

TEST(Limits, AreReadInTheProfilesUnitsOrTheirOwn) {
  const Profile profile = read(std::string(kCamProfile) + R"(
[limits]
max_pressure_angle = 30
max_return_pressure_angle = "0.7 rad"
min_convex_radius = 4
max_contact_pressure = "800 MPa"
max_angular_acceleration = 900
min_speed_factor = 1.25
elastic_modulus = "206 GPa"
poisson_ratio = 0.3
width = "1.2 cm"
)");
  ASSERT_TRUE(profile.limits);
  const LimitSet& all = profile.limits->all;
  EXPECT_DOUBLE_EQ(value_of(all, LimitKey::kMaxPressureAngle), kPi / 6);
  EXPECT_DOUBLE_EQ(value_of(all, LimitKey::kMaxReturnPressureAngle), 0.7);
  EXPECT_DOUBLE_EQ(value_of(all, LimitKey::kMinConvexRadius), 0.004);
  EXPECT_DOUBLE_EQ(value_of(all, LimitKey::kMaxContactPressure), 800e6);
  EXPECT_DOUBLE_EQ(value_of(all, LimitKey::kMaxAngularAcceleration), 900 * kPi / 180);
  EXPECT_DOUBLE_EQ(value_of(all, LimitKey::kMinSpeedFactor), 1.25);
  EXPECT_DOUBLE_EQ(value_of(all, LimitKey::kElasticModulus), 206e9);
  EXPECT_DOUBLE_EQ(value_of(all, LimitKey::kWidth), 0.012);
  EXPECT_FALSE(all[static_cast<std::size_t>(LimitKey::kMaxJerk)]);
  EXPECT_EQ(all[static_cast<std::size_t>(LimitKey::kMaxPressureAngle)]->path, "limits.max_pressure_angle");
  EXPECT_EQ(all[static_cast<std::size_t>(LimitKey::kMaxPressureAngle)]->place.source, "test.toml");
  EXPECT_GT(all[static_cast<std::size_t>(LimitKey::kMaxPressureAngle)]->place.line, 60);
}

TEST(Limits, OfOneThingTakeThePlaceOfThoseOfAll) {
  const Profile profile = read(std::string(kCamProfile) + R"(
[limits]
max_pressure_angle = 30
[limits.contacts.touch]
max_pressure_angle = 40
width = 9
[limits.joints.follower_pivot]
max_angular_jerk = 5
[limits.bodies.cam]
elastic_modulus = "110 GPa"
)");
  ASSERT_TRUE(profile.limits);
  const CheckLimits& limits = *profile.limits;
  EXPECT_DOUBLE_EQ(limit_of(limits, limits.contacts, 0, LimitKey::kMaxPressureAngle)->value, kPi * 40 / 180);
  EXPECT_DOUBLE_EQ(limit_of(limits, {}, 0, LimitKey::kMaxPressureAngle)->value, kPi / 6);
  EXPECT_DOUBLE_EQ(limit_of(limits, limits.contacts, 0, LimitKey::kWidth)->value, 0.009);
  EXPECT_DOUBLE_EQ(limit_of(limits, limits.joints, 1, LimitKey::kMaxAngularJerk)->value, 5 * kPi / 180);
  EXPECT_EQ(limit_of(limits, limits.joints, 0, LimitKey::kMaxAngularJerk), nullptr);
  EXPECT_DOUBLE_EQ(limit_of(limits, limits.bodies, 1, LimitKey::kElasticModulus)->value, 110e9);
}

TEST(Limits, AreNoneWhereTheProfileHasNone) {
  EXPECT_FALSE(read(kCamProfile).limits);
}

TEST(Limits, ThatAreUnknownGetASuggestion) {
  EXPECT_THAT(messages_with("[limits]\nmax_presure_angle = 30\n"),
              ElementsAre(AllOf(HasSubstr("limits.max_presure_angle"),
                                HasSubstr("did you mean `max_pressure_angle`"))));
  EXPECT_THAT(messages_with("[limits]\npressure_angle = 30\n"),
              ElementsAre(AllOf(HasSubstr("limits.pressure_angle"), HasSubstr("max_pressure_angle"))));
  EXPECT_THAT(messages_with("[limits.contacts.toch]\nmax_pressure_angle = 30\n"),
              ElementsAre(AllOf(HasSubstr("there is no contact `toch`"), HasSubstr("did you mean `touch`"))));
  EXPECT_TRUE(lines_are(messages_with("[limits.joints.pivot]\nmax_angular_jerk = 30\n"),
                        {part("there is no joint `pivot`")}));
  EXPECT_TRUE(lines_are(messages_with("[limits.bodies.can]\npoisson_ratio = 0.3\n"),
                        {part("there is no body `can`")}));
  // A joint that turns has no limits of lengths, and a body none of angles.
  EXPECT_TRUE(lines_are(messages_with("[limits.joints.cam_pivot]\nmax_jerk = 30\n"),
                        {part("limits.joints.cam_pivot.max_jerk")}));
  EXPECT_TRUE(lines_are(messages_with("[limits.bodies.cam]\nmax_pressure_angle = 30\n"),
                        {part("limits.bodies.cam.max_pressure_angle")}));
}

TEST(Limits, ThatMakeNoSenseAreRefusedWithTheirPlace) {
  const auto refused = [](const std::string& limit, const std::string& message) {
    EXPECT_THAT(messages_with("[limits]\n" + limit + "\n"),
                ElementsAre(AllOf(HasSubstr("test.toml:"), HasSubstr("limits."), HasSubstr(message))))
        << limit;
  };
  refused("max_pressure_angle = 90", "a pressure angle is limited to more than 0 and less than 90 deg");
  refused("max_pressure_angle = -5", "more than 0 and less than 90 deg");
  refused("max_return_pressure_angle = \"2 rad\"", "more than 0 and less than 90 deg");
  refused("min_convex_radius = 0", "must be > 0");
  refused("min_concave_radius = -3", "must be > 0");
  refused("max_sliding_speed = -1", "must be > 0");
  refused("min_contact_force = -1", "must be >= 0");
  refused("min_speed_factor = 0", "must be > 0");
  refused("elastic_modulus = -206000", "must be > 0");
  refused("poisson_ratio = 0.51", "Poisson's ratio is from 0 to 0.5");
  refused("max_contact_force = \"5 mm\"", "mm is a length");
  refused("max_contact_force = \"much\"", "does not begin with a number");
  refused("width = nan", "finite");
}

TEST(Limits, MustBeATable) {
  EXPECT_TRUE(lines_are(messages("limits = 3\n" + std::string(kCamProfile).substr(11)), {part("limits")}));
  EXPECT_TRUE(lines_are(messages_with("[limits]\ncontacts = 3\n"), {part("limits.contacts")}));
}

TEST(Limits, OfThePressureNeedWidthAndMaterials) {
  EXPECT_TRUE(
      lines_are(messages_with("[limits]\nmax_contact_pressure = 800\n"),
                {part("limits.max_contact_pressure: the pressure of contacts.touch also needs limits.width "
                      "and limits.elastic_modulus and limits.poisson_ratio")}));
  EXPECT_TRUE(
      lines_are(messages_with("[limits]\nmax_contact_pressure = 800\nwidth = 10\npoisson_ratio = 0.3\n"
                              "[limits.bodies.cam]\nelastic_modulus = \"206 GPa\"\n"),
                {part("also needs limits.elastic_modulus")}));
  EXPECT_THAT(messages_with("[limits]\nmax_contact_pressure = 800\nwidth = 10\npoisson_ratio = 0.3\n"
                            "[limits.bodies.cam]\nelastic_modulus = \"206 GPa\"\n"
                            "[limits.bodies.follower]\nelastic_modulus = \"110 GPa\"\n"),
              IsEmpty());
}

TEST(PressureUnits, AreMultiplesOfNewtonsBySquareMetres) {
  constexpr Dimension kPressure = dimension::kForce / (dimension::kLength * dimension::kLength);
  const auto si = [&](const std::string& text) {
    return parse_quantity(text, kPressure, Units()).value().si;
  };
  EXPECT_EQ(si("3 Pa"), 3);
  EXPECT_EQ(si("3 kPa"), 3e3);
  EXPECT_EQ(si("735.25 MPa"), 735.25e6);
  EXPECT_EQ(si("206 GPa"), 206e9);
  EXPECT_EQ(si("206000 N/mm^2"), 206e9);
  EXPECT_EQ(parse_quantity("206 GPa", kPressure, Units()).value().profile, 206000);
  // Powers, and other units next to them.
  EXPECT_EQ(parse_quantity("2 MPa mm^2", dimension::kForce, Units()).value().si, 2);
  EXPECT_EQ(parse_quantity("4 N/MPa", dimension::kLength * dimension::kLength, Units()).value().profile, 4);
  EXPECT_TRUE(contains(parse_quantity("4 MPa", dimension::kForce, Units()).error(), "MPa"));
}

}  // namespace
}  // namespace higherpair
