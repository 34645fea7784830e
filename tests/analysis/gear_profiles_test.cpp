// The shipped profiles with gears and belts move as their comments claim.
#include "geometry/geometry_testing.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/geometry/gear_pair.hpp"
#include "higherpair/io/profile_reader.hpp"
#include "higherpair/mechanism/boundaries.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::kDegree;

constexpr double kRounding = 1e-14;  // for lengths up to 0.36 m and their squares

// A shipped profile with its driver at an arbitrary position.
class ShippedProfile {
public:
  explicit ShippedProfile(const std::string& name)
      : mechanism_(
            read_profile_file(std::string(HIGHERPAIR_SOURCE_DIR "/profiles/") + name + ".toml")->mechanism),
        run_(start_run(mechanism_, {0}).value()) {}

  void drive_to(double position) { move_to(run_, {{position, 1, 0}}); }

  [[nodiscard]] RowStatus status() const { return run_.row.status; }

  [[nodiscard]] const BodyMotion& body(const std::string& name) const { return run_.row.bodies[index(name)]; }

  [[nodiscard]] Vector2d point(const std::string& owner, const std::string& name) const {
    for (const NamedPoint& point : mechanism_.bodies[index(owner)].points) {
      if (point.name == name) {
        return body(owner).X_WB * point.p_B;
      }
    }
    ADD_FAILURE() << "no point " << name;
    return Vector2d::Zero();
  }

private:
  [[nodiscard]] std::size_t index(const std::string& name) const {
    for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) {
      if (mechanism_.bodies[i].name == name) return i;
    }
    ADD_FAILURE() << "no body " << name;
    return 0;
  }

  Mechanism mechanism_;
  Run run_;
};

// The law of gearing: involute flanks turn the wheels in the constant ratio of the pitch circles, and the
// contact point moves straight along the line of action, which is inclined by the pressure angle.
TEST(GearProfiles, AnInvolutePairKeepsItsRatioAlongTheLineOfAction) {
  Mechanism mechanism =
      read_profile_file(std::string(HIGHERPAIR_SOURCE_DIR "/profiles/") + "involute_pair.toml")->mechanism;
  use_boundaries(mechanism);
  auto run = start_run(mechanism, {-19.5 * kDegree}).value();
  const double base = 0.020 * std::cos(20 * kDegree);
  for (int i = 0; i <= 288; ++i) {
    const double angle = (-19.5 + 0.1 * i) * kDegree;
    move_to(run, {{angle, 1, 0}});
    ASSERT_EQ(run.row.status, RowStatus::kOk) << i;
    const BodyMotion& wheel = run.row.bodies[2];
    EXPECT_NEAR(wheel.omega, -0.5, 1e-12);
    EXPECT_NEAR(wheel.alpha, 0, 1e-11);
    EXPECT_NEAR(wheel.theta, 177.75 * kDegree - (angle + 4.5 * kDegree) / 2, 1e-12);
    // Distance from the pitch point: the arc of the base circle.
    const double along = base * (angle + 4.5 * kDegree);
    const Vector2d line_of_action = unit_vector(70 * kDegree);
    const CommonNormal& at = run.row.contacts[0].at;
    EXPECT_NEAR((at.p_W() - Vector2d(0.020, 0) - along * line_of_action).norm(), 0, 1e-14) << i;
    // Relative angular velocity times the distance from the pitch point.
    EXPECT_NEAR(std::abs(run.row.contacts[0].rates.sliding), 1.5 * std::abs(along), 1e-13);
  }
}

TEST(GearProfiles, AnInvolutePairMeetsFromTipToTip) {
  // Path of contact of 20 and 40 teeth, as angles of the first wheel.
  const GearPair pair = close_pair({0.002, 20, 20 * kPi / 180, 0}, {0.002, 40, 20 * kPi / 180, 0});
  const PathOfContact path = path_of_contact(pair);
  const double first = -4.5 * kDegree - path.approach / base_radius(pair.first);
  const double last = -4.5 * kDegree + path.recess / base_radius(pair.first);
  EXPECT_NEAR(first / kDegree, -19.922, 5e-4);
  EXPECT_NEAR(last / kDegree, 9.512, 5e-4);
  Mechanism mechanism =
      read_profile_file(std::string(HIGHERPAIR_SOURCE_DIR "/profiles/") + "involute_pair.toml")->mechanism;
  use_boundaries(mechanism);
  constexpr double kNear = 1e-6;
  EXPECT_TRUE(start_run(mechanism, {first + kNear}));
  EXPECT_FALSE(start_run(mechanism, {first - kNear}));
  EXPECT_TRUE(start_run(mechanism, {last - kNear}));
  EXPECT_FALSE(start_run(mechanism, {last + kNear}));
}

TEST(GearProfiles, ThePlanetDrawsAnAstroidWhileTheSunTurnsThreeTimes) {
  ShippedProfile gear("planetary_gear");
  for (const double sun : {0.0, 0.7, 3.1, 8.8, 6 * kPi}) {
    gear.drive_to(sun);
    ASSERT_EQ(gear.status(), RowStatus::kOk);
    const double arm = sun / 3;
    EXPECT_NEAR(gear.body("arm").theta, arm, 1e-14);
    EXPECT_NEAR(gear.body("planet").omega, -1, 1e-14);
    const Vector2d astroid(0.036 * std::pow(std::cos(arm), 3), 0.036 * std::pow(std::sin(arm), 3));
    EXPECT_NEAR((gear.point("planet", "cusp") - astroid).norm(), 0, kRounding);
  }
}

TEST(GearProfiles, TheBeltTurnsTheCrankByTheRatioOfTheRadii) {
  ShippedProfile drive("belt_drive");
  for (const double motor : {0.0, 0.9, 5.3, 5 * kPi}) {
    drive.drive_to(motor);
    ASSERT_EQ(drive.status(), RowStatus::kOk);
    const double crank = motor * 40 / 100;
    EXPECT_NEAR(drive.body("crank").theta, crank, 1e-14);
    const double piston =
        0.2 + 0.03 * std::cos(crank) + std::sqrt(0.12 * 0.12 - std::pow(0.03 * std::sin(crank), 2));
    EXPECT_NEAR(drive.point("piston", "B").x(), piston, kRounding);
  }
}

TEST(GearProfiles, TheGearedFiveBarMovesItsPointOnAStraightLine) {
  ShippedProfile five_bar("geared_five_bar");
  for (const double crank : {0.0, 0.4, 2.2, 4.7, 6.1}) {
    five_bar.drive_to(crank);
    ASSERT_EQ(five_bar.status(), RowStatus::kOk);
    const double half = 0.05 - 0.03 * std::cos(crank);
    const Vector2d T(0.05, 0.03 * std::sin(crank) + std::sqrt(0.12 * 0.12 - half * half));
    EXPECT_NEAR((five_bar.point("left_link", "T") - T).norm(), 0, kRounding);
    EXPECT_NEAR((five_bar.point("right_link", "T") - T).norm(), 0, kRounding);
  }
}

}  // namespace
}  // namespace higherpair
