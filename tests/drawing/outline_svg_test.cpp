#include "higherpair/drawing/outline_svg.hpp"

#include "drawing/outline.hpp"
#include "drawing/sketch.hpp"

#include <cmath>

#include <gmock/gmock.h>

namespace higherpair {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kInch = 0.0254;  // 96 px

TEST(OutlineSvg, DrawsArcsOnTheirSide) {
  // A half disc above the x axis, three inches across, counter-clockwise from its right end, as also seen on
  // the screen.
  const ArcPolyline above = {{{{3 * kInch, 0}, 1}, {{0, 0}, 0}}, true};
  const std::string svg = outline_svg({{"cam.a", above}}, "A", {"mm", 1e-3});
  EXPECT_THAT(svg, HasSubstr("d=\"M298 154A144 144 0 0 0 10 154L298 154Z\""));
  EXPECT_THAT(svg, HasSubstr("width=\"308\" height=\"164\""));
  EXPECT_THAT(svg, HasSubstr("data-origin=\"10 154\""));
  // Three quarters of a circle below the axis, clockwise (tan 67.5°).
  const double b = 2.414213562373095;
  const ArcPolyline below = {{{{kInch, 0}, -b}, {{0, 0}, 0}}, false};
  EXPECT_THAT(outline_svg({{"cam.b", below}}, "B", {"in", kInch}), HasSubstr("A67.88225 67.88225 0 1 1 "));
}

TEST(OutlineSvg, MarksTheOriginWhereItIsInThePicture) {
  const ArcPolyline far = {{{{3 * kInch, kInch}, 0}, {{4 * kInch, 2 * kInch}, 0}}, false};
  EXPECT_THAT(outline_svg({{"cam.a", far}}, "A", {"mm", 1e-3}), Not(HasSubstr("data-role=\"origin\"")));
  const ArcPolyline near = {{{{-kInch, -kInch}, 0}, {{4 * kInch, 2 * kInch}, 0}}, false};
  const std::string svg = outline_svg({{"cam.a", near}, {"cam.b", far}}, "A", {"mm", 1e-3});
  EXPECT_THAT(svg, HasSubstr("data-role=\"origin\""));
  EXPECT_THAT(svg, HasSubstr("data-name=\"cam.b\""));
}

// By the equation of the curve, which is negative in the material.
TEST(Material, OfOpenConicsBeginsOnTheCurveAndIsBehindIt) {
  for (const Side side : {Side::kInside, Side::kOutside}) {
    for (const Curve& curve :
         {*make_hyperbola({3, -2}, {4, 3}, 0.7, side), *make_parabola({-1, 5}, 2, 2.1, side)}) {
      const std::vector<double> path = material(curve, 1.5, {-6, 9});
      const std::array<double, 6> k = implicit_coefficients(curve);
      const auto F = [&](std::size_t i) {
        const double x = path[2 * i], y = path[2 * i + 1];
        return k[0] * x * x + k[1] * y * y + k[2] * x * y + k[3] * x + k[4] * y + k[5];
      };
      const std::size_t count = path.size() / 2;
      for (std::size_t i = 0; i + 2 < count; ++i) EXPECT_NEAR(F(i), 0, 1e-12);
      EXPECT_LT(std::max(F(count - 2), F(count - 1)), -1);
    }
  }
}

TEST(Wheels, OfABeltDoNotMeetWhicheverIsLarger) {
  Joint belt;
  belt.type = JointType::kBelt;
  for (const double k : {3.0, -3.0, 0.25}) {
    belt.turning_ratio = k;
    const auto [first, second] = wheel_radii(belt, 10);
    EXPECT_NEAR(first / second, std::abs(k), 1e-15);
    EXPECT_NEAR(std::max(first, second), 4, 1e-15);
  }
}

}  // namespace
}  // namespace higherpair
