// Columns: which ones exist, their units, and that only the requested ones are returned.
#include "front/cam_profile.hpp"
#include "front/columns/column_set.hpp"
#include "higherpair/higherpair.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::kCam;
using testing::lines_are;
using testing::model_of;

TEST(CsvText, IsQuotedWhereItHasWhatSeparatesFieldsOrLines) {
  const auto text = [](std::string_view content) {
    std::string out;
    append_csv_text(content, out);
    return out;
  };
  EXPECT_EQ(text("a b"), "a b");
  EXPECT_EQ(text("a,b"), "\"a,b\"");
  EXPECT_EQ(text("a\nb"), "\"a\nb\"");
  EXPECT_EQ(text("a\rb"), "\"a\rb\"");
  EXPECT_EQ(text("a \"b\""), "\"a \"\"b\"\"\"");
}

std::vector<std::string> heads(const std::vector<Column>& columns) {
  std::vector<std::string> heads;
  for (const Column& column : columns) {
    heads.push_back(column.name + " " + column.unit);
  }
  return heads;
}

std::vector<std::string> heads_of(const Model& model, const RunSettings& settings) {
  return heads(model.start(settings).value().columns());
}

Motion forces_at(const Model& model, double position) {
  RunSettings settings;
  settings.forces = true;
  settings.positions = {position};
  return model.run(settings).value();
}

double cell(const Motion& motion, const std::string& name) {
  return motion.column(name)[0];
}

constexpr const char* kLoad = "\n[loads]\ndown = { body = \"follower\", point = \"P\", force = [0, -12] }\n";

TEST(Columns, OfForcesComeBeforeStatusAndResidual) {
  const Model model = model_of(kCam);
  const auto motion = heads_of(model, {});
  RunSettings settings;
  settings.forces = true;
  const auto all = heads_of(model, settings);
  const auto first = static_cast<std::ptrdiff_t>(motion.size()) - 2;
  EXPECT_TRUE(std::equal(motion.begin(), motion.begin() + first, all.begin()));
  EXPECT_TRUE(lines_are(
      std::vector<std::string>(all.begin() + first, all.end()),
      {"O.fx N", "O.fy N", "guide.fx N", "guide.fy N", "guide.m N*mm", "touch.force N", "touch.friction N",
       "driver.effort N*mm", "driver.effort_check N*mm", "status ", "residual mm"}));
}

TEST(Columns, ShowForcesAndTorquesInTheProfilesUnits) {
  const double theta = 0.5;
  for (const auto& [units, force, length] :
       {std::tuple("", 1.0, 1.0), std::tuple("units = { length = \"cm\", force = \"kN\" }\n", 1e3, 10.0)}) {
    const Model model =
        model_of(units + std::string(kCam) + kLoad,
                 {"bodies.cam.curves.disc.center=[\"10 mm\", 0]", "bodies.cam.curves.disc.radius=\"30 mm\"",
                  "bodies.follower.pose.y=\"30 mm\"", "loads.down.force=[0, \"-12 N\"]"});
    const Motion motion = forces_at(model, theta * 180 / kPi);
    const double torque = 120 * std::cos(theta) / (force * length);
    EXPECT_NEAR(cell(motion, "touch.force"), 12 / force, 1e-11 / force);
    EXPECT_EQ(cell(motion, "touch.friction"), 0);
    EXPECT_NEAR(cell(motion, "O.fy"), 12 / force, 1e-11 / force);
    EXPECT_NEAR(cell(motion, "driver.effort"), torque, 1e-10 / force);
    EXPECT_NEAR(cell(motion, "driver.effort_check"), torque, 1e-10 / force);
    EXPECT_NEAR(cell(motion, "guide.m"), -torque, 1e-10 / force);
    EXPECT_EQ(motion.statuses()[0], RowStatus::kOk);
  }
}

TEST(Columns, NameTheEffortOfSeveralDriversByTheirNames) {
  std::string text = kCam;
  text.replace(text.find("[driver]"), 8, "[drivers.motor]");
  RunSettings settings;
  settings.forces = true;
  settings.columns = {"driver.motor.eff*"};
  EXPECT_TRUE(lines_are(heads_of(model_of(text), settings),
                        {"driver.motor.effort N*mm", "driver.motor.effort_check N*mm"}));
}

