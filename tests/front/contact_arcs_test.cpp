#include "io/profile_testing.hpp"
#include "sliding_cam.hpp"

#include <cmath>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

// Arcs of contacts whose curves have several parts, or none of a closed form.

namespace higherpair {
namespace {

using testing::model_of;
using testing::motion_of;
using testing::profile_of;
using testing::replaced;
using testing::shipped_model;

constexpr const char* kEllipse =
    "curves.oval = { type = \"ellipse\", center = [3, 1], semi_axes = [30, 20] }";

std::string ellipse_and_roller(const std::string& driver) {
  return profile_of({kEllipse,
                     "pose = { x = 0, y = 42 }\ncurves.roller = { type = \"circle\", center = [0, 0], "
                     "radius = 12 }",
                     "direction = [0, 1]", "between = [\"cam.oval\", \"follower.roller\"]", driver});
}

// As a part of a body with two curves, the same ellipse has its arcs from its parts.
TEST(ContactArcs, OfAPartOfABodyAreThoseOfTheCurveAlone) {
  for (const std::string driver :
       {"start = 20\nend = 1200\nsamples = 60", "start = 20\nend = -1200\nsamples = 7"}) {
    const std::string alone = ellipse_and_roller(driver);
    std::string part = replaced(alone, "\"cam.oval\", \"follower.roller\"", "\"cam\", \"follower\"");
    part =
        replaced(part, kEllipse,
                 std::string(kEllipse) + "\ncurves.hub = { type = \"circle\", center = [3, 1], radius = 5 }");
    const Motion one = motion_of(model_of(alone)), two = motion_of(model_of(part));
    ASSERT_EQ(one.size(), two.size());
    for (const char* name : {"touch.arc1", "touch.arc2"}) {
      for (std::size_t k = 0; k < one.size(); ++k) {
        EXPECT_NEAR(two.column(name).values[k], one.column(name).values[k], 1e-9) << name << ' ' << k;
      }
    }
  }
}

// A flat face at the height h(θ) of a cam touches it at a place that is h′ beside the guide; once around, the
// contact has run over the circumference ∫ h dθ (A. Cauchy).
TEST(ContactArcs, OnceAroundAFlankOfALawAreItsCircumference) {
  const Model model = shipped_model("law_cam_flat", {"driver.samples=3601"});
  const Motion motion = motion_of(model);
  const auto height = motion.column("follower.y").values;
  double circumference = 0;  // by the trapezoidal rule, which is exact to rounding for periodic functions
  for (std::size_t k = 0; k + 1 < height.size(); ++k) {
    circumference += height[k] * 2 * kPi / static_cast<double>(height.size() - 1);
  }
  const auto arc1 = motion.column("touch.arc1").values, arc2 = motion.column("touch.arc2").values;
  EXPECT_NEAR(std::abs(arc1.back()), circumference, 1e-6 * circumference);
  EXPECT_NEAR(arc2.back(), 0, 1e-9);
  // Faces have their arcs by their length: h′ beside the guide.
  const auto slope = motion.column("slide.velocity").values;
  const auto rate = motion.column("driver.velocity").values;
  for (std::size_t k = 0; k < height.size(); k += 50) {
    EXPECT_NEAR(std::abs(arc2[k]), std::abs(slope[k] / (rate[k] * kPi / 180)), 1e-9 * height[k]) << k;
  }
}

// A contact that has parted has no arcs any more.
TEST(ContactArcs, EndWhereTheContactParts) {
  const std::string text = profile_of(
      {"curves.disc = { type = \"circle\", center = [10, 0], radius = 20 }",
       "pose = { x = 0, y = 20 }\ncurves.face = { type = \"line\", point = [0, 0], normal = [0, -1] }",
       "direction = [0, 1]\nfrom = 15", "between = [\"cam.disc\", \"follower.face\"]\nkeep = \"gap\"",
       "start = 0\nend = 720\nsamples = 73"});
  const Motion motion = motion_of(model_of(text));
  const double leaves = 180 + std::asin(0.5) * 180 / kPi;  // 20 + 10 sin θ = 15
  for (std::size_t k = 0; k < motion.size(); ++k) {
    const double theta = 10 * static_cast<double>(k);
    if (std::abs(theta - leaves) > 1) {
      EXPECT_EQ(std::isfinite(motion.column("touch.arc1").values[k]), theta < leaves) << theta;
    }
    if (theta < leaves - 1) {
      EXPECT_NEAR(motion.column("touch.arc1").values[k], -20 * theta * kPi / 180, 1e-9) << theta;
      EXPECT_NEAR(motion.column("touch.arc2").values[k], 10 - 10 * std::cos(theta * kPi / 180), 1e-9)
          << theta;
    }
  }
}

}  // namespace
}  // namespace higherpair
