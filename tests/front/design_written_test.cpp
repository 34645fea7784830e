// What design() writes: a profile of the mechanism that was found, in the assembly that was found.
#include "front/cam_profile.hpp"
#include "higherpair/front/design.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::model_of;

DesignReport found_design(const Model& model) {
  DesignSettings settings;
  settings.starts = 8;
  auto report = design(model, settings);
  if (!report) throw std::runtime_error(to_string(report.error()));
  return *std::move(report);
}

double fixed_angle(const Model& model, const std::string& name) {
  for (const Joint& joint : model.mechanism().joints) {
    if (joint.name == name) return joint.relative_angle;
  }
  return kNoValue;
}

double first_value(const Model& model, const std::string& column) {
  RunSettings settings;
  settings.columns = {column};
  const Motion motion = model.run(settings).value();
  return motion.column(column)[0];
}

// A rod slides along the driven crank, at a fixed angle of 30 degrees to it that only the poses say; its end
// B is on a rocker of length L about (100, 0).
std::string rod_on_crank(int start) {
  return fmt::format(R"(
[bodies.ground]
points.O = [0, 0]
points.O4 = [100, 0]
[bodies.crank]
points.O = [0, 0]
[bodies.rod]
pose = {{ x = 80, y = 0, angle = 30 }}
points.P = [0, 0]
points.B = [60, 0]
[bodies.rocker]
pose = {{ x = 100, y = 0, angle = 80 }}
points.O = [0, 0]
points.B = [110, 0]
[joints]
main  = {{ type = "revolute", between = ["ground.O", "crank.O"] }}
guide = {{ type = "prismatic", between = ["crank.O", "rod.P"], direction = [1, 0] }}
B     = {{ type = "revolute", between = ["rod.B", "rocker.B"] }}
pivot = {{ type = "revolute", between = ["ground.O4", "rocker.O"] }}
[driver]
joint = "main"
start = {}
end = {}
samples = 5
[design]
[design.variables]
rocker = {{ path = "bodies.rocker.points.B.0", min = 105, max = 130 }}
[[design.objectives]]
column = "guide.position"
of = "first"
target = -40
)",
                     start, start + 10);
}

// The place s of the rod on the crank: |s u + d| = L with u along the crank and d from the rocker's pivot to
// B for s = 0.
double place_of_rod(double start_deg, double L, int sign) {
  const double a = start_deg * kPi / 180, b = a + kPi / 6;
  const Vector2d u(std::cos(a), std::sin(a));
  const Vector2d d(60 * std::cos(b) - 100, 60 * std::sin(b));
  return -u.dot(d) + sign * std::sqrt(std::pow(u.dot(d), 2) - d.squaredNorm() + L * L);
}

TEST(WrittenDesigns, KeepTheFixedAngleThatOnlyThePosesSay) {
  for (const int start : {10, 40}) {
    const Model before = model_of(rod_on_crank(start));
    const DesignReport report = found_design(before);
    double best = kInf;
    for (int k = 0; k <= 250; ++k) {
      for (const int sign : {-1, 1}) {
        best = std::min(best, std::pow(place_of_rod(start, 105 + 0.1 * k, sign) + 40, 2));
      }
    }
    EXPECT_TRUE(report.as_found) << start;
    EXPECT_TRUE(report.holds) << start;
    EXPECT_NEAR(report.optima.at(0).objective, best, start == 10 ? 1e-6 : 0.01);
    EXPECT_NEAR(report.after, report.optima.at(0).objective, 1e-9 * (1 + best));
    const Model after = model_of(report.text);
    EXPECT_NEAR(fixed_angle(after, "guide"), kPi / 6, 1e-15);
    EXPECT_NEAR(std::pow(first_value(after, "guide.position") + 40, 2), report.after, 1e-9 * (1 + best));
  }
}

