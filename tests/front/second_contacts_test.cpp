#include "sliding_cam.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Curves that touch at a second point, and contacts that move onto a part of a curve and back, all within one
// step between rows that are far apart.

namespace higherpair::testing {
namespace {

// Three discs of radius 4 at (10, -9), (10.09, 0) and (10, 9) move a flat face that faces to the left: it is
// at 4 + the largest x of their centres. The middle disc leads only while |θ| < atan 0.01.
const std::string kThreeDiscs = profile_of({R"(curves.d1 = { type = "circle", center = [10, -9], radius = 4 }
curves.d2 = { type = "circle", center = [10.09, 0], radius = 4 }
curves.d3 = { type = "circle", center = [10, 9], radius = 4 })",
                                            R"(pose = { x = 14 }
curves.face = { type = "line", point = [0, 0], normal = [-1, 0] })",
                                            "direction = [1, 0]", R"(between = ["cam.d*", "follower.face"])",
                                            "start = -97.3\nend = 262.7"});

TEST(SecondContacts, AreFoundAlsoWhereTheyAreLeftAgainWithinAStep) {
  const Model model = model_of(kThreeDiscs);
  const double turn = std::atan(0.01) * 180 / kPi;
  for (const int samples : {3, 7, 61, 601}) {
    const Motion motion = motion_of(model, samples);
    EXPECT_TRUE(motion.good()) << samples;
    const auto events = events_of(motion, EventType::kSecondContact);
    ASSERT_EQ(events.size(), 3U) << samples;
    EXPECT_NEAR(events[0].driver, -turn, 1e-11);
    EXPECT_NEAR(events[1].driver, turn, 1e-11);
    EXPECT_NEAR(events[2].driver, 180, 1e-11);
    const ColumnValues driver = motion.column("driver");
    const ColumnValues lift = motion.column("follower.x");
    for (std::size_t i = 0; i < motion.size(); ++i) {
      const double theta = driver[i] * kPi / 180;
      const double top = std::max({10 * std::cos(theta) + 9 * std::sin(theta), 10.09 * std::cos(theta),
                                   10 * std::cos(theta) - 9 * std::sin(theta)});
      EXPECT_NEAR(lift[i], 4 + top, 1e-12) << driver[i];
    }
  }
}

TEST(SecondContacts, ThatMayNotBeGoneOverToAreOverlaps) {
  const Model model = model_of(kThreeDiscs, {"contacts.touch.jump=false"});
  for (const int samples : {7, 61}) {
    const Motion motion = motion_of(model, samples);
    EXPECT_FALSE(motion.good());
    const auto overlaps = events_of(motion, EventType::kOverlap);
    ASSERT_FALSE(overlaps.empty());
    EXPECT_TRUE(events_of(motion, EventType::kSecondContact).empty());
  }
}

// An eccentric disc lifts a tappet whose edge is rounded from x = 9.99 on. The contact is at x = 10 cos θ: it
// is on the rounding only while cos θ > 0.999, and turns back there.
const std::string kRoundedTappet = profile_of(
    {R"(curves.disc = { type = "circle", center = [10, 0], radius = 30 })",
     R"(pose = { y = 20 }
curves.face = { type = "chain", closed = false, spans = [{ type = "segment", from = [-20, 0], to = [9.99, 0] }, { type = "arc", center = [9.99, 5], radius = 5, from = -90, to = -30 }] })",
     "direction = [0, 1]", R"(between = ["cam.disc", "follower.face"])", "start = -97.3\nend = 262.7"});

TEST(SpanJoints, AreFoundAlsoWhereTheContactTurnsBackWithinAStep) {
  const Model model = model_of(kRoundedTappet);
  const double turn = std::acos(0.999) * 180 / kPi;
  for (const int samples : {3, 7, 61, 601}) {
    const Motion motion = motion_of(model, samples);
    EXPECT_TRUE(motion.good()) << samples;
    const auto jumps = events_of(motion, EventType::kCurvatureJump);
    ASSERT_EQ(jumps.size(), 2U) << samples;
    EXPECT_NEAR(jumps[0].driver, -turn, 1e-9);
    EXPECT_NEAR(jumps[1].driver, turn, 1e-9);
  }
}

// The convex cam of two circles and their tangents: 20 sin θ + 8 on the nose, 20 on the base circle.
Model tangent_cam_with_flat_face(const std::vector<std::string>& more = {}) {
  std::vector<std::string> overrides{
      R"(bodies.follower.curves.roller={ type = "line", point = [0, 0], normal = [0, -1] })"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return shipped_model("tangent_cam", overrides);
}

void expect_lift_of_tangent_cam(const Motion& motion) {
  EXPECT_TRUE(motion.good());
  const ColumnValues driver = motion.column("driver");
  const ColumnValues lift = motion.column("follower.y");
  for (std::size_t i = 0; i < motion.size(); ++i) {
    EXPECT_NEAR(lift[i], std::max(20.0, 20 * std::sin(driver[i] * kPi / 180) + 8), 1e-12) << driver[i];
  }
  const auto jumps = events_of(motion, EventType::kSecondContact);
  ASSERT_EQ(jumps.size(), 2U);
  EXPECT_NEAR(jumps[0].driver, 36.86989764584402, 1e-11);
  EXPECT_NEAR(jumps[1].driver, 143.13010235415598, 1e-11);
  EXPECT_THAT(jumps[0].cause, ::testing::HasSubstr(" to 0.016 (SI units)"));
  EXPECT_TRUE(events_of(motion, EventType::kCurvatureJump).empty());
}

TEST(FlatFlanks, ThatComeToLieOnAFlatFaceAreGoneOver) {
  for (const int samples : {2, 5, 37, 361}) {
    expect_lift_of_tangent_cam(motion_of(tangent_cam_with_flat_face(), samples));
  }
}

TEST(FlatFlanks, MayLieOnTheFaceInARow) {
  const Motion motion =
      tangent_cam_with_flat_face(
          {"driver.positions=[0, 36.86989764584402, 90, 143.13010235415598, 180]", "driver.start=0"})
          .run()
          .value();
  EXPECT_TRUE(motion.good());
  const ColumnValues lift = motion.column("follower.y");
  for (const double wrong : {lift[1] - 20, lift[2] - 28, lift[3] - 20}) {
    EXPECT_NEAR(wrong, 0, 1e-12);
  }
}

}  // namespace
}  // namespace higherpair::testing
