#include "higherpair/drawing/outline_svg.hpp"

#include "support/texts.hpp"

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;

constexpr double kInch = 0.0254;  // 96 px

TEST(OutlineSvg, DrawsArcsOnTheirSide) {
  // A half disc above the x axis, three inches across, counter-clockwise from its right end, as also seen on
  // the screen.
  const ArcPolyline above = {{{{3 * kInch, 0}, 1}, {{0, 0}, 0}}, true};
  const std::string svg = outline_svg({{"cam.a", above}}, "A", {"mm", 1e-3});
  EXPECT_TRUE(contains(svg, "d=\"M298 154A144 144 0 0 0 10 154L298 154Z\""));
  EXPECT_TRUE(contains(svg, "width=\"308\" height=\"164\""));
  EXPECT_TRUE(contains(svg, "data-origin=\"10 154\""));
  // Three quarters of a circle below the axis, clockwise (tan 67.5°).
  const double b = 2.414213562373095;
  const ArcPolyline below = {{{{kInch, 0}, -b}, {{0, 0}, 0}}, false};
  EXPECT_TRUE(contains(outline_svg({{"cam.b", below}}, "B", {"in", kInch}), "A67.88225 67.88225 0 1 1 "));
}

TEST(OutlineSvg, MarksTheOriginWhereItIsInThePicture) {
  const ArcPolyline far = {{{{3 * kInch, kInch}, 0}, {{4 * kInch, 2 * kInch}, 0}}, false};
  EXPECT_FALSE(contains(outline_svg({{"cam.a", far}}, "A", {"mm", 1e-3}), "data-role=\"origin\""));
  const ArcPolyline near = {{{{-kInch, -kInch}, 0}, {{4 * kInch, 2 * kInch}, 0}}, false};
  const std::string svg = outline_svg({{"cam.a", near}, {"cam.b", far}}, "A", {"mm", 1e-3});
  EXPECT_TRUE(contains(svg, "data-role=\"origin\""));
  EXPECT_TRUE(contains(svg, "data-name=\"cam.b\""));
}

}  // namespace
}  // namespace higherpair