TEST(Columns, SayThatAContactIsOpenAndKeepItsPullingForce) {
  const Motion motion = forces_at(model_of(std::string(kCam) + kLoad, {"loads.down.force=[0, 7]"}), 30);
  EXPECT_NEAR(cell(motion, "touch.force"), -7, 1e-11);
  EXPECT_EQ(motion.statuses()[0], RowStatus::kContactOpen);
  const auto status = motion.column("status");
  EXPECT_EQ(word_of(motion.columns()[motion.columns().size() - 2], status[0]), "contact_open");
  EXPECT_FALSE(motion.good());
}

TEST(Columns, OfOneNameAreRefused) {
  // A body and a contact of the same name both have x and y.
  std::string shared = kCam;
  for (std::size_t at = shared.find("touch"); at != std::string::npos; at = shared.find("touch")) {
    shared.replace(at, 5, "cam");
  }
  const auto refused = model_of(shared).start();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kInput);
  EXPECT_TRUE(contains(to_string(refused.error()), "two columns would be called 'cam.x': rename one of"));
}

TEST(Columns, AreChosenByGlobsInTheOrderOfTheTable) {
  RunSettings settings;
  settings.columns = {"touch.rho?", "driver", "follower.P.*x", "driver"};
  EXPECT_TRUE(lines_are(heads_of(model_of(kCam), settings),
                        {"driver deg", "follower.P.x mm", "follower.P.vx mm/s", "follower.P.ax mm/s^2",
                         "touch.rho1 mm", "touch.rho2 mm"}));
}

TEST(Columns, ChosenOneByOneAreBitForBitThoseOfTheWholeTable) {
  RunSettings settings;
  settings.forces = true;
  settings.jerk = true;
  settings.derivatives = 4;
  settings.samples = 25;
  const Model model = model_of(std::string(kCam) + kLoad);
  const Motion all = model.run(settings).value();
  for (const Column& column : all.columns()) {
    settings.columns = {column.name};
    const Motion one = model.run(settings).value();
    ASSERT_EQ(one.columns().size(), 1U);
    EXPECT_EQ(one.columns()[0].unit, column.unit);
    const auto expected = all.column(column.name);
    const auto found = one.column(column.name);
    for (std::size_t k = 0; k < all.size(); ++k) {
      EXPECT_TRUE(found[k] == expected[k] || (std::isnan(found[k]) && std::isnan(expected[k])))
          << column.name << ", row " << k;
    }
  }
}

TEST(Columns, ThatNoGlobMatchesAreAnErrorWithTheNearestNames) {
  const Model model = model_of(kCam);
  for (const auto& [glob, hint] :
       {std::pair("folower.y", "did you mean `follower.y`"),
        std::pair("cam.omga", "did you mean `cam.omega`"), std::pair("omega", "did you mean `*.omega`"),
        std::pair("nothing.*", "no column of this run"), std::pair("", "setting columns ")}) {
    RunSettings settings;
    settings.columns = {"driver", glob};
    const auto refused = model.start(settings);
    ASSERT_FALSE(refused) << glob;
    EXPECT_EQ(refused.error().kind, ErrorKind::kInput);
    EXPECT_TRUE(contains(to_string(refused.error()), hint));
  }
}

TEST(Columns, ComeInTheUnitsAskedFor) {
  RunSettings settings;
  settings.samples = 7;
  const Model model = model_of(kCam);
  const Motion own = model.run(settings).value();
  settings.units = kSiUnits;
  const Motion si = model.run(settings).value();
  for (const auto& [name, unit, factor] :
       {std::tuple("driver", "rad", kPi / 180), std::tuple("driver.velocity", "rad/s", kPi / 180),
        std::tuple("follower.y", "m", 1e-3), std::tuple("follower.vy", "m/s", 1e-3),
        std::tuple("cam.angle", "rad", kPi / 180)}) {
    const auto column = si.column(name);
    EXPECT_EQ(column.unit, unit);
    for (std::size_t k = 0; k < si.size(); ++k) {
      EXPECT_NEAR(column[k], factor * own.column(name)[k], 4e-15) << name;
    }
  }
  ASSERT_EQ(own.events().size(), si.events().size());
  for (std::size_t i = 0; i < own.events().size(); ++i) {
    EXPECT_EQ(si.events()[i].driver, own.events()[i].driver_si);
  }
}

