#include "sliding_cam.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

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
  EXPECT_TRUE(contains(jumps[0].cause, " to 0.279253 mm/deg"));
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

// What the program says of the first jump of the oval's ring.
std::string first_jump(const std::vector<std::string>& overrides) {
  const auto events =
      events_of(motion_of(shipped_model("oval_in_ring", overrides), 7), EventType::kSecondContact);
  return events.empty() ? "" : events.front().cause;
}

TEST(JumpsOfRates, AreThoseOfTheFollowerOnEitherSide) {
  const Motion rows = motion_of(shipped_model(
      "oval_in_ring", {"driver.positions=[0, 99.39339, 99.3934]", R"(driver.velocity="1 rad/s")"}));
  const ColumnValues omega = rows.column("ring.omega");
  EXPECT_NEAR(omega[1] * kPi / 180, 0.428072, 1e-5);
  EXPECT_NEAR(omega[2] * kPi / 180, -0.250785, 1e-5);
  EXPECT_TRUE(contains(first_jump({}), "the rate of ring jumps from 0.428072 to -0.250785"));
}

TEST(JumpsOfRates, HaveTheSignOfTheDrivenCoordinate) {
  EXPECT_TRUE(contains(first_jump({R"(joints.cam_pivot.between=["cam.O", "ground.O1"])", "driver.end=-360"}),
                       "the rate of ring jumps from -0.428072 to 0.250785"));
}

// A cam of four arcs under a flat face, and a first driver that turns twice as fast as the cam.
TEST(JumpsOfRates, OfSeveralDriversDoNotDependOnRows) {
  std::string text =
      profile_of({R"(curves.outline = { type = "chain", spans = [
  { type = "arc", center = [24, 0], radius = 8, from = -36.86989764584402, to = 36.86989764584402 },
  { type = "arc", center = [0, -18], radius = 38, from = 36.86989764584402, to = 90 },
  { type = "arc", center = [0, 0], radius = 20, from = 90, to = 270 },
  { type = "arc", center = [0, 18], radius = 38, from = 270, to = 323.13010235415598 }] })",
                  "pose = { y = 40 }\ncurves.face = { type = \"line\", point = [0, 0], normal = [0, -1] }",
                  "direction = [0, 1]", R"(between = ["cam.outline", "follower.face"])", ""});
  text.erase(text.find("[driver]"));
  text += R"([bodies.idle]
points.O = [0, 0]
[joints.fast]
type = "revolute"
between = ["ground.O", "idle.O"]
)";
  for (const int samples : {7, 61, 601}) {
    const Model model = model_of(text + fmt::format(R"([drivers]
fast = {{ joint = "fast", end = 720, samples = {0} }}
cam = {{ joint = "pivot", end = 360, samples = {0} }}
)",
                                                    samples));
    const auto jumps = events_of(motion_of(model), EventType::kCurvatureJump);
    ASSERT_FALSE(jumps.empty());
    // From the flank's 18 cos of the angle turned on it, 53.13 deg, to the nose's -24 cos of 36.87 deg.
    const double per_square_degree = kPi / 180 * kPi / 180 / 4;
    EXPECT_TRUE(contains(jumps[0].cause,
                         fmt::format("; for a unit rate of driver fast the acceleration of joint guide "
                                     "jumps from {:.6g} to {:.6g} mm/deg^2",
                                     10.8 * per_square_degree, -19.2 * per_square_degree)));
  }
}

}  // namespace
}  // namespace higherpair::testing
