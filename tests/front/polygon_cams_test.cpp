#include "sliding_cam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

// Cams with straight flanks, convex corners and notches: under a roller, compared with the greatest height to
// which any point of the cam lifts it, and under a knife edge.

namespace higherpair::testing {
namespace {

// A polygon around the origin, counter-clockwise, with concave and convex corners.
std::vector<Vector2d> star(std::mt19937& random) {
  std::uniform_real_distribution<double> radius(15, 60), shift(-0.3, 0.3);
  const int corners = std::uniform_int_distribution<int>(4, 9)(random);
  std::vector<Vector2d> points;
  for (int i = 0; i < corners; ++i) {
    points.push_back(radius(random) * unit_vector(2 * kPi * (i + shift(random)) / corners));
  }
  return points;
}

std::string chain_of(const std::vector<Vector2d>& points) {
  std::string spans;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector2d& a = points[i];
    const Vector2d& b = points[(i + 1) % points.size()];
    spans += fmt::format("{} {{ type = \"segment\", from = [{}, {}], to = [{}, {}] }}", i == 0 ? "" : ",",
                         a.x(), a.y(), b.x(), b.y());
  }
  return "curves.flank = { type = \"chain\", spans = [" + spans + " ] }";
}

constexpr double kRadius = 7;
const std::string kRoller = R"({ type = "circle", center = [0, 0], radius = 7 })";

std::string profile_of_polygon(const std::vector<Vector2d>& points, const std::string& tip) {
  return profile_of({chain_of(points), "pose = { y = 100 }\ncurves.tip = " + tip, "direction = [0, 1]",
                     "between = [\"cam.flank\", \"follower.tip\"]\napproach = \"-\"",
                     "start = 0\nend = 360\nvelocity = \"1 rad/s\""});
}

// The height of the roller's centre above x = 0 when the cam has turned by theta.
double height_at(std::vector<Vector2d> points, double theta) {
  for (Vector2d& point : points) {
    point = Rotation<double>::from_angle(theta) * point;
  }
  const double r = kRadius;
  double height = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector2d& a = points[i];
    const Vector2d edge = points[(i + 1) % points.size()] - a;
    const Vector2d n = -perp(edge).normalized();
    const double share = -(a.x() + r * n.x()) / edge.x();
    if (n.y() > 0 && share >= 0 && share <= 1) {
      height = std::max(height, a.y() + r * n.y() + share * edge.y());
    }
    if (std::abs(a.x()) < r) {
      height = std::max(height, a.y() + std::sqrt(r * r - a.x() * a.x()));
    }
  }
  return height;
}

TEST(PolygonCams, LiftARollerAsHighAsTheirHighestPoint) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 12; ++trial) {
    const std::vector<Vector2d> points = star(random);
    const Motion motion = motion_of(model_of(profile_of_polygon(points, kRoller)), 73);
    const ColumnValues driver = motion.column("driver");
    const ColumnValues lift = motion.column("guide.position");
    EXPECT_TRUE(motion.good()) << trial;
    for (std::size_t i = 0; i < motion.size(); ++i) {
      EXPECT_NEAR(lift[i], height_at(points, driver[i] * kPi / 180), 1e-10) << trial << ' ' << driver[i];
    }
  }
}

// A roof whose middle is below or above its eaves, under a tip that is above the middle at 0.
TEST(PolygonCams, SayWhereATipGoesThroughANotchAndOverACorner) {
  const auto motion_under = [](double ridge) {
    const std::string profile = profile_of_polygon({{-40, -30}, {40, -30}, {40, 20}, {0, ridge}, {-40, 20}},
                                                   R"({ type = "point", at = [0, 0] })");
    return motion_of(model_of(profile, {"driver.start=-30", "driver.end=30"}), 7);
  };
  const Motion notch = motion_under(10);
  EXPECT_TRUE(notch.good());
  ASSERT_EQ(notch.events().size(), 1U);
  EXPECT_EQ(notch.events()[0].type, EventType::kSecondContact);
  EXPECT_NEAR(notch.events()[0].driver, 0, 1e-9);
  EXPECT_NE(notch.events()[0].cause.find("goes on beyond a concave corner of cam"), std::string::npos);
  const Motion ridge = motion_under(25);
  EXPECT_TRUE(ridge.good());
  const auto corners = events_of(ridge, EventType::kCorner);
  ASSERT_EQ(corners.size(), 1U);
  EXPECT_NEAR(corners[0].driver, 0, 1e-9);
  EXPECT_NE(corners[0].cause.find("goes over a corner of cam"), std::string::npos);
}

// A roller of negligible size moves like a knife edge, and its change of sides in a notch is reported.
TEST(PolygonCams, GoThroughNotchesUnderTheSmallestRollersAsUnderAKnifeEdge) {
  const std::vector<Vector2d> points{{-40, -30}, {40, -30}, {40, 20}, {3, 10}, {-40, 20}};
  const auto motion_under = [&](const std::string& tip) {
    return motion_of(model_of(profile_of_polygon(points, tip), {"driver.start=-30", "driver.end=30"}), 61);
  };
  const Motion edge = motion_under(R"({ type = "point", at = [0, 0] })");
  ASSERT_TRUE(edge.good());
  for (const double radius : {1e-2, 1e-5, 1e-6, 1e-7}) {
    SCOPED_TRACE(radius);
    const Motion roller =
        motion_under(fmt::format(R"({{ type = "circle", center = [0, 0], radius = {} }})", radius));
    ASSERT_TRUE(roller.good());
    EXPECT_FALSE(roller.events().empty());
    for (std::size_t i = 0; i < roller.size(); ++i) {
      EXPECT_NEAR(roller.column("guide.position")[i], edge.column("guide.position")[i], 3 * radius);
    }
  }
}

// The knife edge is beside the cam as long as neither of the two corners reaches it.
TEST(PolygonCams, LoseAKnifeEdgeWhileTheyPassBesideIt) {
  const std::vector<Vector2d> points{{49.359, -1.416}, {5.627, 15.985}, {-35.618, -16.093}, {4.214, -20.86}};
  const double beside = 9.63;
  // The cam's angles at which the corner is as far to the right as the edge.
  const auto angle_of_corner = [&](const Vector2d& corner, double side) {
    return (side * std::acos(beside / corner.norm()) - std::atan2(corner.y(), corner.x())) * 180 / kPi;
  };
  for (const int rows : {7, 73, 601}) {
    const Motion motion =
        motion_of(model_of(profile_of_polygon(points, R"({ type = "point", at = [9.63, 0] })")), rows);
    const auto limits = events_of(motion, EventType::kLimitPosition);
    ASSERT_EQ(limits.size(), 2U) << rows;
    EXPECT_NEAR(limits[0].driver, angle_of_corner(points[2], 1), 1e-9);
    EXPECT_NEAR(limits[1].driver, angle_of_corner(points[1], -1) + 360, 1e-9);
  }
}

}  // namespace
}  // namespace higherpair::testing