// The cam's pivot is 8 mm to the left of the follower's path, on the side of +90 deg turned by +90 deg.
TEST(Columns, OffsetOfASlideDoesNotDependOnWhichBodyItsJointNamesFirst) {
  for (const char* between : {R"(["ground.G", "f.P"])", R"(["f.P", "ground.G"])"}) {
    const Model model = model_of(std::string(R"(
[bodies.ground]
points.O = [0, 0]
points.G = [8, 0]
[bodies.cam]
points.O = [0, 0]
curves.k = { type = "circle", center = [10, 0], radius = 20 }
[bodies.f]
pose = { x = 8, y = 40 }
points.P = [0, 0]
curves.k = { type = "circle", center = [0, 0], radius = 5 }
[joints]
main  = { type = "revolute", between = ["ground.O", "cam.O"] }
guide = { type = "prismatic", direction = 90, between = )") +
                                 between + R"( }
[contacts.k]
between = ["cam.k", "f.k"]
[driver]
joint = "main"
samples = 13
)");
    const Motion motion = model.run().value();
    for (const double r1 : motion.column("k.r1")) {
      EXPECT_NEAR(r1, 8, 1e-12) << between;
    }
  }
}

// A roller that does not turn moves as its pin does, at right angles to the arm.
TEST(Columns, PressureAngleOfACarriedRollerIsDefinedAtRest) {
  for (const double velocity : {60.0, 0.0}) {
    const Motion motion =
        testing::shipped_model("roller_body", {fmt::format("driver.velocity={}", velocity)}).run().value();
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const double arm = std::atan2(motion.column("arm.P.y")[k], motion.column("arm.P.x")[k] - 80);
      const double wanted = std::abs(std::sin(arm - motion.column("touch.normal")[k] * kPi / 180));
      EXPECT_NEAR(std::cos(motion.column("touch.pressure")[k] * kPi / 180), wanted, 1e-12) << velocity;
    }
  }
}

TEST(Columns, PressureAngleOfARollingRollerIsThatOfItsMotionAlsoAtRest) {
  const auto pressure = [](const char* velocity) {
    const Motion motion =
        testing::shipped_model("roller_body", {"contacts.touch.rolling=true", velocity}).run().value();
    const auto column = motion.column("touch.pressure");
    return std::vector<double>(column.begin(), column.end());
  };
  const std::vector<double> moving = pressure("driver.velocity=60");
  const std::vector<double> at_rest = pressure("driver.velocity=0");
  ASSERT_EQ(moving.size(), at_rest.size());
  for (std::size_t k = 0; k < moving.size(); ++k) {
    EXPECT_NEAR(at_rest[k], moving[k], 1e-9) << k;
  }
}

TEST(Columns, AMissingOneIsAnErrorWithTheNearestNames) {
  const Motion motion = model_of(kCam).run().value();
  EXPECT_TRUE(motion.find_column("follower.alpha"));
  const auto missing = motion.find_column("folower.alpha");
  ASSERT_FALSE(missing);
  EXPECT_THROW((void)motion.column("folower.alpha"), std::out_of_range);
  EXPECT_TRUE(contains(to_string(missing.error()), "did you mean `follower.alpha`"));
}

TEST(Columns, AsTextAreTheLinesOfTheProgram) {
  RunSettings settings;
  settings.samples = 1;
  settings.columns = {"driver", "touch.linkage", "touch.transmission", "status"};
  Analysis analysis = model_of(kCam).start(settings).value();
  Row row;
  ASSERT_TRUE(analysis.next(row));
  std::string text;
  append_csv_header(analysis.columns(), text);
  append_csv_row(analysis.columns(), row, text);
  EXPECT_EQ(text, "driver[deg],touch.linkage,touch.transmission[deg],status\n0,scotch yoke,,ok\n");
}

}  // namespace
}  // namespace higherpair
