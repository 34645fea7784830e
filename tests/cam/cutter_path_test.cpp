#include "higherpair/cam/cutter_path.hpp"

#include "geometry/geometry_testing.hpp"
#include "higherpair/geometry/contour.hpp"

namespace higherpair {
namespace {

using Kind = CutterFault::Kind;

Boundary boundary(std::vector<SpanPtr> spans, bool closed) {
  return *Boundary::make(std::move(spans), closed, 1e-9);
}

Boundary polygon(const std::vector<Vector2d>& corners, double fillet) {
  std::vector<ContourPiece> pieces;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    pieces.push_back(LinePiece{corners[i], corners[(i + 1) % corners.size()]});
  }
  return boundary(spans_of(fillet > 0 ? with_fillets(pieces, true, fillet)->pieces : pieces), true);
}

TEST(CutterPath, OfADiscIsACircleAroundIt) {
  const Boundary disc = boundary_of(*make_circle({0.003, 0.001}, 0.0127), 1);
  const auto path = cutter_path(disc, 0.031);
  ASSERT_TRUE(path);
  for (const Boundary::Sample& sample : path->samples()) {
    EXPECT_NEAR((sample.point.p_B - Vector2d(0.003, 0.001)).norm(), 0.0127 + 0.031, 1e-16);
    EXPECT_NEAR(sample.point.kappa * (0.0127 + 0.031), 1, 1e-13);
  }
}

TEST(CutterPath, RoundsConvexCorners) {
  const auto path = cutter_path(polygon({{0, 0}, {0.03, 0}, {0.03, 0.02}, {0, 0.02}}, 0), 0.005);
  ASSERT_TRUE(path);
  ASSERT_EQ(path->spans().size(), 8U);
  EXPECT_NEAR(path->size(), std::hypot(0.04, 0.03) / 2, 1e-15);
}

TEST(CutterPath, AHollowFlankTakesACutterThatIsRounder) {
  // A ring: a hollow ellipse, whose smallest radius of curvature b²/a is at the ends of its long axis.
  const double a = 0.031, b = 0.0231;
  const Boundary ring = boundary_of(*make_ellipse({0, 0}, {a, b}, 0.3, Side::kOutside), 1);
  EXPECT_TRUE(cutter_path(ring, 0.99 * b * b / a));
  const auto refused = cutter_path(ring, 1.01 * b * b / a);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, Kind::kHollow);
  EXPECT_NEAR(refused.error().largest * a / (b * b), 1, 1e-12);
  EXPECT_NEAR(std::abs(refused.error().at_B.dot(unit_vector(0.3))), a, 1e-12);
}

// A pocket whose corners are rounded with the cutter's own radius: the cutter just fits, and its path has
// sharp corners.
TEST(CutterPath, WaitsInTheCentreOfAHollowArcOfItsOwnRadius) {
  std::vector<Vector2d> corners = {
      {0, 0}, {0, 0.02}, {0.03, 0.02}, {0.03, 0}};  // clockwise: material outside
  const Boundary pocket = polygon(corners, 0.0047);
  const auto path = cutter_path(pocket, 0.0047);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->spans().size(), 4U);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(path->joint_after(i), SpanJoint::kNotch);
  }
  EXPECT_NEAR(path->size(), std::hypot(0.03 - 0.0094, 0.02 - 0.0094) / 2, 1e-15);
  const auto larger = cutter_path(pocket, 0.0047 * (1 + 1e-6));
  ASSERT_FALSE(larger);
  EXPECT_NEAR(larger.error().largest, 0.0047, 1e-15);
  // A round hole of the cutter's own radius leaves no path.
  EXPECT_FALSE(cutter_path(boundary_of(*make_circle({0, 0}, 0.01, Side::kOutside), 1), 0.01));
}

TEST(CutterPath, NoCutterCutsANotch) {
  const auto path = cutter_path(polygon({{0.01, 0}, {0, -0.02}, {0.05, 0}, {0, 0.02}}, 0), 1e-4);
  ASSERT_FALSE(path);
  EXPECT_EQ(path.error().kind, Kind::kNotch);
  EXPECT_NEAR((path.error().at_B - Vector2d(0.01, 0)).norm(), 0, 1e-15);
}

TEST(CutterPath, AMouthIsAsWideAsTheCutterThatGetsIn) {
  // Half of the mouth is 4 mm wide; the corners of the pocket behind it have a slightly larger radius.
  const std::vector<Vector2d> corners = {{-0.04, -0.03}, {0.04, -0.03},  {0.04, 0.03},   {0.004, 0.03},
                                         {0.004, 0.02},  {0.016, 0.02},  {0.016, -0.01}, {-0.016, -0.01},
                                         {-0.016, 0.02}, {-0.004, 0.02}, {-0.004, 0.03}, {-0.04, 0.03}};
  const Boundary pocket = polygon(corners, 0.00451);
  EXPECT_TRUE(cutter_path(pocket, 0.0039));
  const auto refused = cutter_path(pocket, 0.0044);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, Kind::kCrossing);
  EXPECT_NEAR(refused.error().largest, 0.004, 1e-10);
  EXPECT_NEAR(refused.error().at_B.x(), 0, 1e-3);
  // This cutter is too large for the corners as well; the reported radius is one that passes the mouth.
  const auto larger = cutter_path(pocket, 0.006);
  ASSERT_FALSE(larger);
  EXPECT_EQ(larger.error().kind, Kind::kHollow);
  EXPECT_NEAR(larger.error().largest, 0.004, 1e-10);
}

TEST(CutterPath, TwoCuttersInTurnAreOneOfTheSumOfTheirRadii) {
  const Boundary flank = boundary_of(*make_ellipse({0.004, -0.001}, {0.031, 0.0127}, 0.3), 1);
  const Boundary once = *cutter_path(flank, 0.0101);
  const Boundary twice = *cutter_path(*cutter_path(flank, 0.0031), 0.007);
  for (std::size_t i = 0; i < once.samples().size(); ++i) {
    EXPECT_NEAR((once.samples()[i].point.p_B - twice.samples()[i].point.p_B).norm(), 0, 1e-16);
    EXPECT_NEAR(once.samples()[i].point.kappa / twice.samples()[i].point.kappa, 1, 1e-12);
  }
}

}  // namespace
}  // namespace higherpair