// A cam lifts a slide by a law, and the slide moves a rocker by a rod. The base circle is that of the poses,
// and the run does not begin there.
TEST(WrittenDesigns, KeepTheBaseCircleOfACam) {
  const DesignReport report = found_design(model_of(R"(
[bodies.ground]
points.O = [0, 0]
points.P = [60, 60]
[bodies.cam]
points.O = [0, 0]
curves.flank = { type = "cam", law = "lift", contact = "touch" }
[bodies.slide]
pose = { x = 0, y = 60, angle = 0 }
points.A = [0, 0]
curves.roller = { type = "circle", center = [0, 0], radius = 10 }
[bodies.rod]
pose = { x = 0, y = 60, angle = 60 }
points.A = [0, 0]
points.B = [50, 0]
[bodies.rocker]
pose = { x = 60, y = 60, angle = 130 }
points.O = [0, 0]
points.B = [50, 0]
[laws.lift]
segments = [{ over = 120, law = "cycloidal", rise = 15 }, { over = 60, law = "dwell" },
            { over = 120, law = "cycloidal", rise = -15 }, { over = 60, law = "dwell" }]
[joints]
main  = { type = "revolute", between = ["ground.O", "cam.O"] }
guide = { type = "prismatic", between = ["ground.O", "slide.A"], direction = [0, 1] }
A     = { type = "revolute", between = ["slide.A", "rod.A"] }
B     = { type = "revolute", between = ["rod.B", "rocker.B"] }
pivot = { type = "revolute", between = ["ground.P", "rocker.O"] }
[contacts.touch]
between = ["cam.flank", "slide.roller"]
[driver]
joint = "main"
start = 100
end = 460
samples = 73
[design]
[design.variables]
rocker = { path = "bodies.rocker.points.B.0", min = 42, max = 60 }
[[design.objectives]]
column = "rocker.angle"
of = "first"
target = 210
)"));
  const double share = 100.0 / 120;
  const double y = 60 + 15 * (share - std::sin(2 * kPi * share) / (2 * kPi));
  const double D = std::hypot(60, y - 60), towards = std::atan2(y - 60, -60);
  double best = kInf;
  for (int k = 0; k <= 1800; ++k) {
    const double r = 42 + 0.01 * k;
    const double beside = std::acos((r * r + D * D - 50 * 50) / (2 * r * D));
    for (const double sign : {-1, 1}) {
      best = std::min(best, std::pow((towards + sign * beside) * 180 / kPi - 210, 2));
    }
  }
  EXPECT_TRUE(contains(report.text, "pose = { x = 0, y = 60, angle = 0 }"));
  EXPECT_TRUE(report.as_found);
  EXPECT_NEAR(report.after, best, 1e-6 * best);
  EXPECT_NEAR(first_value(model_of(report.text), "slide.A.y"), y, 1e-9);
}

TEST(WrittenDesigns, KeepAllDigitsOfAFixedAngle) {
  const DesignReport report = found_design(model_of(R"(
[bodies.ground]
points.O = [0, 0]
points.rail = [0, 10]
[bodies.crank]
points.O = [0, 0]
points.A = [30, 0]
[bodies.rod]
pose = { x = 30, y = 0, angle = 5 }
points.A = [0, 0]
points.B = [100, 0]
[bodies.slide]
pose = { x = 130, y = 10, angle = 33.3333333333 }
points.B = [0, 0]
[joints]
main  = { type = "revolute", between = ["ground.O", "crank.O"] }
A     = { type = "revolute", between = ["crank.A", "rod.A"] }
B     = { type = "revolute", between = ["rod.B", "slide.B"] }
guide = { type = "prismatic", between = ["ground.rail", "slide.B"], direction = [1, 0] }
[driver]
joint = "main"
samples = 37
[design]
[design.variables]
rod = { path = "bodies.rod.points.B.0", min = 60, max = 150 }
[[design.objectives]]
column = "slide.B.x"
of = "first"
target = -60
)"));
  // The slide is left of the crank: 30 - sqrt(L^2 - 10^2) = -60.
  EXPECT_NEAR(report.variables.at(0).after, std::hypot(90, 10), 1e-6);
  EXPECT_LE(report.after, 1e-9);
  EXPECT_TRUE(report.as_found);
  EXPECT_TRUE(contains(report.text, "angle = 33.3333333333 }"));
}

// Coupler and rocker carry driven slides whose start is their place in the poses, so that the poses of both
// must stay, and lead to the assembly that is not wanted.
TEST(WrittenDesigns, SayThatTheyStartOtherwiseWherePosesAreExact) {
  const std::string text = R"(
[bodies.ground]
points.O = [0, 0]
points.P = [100, 0]
[bodies.crank]
points.O = [0, 0]
points.A = [30, 0]
[bodies.rod]
pose = { x = 30, y = 0, angle = 50 }
points.A = [0, 0]
points.B = [80, 0]
[bodies.rocker]
pose = { x = 100, y = 0, angle = 110 }
points.P = [0, 0]
points.B = [70, 0]
[bodies.first]
pose = { x = 40, y = 10, angle = 50 }
points.Q = [0, 0]
[bodies.second]
pose = { x = 95, y = 10, angle = 110 }
points.Q = [0, 0]
[joints]
main   = { type = "revolute", between = ["ground.O", "crank.O"] }
A      = { type = "revolute", between = ["crank.A", "rod.A"] }
B      = { type = "revolute", between = ["rod.B", "rocker.B"] }
P      = { type = "revolute", between = ["ground.P", "rocker.P"] }
slide1 = { type = "prismatic", between = ["rod.A", "first.Q"], direction = [1, 0] }
slide2 = { type = "prismatic", between = ["rocker.P", "second.Q"], direction = [1, 0] }
[drivers.main]
joint = "main"
positions = [0, 10, 20]
[drivers.one]
joint = "slide1"
end = 30
samples = 3
[drivers.two]
joint = "slide2"
end = 30
samples = 3
[design]
[design.variables]
rod = { path = "bodies.rod.points.B.0", min = 75, max = 90 }
[[design.objectives]]
column = "rocker.angle"
of = "first"
target = 245
)";
  const DesignReport report = found_design(model_of(text));
  // Below the frame the rocker is at -115 degrees, or 245: the rod is from (30, 0) to there.
  const double a = 245 * kPi / 180;
  const double rod = std::hypot(70 + 70 * std::cos(a), 70 * std::sin(a));
  EXPECT_NEAR(report.variables.at(0).after, rod, 1e-6);
  EXPECT_NEAR(report.optima.at(0).objective, 0, 1e-9);
  EXPECT_FALSE(report.as_found);
  EXPECT_FALSE(report.holds);
  EXPECT_TRUE(contains(report.text, "pose = { x = 30, y = 0, angle = 50 }"));
  EXPECT_NEAR(report.after, std::pow(115 - 245, 2), 1e-4);  // the mirrored assembly
}

TEST(WrittenDesigns, KeepTheTurnsOfAngles) {
  std::ostringstream text;
  text << std::ifstream(HIGHERPAIR_SOURCE_DIR "/profiles/toggle_press.toml").rdbuf() << R"(
[design]
[design.variables]
lower = { path = "bodies.lower.points.R.0", min = 128, max = 200 }
[[design.objectives]]
column = "lower.angle"
of = "min"
weight = 0.01
)";
  const DesignReport report = found_design(model_of(text.str(), {"driver.samples=25"}));
  EXPECT_TRUE(report.as_found);
  EXPECT_LE(report.after, report.before);
  EXPECT_NEAR(report.after, report.optima.at(0).objective, 1e-9);
  const Motion motion = model_of(report.text, {"driver.samples=25"}).run().value();
  const auto angles = motion.column("lower.angle");
  EXPECT_NEAR(*std::min_element(angles.begin(), angles.end()), report.after / 0.01, 1e-6);
  EXPECT_LE(std::abs(angles[0] + 100), 180);  // the pose says -100
}

}  // namespace
}  // namespace higherpair
