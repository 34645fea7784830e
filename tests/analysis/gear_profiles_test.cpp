// The shipped profiles with gears and belts move as their comments say.
#include "higherpair/analysis/run.hpp"
#include "higherpair/io/profile_reader.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

constexpr double kRounding = 1e-14;  // of lengths up to 0.36 m and their squares

// A shipped profile with its driver at any position.
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
