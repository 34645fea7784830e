// The extent of a mechanism's motion as a requirement of a design, compared with closed forms.
#include "front/cam_profile.hpp"
#include "front/slider_profile.hpp"
#include "support/texts.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::kCam;
using testing::kSlider;
using testing::model_of;

// With the slide level with the crank's pivot and rows every 10 degrees all extremes fall on rows.
const std::vector<std::string> kLevel = {"bodies.ground.points.rail.1=0", "driver.samples=37"};

const std::string kCrank =
    "[design.variables]\n"
    "crank = { path = \"bodies.crank.points.A.0\", min = 10, max = 60 }\n";

DesignReport designed_twice(const Model& model) {
  DesignSettings settings;
  settings.starts = 2;
  auto report = design(model, settings);
  if (!report) throw std::runtime_error(to_string(report.error()));
  return *std::move(report);
}

// Designs the slider-crank, with its crank as the variable.
DesignReport with_crank(const std::string& objective, const std::string& constraint = "") {
  return designed_twice(model_of(kSlider + kCrank + "[[design.objectives]]\n" + objective +
                                     (constraint.empty() ? "" : "[[design.constraints]]\n") + constraint,
                                 kLevel));
}

double before(const std::string& objective) {
  return with_crank(objective + "target = 100\n").objectives.at(0).before;
}

TEST(DesignExtents, AreThoseOfAllPlacesTogether) {
  EXPECT_NEAR(before("size = \"height\"\n"), 60, 1e-9);
  EXPECT_NEAR(before("size = \"width\"\n"), 160, 1e-9);
  EXPECT_NEAR(before("size = \"largest\"\n"), 160, 1e-9);
  EXPECT_NEAR(before("size = \"width\"\nbodies = [\"slider\"]\n"), 60, 1e-9);
  EXPECT_NEAR(before("reach = \"slider.B\"\nfrom = \"ground.O\"\n"), 130, 1e-9);
  EXPECT_NEAR(before("reach = \"slider.B\"\nfrom = \"crank.O\"\n"), 130, 1e-9);
}

TEST(DesignExtents, ReachTheirTargets) {
  const DesignReport height = with_crank("size = \"height\"\ntarget = 84\n");
  EXPECT_NEAR(height.variables[0].after, 42, 1e-6);
  EXPECT_EQ(height.objectives[0].what, "height");
  EXPECT_EQ(height.objectives[0].unit, "mm");
  const DesignReport reach = with_crank("reach = \"slider.B\"\nfrom = \"ground.O\"\ntarget = 118.5\n");
  EXPECT_NEAR(reach.variables[0].after, 18.5, 1e-6);
  EXPECT_EQ(reach.objectives[0].what, "reach of slider.B from ground.O");
}

// The stroke is twice the crank, and each millimetre of width costs one millimetre of stroke.
TEST(DesignExtents, AreLimitsAndSayWhatTheyCost) {
  const DesignReport report =
      with_crank("column = \"slider.x\"\nof = \"min\"\n", "size = \"width\"\nbelow = 150\n");
  EXPECT_TRUE(report.holds);
  EXPECT_NEAR(report.variables[0].after, 25, 1e-6);  // 2 r + 100
  ASSERT_EQ(report.constraints.size(), 1U);
  EXPECT_EQ(report.constraints[0].what, "width below 150");
  EXPECT_NEAR(report.constraints[0].cost, 0.5, 1e-6);
}

TEST(DesignExtents, HaveCurvesInThem) {
  const std::string cam = kCam + std::string(R"(samples = 73
[design.variables]
throw = { path = "bodies.cam.curves.disc.center.0", min = 2, max = 20 }
[[design.objectives]]
size   = "height"
bodies = ["cam"]
target = 90
)");
  const DesignReport report = designed_twice(model_of(cam));
  EXPECT_NEAR(report.objectives[0].before, 80, 1e-9);
  EXPECT_NEAR(report.variables[0].after, 15, 1e-6);
}

// An ellipse on a pivot off its middle, as a conic and as a spline through points of it.
TEST(DesignExtents, OfACurveAreThoseOfAllOfIt) {
  const auto place = [](double t) {
    const double x = 20 * std::cos(t), y = 12 * std::sin(t), c = std::cos(kPi / 6), s = std::sin(kPi / 6);
    return Vector2d(3 + c * x - s * y, s * x + c * y);
  };
  const auto width = [](const std::string& curve) {
    return designed_twice(model_of(R"(
[bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O = [0, 0]
curves.oval = )" + curve + R"(
[joints]
O = { type = "revolute", between = ["ground.O", "cam.O"] }
[driver]
joint   = "O"
samples = 361
end     = 360
[design.variables]
x = { path = "bodies.cam.points.O.0", min = -2, max = 2 }
[[design.objectives]]
size = "width"
)"))
        .objectives.at(0)
        .before;
  };
  double far = 0;
  for (int k = 0; k < 360000; ++k) far = std::max(far, place(k * kPi / 180000).norm());
  std::string points;
  for (int k = 0; k < 90; ++k) {
    const Vector2d p = place(k * kPi / 45);
    points += fmt::format("[{}, {}], ", p.x(), p.y());
  }
  for (const std::string& curve :
       {std::string(R"({ type = "ellipse", center = [3, 0], semi_axes = [20, 12], rotation = 30 })"),
        R"({ type = "spline", closed = true, points = [)" + points + "] }"}) {
    EXPECT_NEAR(width(curve), 2 * far, 0.004) << curve;  // error of rows at every degree
  }
}

TEST(DesignExtents, SayWhatIsWrong) {
  const auto says = [](const std::string& entry) {
    const std::vector<std::string> overrides = {"design.constraints=[{ below = 3, " + entry + " }]"};
    const auto model = Model::open(HIGHERPAIR_SOURCE_DIR "/profiles/design_five_points.toml", overrides);
    return model ? "" : to_string(model.error());
  };
  EXPECT_TRUE(contains(says(R"(size = "wide")"), "did you mean `width`"));
  EXPECT_TRUE(contains(says(R"(size = "width", bodies = [])"), "expected a list of bodies"));
  EXPECT_TRUE(contains(says(R"(size = "width", bodies = ["crnk"])"), "did you mean `crank`"));
  EXPECT_TRUE(contains(says(R"(size = "width", from = "ground.O")"), "belongs to a reach"));
  EXPECT_TRUE(contains(says(R"(size = "width", of = "max")"), "an extent is the largest already"));
  EXPECT_TRUE(contains(says(R"(size = "width", column = "crank.angle")"), "make an entry of its own"));
  EXPECT_TRUE(contains(says(R"(reach = "coupler.E")"), "from is missing"));
  EXPECT_TRUE(
      contains(says(R"(reach = "coupler.X", from = "coupler.E")"), "body `coupler` has no point `X`"));
  EXPECT_TRUE(contains(says(R"(reach = "coupler.A", from = "coupler.E")"), "both points are of one body"));
  EXPECT_TRUE(contains(says(R"(reach = "coupler.A", size = "width", from = "ground.O2")"),
                       "make an entry of its own of the size"));
}

}  // namespace
}  // namespace higherpair
