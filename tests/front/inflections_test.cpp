// Jerks and higher derivatives where a cam's flank has no curvature, or hardly any: no conic has its rate
// there.
#include "io/profile_testing.hpp"
#include "sliding_cam.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::model_of;
using testing::motion_of;
using testing::shipped_model;

// A cam that slides under a roller and lifts it by 10 over 60, cycloidally: halfway its pitch curve is
// straight.
constexpr const char* kWedge = R"([bodies.ground]
points = { O1 = [0, 0], O2 = [0, 20] }
[bodies.cam]
points.O = [0, 0]
curves.flank = { type = "cam", law = "lift", contact = "k" }
[bodies.follower]
pose.y = 20
points.O = [0, 0]
curves.roller = { type = "circle", center = [0, 0], radius = 5 }
[joints]
slide = { type = "prismatic", between = ["ground.O1", "cam.O"], direction = [1, 0] }
lift = { type = "prismatic", between = ["ground.O2", "follower.O"], direction = [0, 1] }
[contacts.k]
between = ["cam.flank", "follower.roller"]
[driver]
joint = "slide"
velocity = 1
positions = [{}]
[laws.lift]
segments = [{ over = 60, law = "cycloidal", rise = 10 }, { over = 40, law = "cycloidal", rise = -10 }]
)";

TEST(Inflections, HaveTheDerivativesOfTheLaw) {
  std::vector<double> positions;
  std::string list;
  for (double off = 0.3; off > 1e-9; off /= 4) {
    positions.push_back(30 - off);
    positions.push_back(30 + off);
  }
  positions.push_back(30);
  for (const double at : positions) list += fmt::format("{}{}", list.empty() ? "" : ", ", at);
  std::string text = kWedge;
  text.replace(text.find("{}"), 2, list);
  RunSettings settings;
  settings.derivatives = 4;
  settings.jerk = true;
  const Motion motion = motion_of(model_of(text), settings);
  const double turn = 2 * M_PI / 60;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    SCOPED_TRACE(positions[k]);
    const double third = 10.0 / 60 * turn * turn * std::cos(turn * positions[k]);
    const double fourth = -10.0 / 60 * turn * turn * turn * std::sin(turn * positions[k]);
    EXPECT_NEAR(motion.column("follower.O.jy")[k], third, 1e-10 * std::abs(third));
    EXPECT_NEAR(motion.column("follower.d3y")[k], third, 1e-10 * std::abs(third));
    EXPECT_NEAR(motion.column("follower.d4y")[k], fourth, 1e-9 * std::abs(third));
  }
}

// The flank is cut anew for each roller and each place of the pivots: the lever moves by its law all the
// same.
TEST(Inflections, HaveTheJerkThatTheAccelerationsHave) {
  const auto at = [](double degrees, const char* column) {
    RunSettings settings;
    settings.jerk = true;
    const Motion motion =
        motion_of(shipped_model("groove_cam", {fmt::format("driver.positions=[{}]", degrees)}), settings);
    return motion.column(column)[0];
  };
  for (const double degrees : {165.6, 165.62, 165.6259, 165.63}) {
    SCOPED_TRACE(degrees);
    const double h = 0.01;
    const auto slope = [&](double step) {
      return (at(degrees + step, "lever.alpha") - at(degrees - step, "lever.alpha")) / (2 * step) *
             at(degrees, "driver.velocity");
    };
    const double expected = (4 * slope(h) - slope(2 * h)) / 3;
    EXPECT_NEAR(at(degrees, "lever.jerk"), expected, 1e-7 * std::abs(expected));
  }
}

}  // namespace
}  // namespace higherpair
