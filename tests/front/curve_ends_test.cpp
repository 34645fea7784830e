#include "mirrored.hpp"
#include "sliding_cam.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

// The ends of open curves are edges, on which a contact continues.

namespace higherpair::testing {
namespace {

// Position, velocity and acceleration of a tappet at dθ/dt = 1.
struct Lift {
  double s = 0, v = 0, a = 0;
};

// A disc of radius R, with its centre e from its pivot, under a tappet whose flat face ends at x = -w and w:
// y = R + e sin θ while the disc's centre is below the face, and beyond that the motion of a point on a
// circle.
struct NarrowTappet {
  double R = 20, e = 10, w = 5;

  [[nodiscard]] Lift at(double theta) const {
    const double c = e * std::cos(theta), s = e * std::sin(theta);
    if (std::abs(c) <= w) {
      return {R + s, c, -s};
    }
    const double side = c > 0 ? 1 : -1;
    const double d = side * c - w, d1 = -side * s, d2 = -side * c;
    const double y = std::sqrt(R * R - d * d);
    return {s + y, c - d * d1 / y, -s - (d1 * d1 + d * d2) / y - d * d1 * d * d1 / (y * y * y)};
  }

  [[nodiscard]] std::string profile(const std::string& contact = "", const std::string& guide = "") const {
    return profile_of(
        {fmt::format("curves.disc = {{ type = \"circle\", center = [{}, 0], radius = {} }}", e, R),
         fmt::format(
             "pose = {{ y = {} }}\ncurves.face = {{ type = \"segment\", from = [{}, 0], to = [{}, 0] }}",
             R + e, -w, w),
         "direction = [0, 1]\n" + guide, "between = [\"cam.disc\", \"follower.face\"]\n" + contact,
         "start = 90\nend = 450\nvelocity = \"1 rad/s\""});
  }
};

void expect_events(const std::vector<Event>& events, const std::vector<double>& drivers, double near) {
  ASSERT_EQ(events.size(), drivers.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_NEAR(events[i].driver, drivers[i], near) << i;
  }
}

TEST(EndsOfFaces, AreEdgesOnWhichAnEccentricDiscGoesOnInClosedForm) {
  const NarrowTappet tappet;
  const Model model = model_of(tappet.profile());
  for (const int samples : {7, 61, 601}) {
    const Motion motion = motion_of(model, samples);
    EXPECT_FALSE(motion.good()) << "a face that is left";
    const auto driver = motion.column("driver");
    const auto y = motion.column("guide.position");
    const auto v = motion.column("guide.velocity");
    const auto a = motion.column("guide.acceleration");
    for (std::size_t k = 0; k < motion.size(); ++k) {
      ASSERT_EQ(motion.statuses()[k], RowStatus::kOk) << driver[k];
      const double theta = driver[k] * kDegree;
      const Lift wanted = tappet.at(theta);
      EXPECT_NEAR(y[k], wanted.s, 1e-12) << driver[k];
      EXPECT_NEAR(v[k], wanted.v, 1e-11) << driver[k];
      if (std::abs(std::abs(10 * std::cos(theta)) - 5) > 1e-9) {
        EXPECT_NEAR(a[k], wanted.a, 1e-10) << driver[k];
      }
    }
    const auto ends = events_of(motion, EventType::kEnd);
    expect_events(ends, {120, 240, 300, 420}, 1e-10);
    EXPECT_EQ(ends[0].item, "touch");
    // On the edge -s - d'²/R with d' = s = 8.66.
    EXPECT_TRUE(contains(ends[0].cause, "reaches the end of the curve of follower and goes on at the edge"));
    EXPECT_TRUE(contains(ends[0].cause, "jumps from -0.00263806 to -0.00378038 mm/deg^2"));
    EXPECT_TRUE(contains(ends[1].cause, "leaves the edge at the end of the curve of follower"));
    EXPECT_TRUE(contains(ends[1].cause, "jumps from 0.00149575 to 0.00263806 mm/deg^2"));
    EXPECT_TRUE(events_of(motion, EventType::kCorner).empty());
  }
}

TEST(EndsOfFaces, AreTheSameBackwardsMirroredAndInOtherUnits) {
  const NarrowTappet tappet;
  const std::string text = tappet.profile();
  const std::vector<std::string> back{"driver.start=450", "driver.end=90"};
  expect_events(events_of(motion_of(model_of(text, back), 7), EventType::kEnd), {420, 300, 240, 120}, 1e-10);
  expect_events(events_of(motion_of(mirrored(model_of(text)), 7), EventType::kEnd), {-120, -240, -300, -420},
                1e-10);
  for (const char* unit : {"um", "m"}) {
    const Motion motion = motion_of(model_of(text, {fmt::format("units.length=\"{}\"", unit)}), 61);
    expect_events(events_of(motion, EventType::kEnd), {120, 240, 300, 420}, 1e-10);
    const auto a = motion.column("guide.acceleration");
    EXPECT_NEAR(a[15], tappet.at(180 * kDegree).a, 1e-10) << unit;
  }
}

// Compares a face's edge with a knife edge at the same position, whose contact with a whole conic has a
// closed form.
TEST(EndsOfFaces, MoveALeverAsAKnifeEdgeAtTheSamePlaceDoes) {
  const auto lever = [](const std::string& curve) {
    return R"([bodies.ground]
points.O1 = [0, 0]
points.O2 = [60, 5]
[bodies.cam]
points.O = [0, 0]
curves.oval = { type = "ellipse", center = [3, 1], semi_axes = [21, 13] }
[bodies.follower]
pose = { x = 60, y = 5, angle = 165 }
points.O = [0, 0]
)" + curve +
           R"(
[joints]
cam_pivot = { type = "revolute", between = ["ground.O1", "cam.O"] }
lever_pivot = { type = "revolute", between = ["ground.O2", "follower.O"] }
[contacts.touch]
between = ["cam.oval", "follower.tip"]
approach = "+"
[driver]
joint = "cam_pivot"
end = 360
samples = 41
velocity = "1 rad/s"
)";
  };
  // The face rises away from the cam, so that only its edge touches.
  const Motion edge =
      motion_of(model_of(lever("curves.tip = { type = \"segment\", from = [74.94, -28.77], to = [52, 4] }")));
  const Motion knife = motion_of(model_of(lever("curves.tip = { type = \"point\", at = [52, 4] }")));
  for (const char* column : {"lever_pivot.position", "lever_pivot.velocity", "lever_pivot.acceleration",
                             "touch.x", "touch.y", "touch.normal", "touch.rho1", "touch.rho2"}) {
    const auto one = edge.column(column);
    const auto other = knife.column(column);
    for (std::size_t k = 0; k < edge.size(); ++k) {
      ASSERT_EQ(edge.statuses()[k], RowStatus::kOk) << k;
      EXPECT_NEAR(one[k], other[k], 1e-9 * (1 + std::abs(other[k]))) << column << ' ' << k;
    }
  }
  EXPECT_TRUE(edge.good());
}

// The disc has the radius 5, and the face ends 2 beside the middle: where the disc's centre is 7 beside the
// middle, at cos θ = 0.7, the edge is beside the disc and loses it.
TEST(EndsOfFaces, AreLeftWhereTheCurveOfTheOtherBodyPassesBesideThem) {
  const NarrowTappet tappet{5, 10, 2};
  const double slip = std::acos(0.7) / kDegree;
  const double off = std::acos(0.2) / kDegree;  // the contact leaves the face
  // Of 36,001 rows some are less than 0.01° from where the edge is touched again.
  for (const int samples : {7, 61, 601, 36001}) {
    const Motion motion = motion_of(model_of(tappet.profile()), samples);
    const auto ends = events_of(motion, EventType::kEnd);
    EXPECT_TRUE(events_of(motion, EventType::kLimitPosition).empty());
    expect_events(
        ends, {180 - off, 180 - slip, 180 + slip, 180 + off, 360 - off, 360 - slip, 360 + slip, 360 + off},
        1e-9);
    EXPECT_TRUE(contains(ends[1].cause, "slips off the edge at the end of the curve of follower here"));
    const auto driver = motion.column("driver");
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const double c = std::abs(std::cos(driver[k] * kDegree));
      if (std::abs(c - 0.7) > 1e-6) {
        ASSERT_EQ(motion.statuses()[k] == RowStatus::kOk, c < 0.7) << driver[k];
      }
    }
  }
}

TEST(EndsOfFaces, AreWhereAContactThatMayPartDoesSoInTheEnd) {
  const NarrowTappet tappet{5, 10, 2};
  const double slip = std::acos(0.7) / kDegree;
  for (const int samples : {7, 61, 601}) {
    const Motion motion = motion_of(model_of(tappet.profile("keep = \"gap\"")), samples);
    const auto released = events_of(motion, EventType::kRelease);
    ASSERT_GE(released.size(), 1U);
    EXPECT_NEAR(released[0].driver, 180 - slip, 1e-9) << samples;
    EXPECT_TRUE(contains(released[0].cause, "slips off the edge at the end of a curve"));
    // The edge then rests at the height of the disc's centre; going down the disc never comes back to it.
    const double rest = 10 * std::sin(slip * kDegree);
    const auto driver = motion.column("driver");
    const auto y = motion.column("guide.position");
    for (std::size_t k = 0; k < motion.size(); ++k) {
      if (driver[k] > 181 - slip && driver[k] < 359) {
        EXPECT_NEAR(y[k], rest, 1e-5) << driver[k];
      }
    }
  }
}

// Greatest height of the cam of profiles/tangent_cam.toml over |x| <= w, where that is above its base circle:
// the top of its nose, or else at x = w either its nose, as far as that goes, or its flank, whose normal is
// acos 0.6 ahead of the nose.
double reach_of_tangent_cam(double turned, double w) {
  const double theta = turned < kPi / 2 ? turned : kPi - turned;
  const double x = 20 * std::cos(theta) - w;
  if (x <= 0) {
    return 20 * std::sin(theta) + 8;
  }
  const double lead = std::acos(0.6);
  if (x < 8 && kPi / 2 + std::asin(x / 8) - theta <= lead) {
    return 20 * std::sin(theta) + std::sqrt(64 - x * x);
  }
  return theta > 0.2 ? (20 - w * std::cos(lead + theta)) / std::sin(lead + theta) : 0;
}

// At 36.87° the flank lies flat on a face of 2 × 8, from the middle of the face, and extends beyond it.
TEST(EndsOfFaces, AreGoneOntoWhereAFlankComesToLieOnTheFace) {
  const Model model = shipped_model(
      "tangent_cam", {R"(bodies.follower.curves.roller={ type = "segment", from = [-8, 0], to = [8, 0] })",
                      "bodies.follower.pose.y=20"});
  const double flat = std::asin(0.6) / kDegree;
  const double off = std::acos(0.4) / kDegree;
  for (const int samples : {7, 61, 361}) {
    const Motion motion = motion_of(model, samples);
    const auto driver = motion.column("driver");
    const auto y = motion.column("follower.y");
    for (std::size_t k = 0; k < motion.size(); ++k) {
      ASSERT_EQ(motion.statuses()[k], RowStatus::kOk) << driver[k];
      const bool lifted = driver[k] > flat && driver[k] < 180 - flat;
      EXPECT_NEAR(y[k], lifted ? reach_of_tangent_cam(driver[k] * kDegree, 8) : 20, 1e-12) << driver[k];
    }
    expect_events(events_of(motion, EventType::kSecondContact), {flat, 180 - flat}, 1e-9);
    expect_events(events_of(motion, EventType::kEnd), {flat, off, 180 - off}, 1e-9);
    expect_events(events_of(motion, EventType::kRelease), {}, 0);
  }
}

TEST(EndsOfFaces, AreGoneOntoWhereTheCornerOfTheOtherBodyReachesThem) {
  // The corner (20, 0) of a triangle lifts the face by 20 sin θ, until it is 6 beside the middle. From there
  // on the end of the face slides down the side from the corner to (-10, -2).
  const Model model = model_of(profile_of(
      {R"(curves.tip = { type = "chain", spans = [{ type = "segment", from = [20, 0], to = [-10, 2] }, { type = "segment", from = [-10, 2], to = [-10, -2] }, { type = "segment", from = [-10, -2], to = [20, 0] }] })",
       "pose = { y = 20 }\ncurves.face = { type = \"segment\", from = [-6, 0], to = [6, 0] }",
       "direction = [0, 1]", "between = [\"cam.tip\", \"follower.face\"]", "start = 90\nend = 150"}));
  for (const int samples : {4, 31}) {
    const Motion motion = motion_of(model, samples);
    const auto ends = events_of(motion, EventType::kEnd);
    ASSERT_EQ(ends.size(), 1U);
    EXPECT_NEAR(ends[0].driver, 90 + std::asin(0.3) / kDegree, 1e-9);
    EXPECT_TRUE(contains(ends[0].cause, "reaches the end of the curve of follower and goes on at the edge"));
    const auto driver = motion.column("driver");
    const auto y = motion.column("follower.y");
    for (std::size_t k = 0; k < motion.size(); ++k) {
      ASSERT_EQ(motion.statuses()[k], RowStatus::kOk) << driver[k];
      const auto turn = Rotation<double>::from_angle(driver[k] * kDegree);
      const Vector2d corner = turn * Vector2d(20, 0);
      const Vector2d side = turn * Vector2d(-30, -2);
      const double down = driver[k] < ends[0].driver ? 0 : (-6 - corner.x()) / side.x() * side.y();
      EXPECT_NEAR(y[k], corner.y() + down, 1e-9) << driver[k];
    }
  }
}

// A rhombus with rounded corners under a roller that is carried by links of 26 and 20 from the point (30,
// 70). The roller reaches the cam while one of the two noses, arcs of radius 2 about points at d = 30 - 2/sin
// β from the pivot, tan β = 14/30, is upright to within the angle at which its height is 70 - √(46² - 30²).
// In between the whole outline passes clear of the roller.
TEST(TakenUpAgain, IsTheMotionOfALinkageOnAnotherPlaceOfTheCam) {
  const Model model = model_of(R"([bodies.ground]
points.O = [0, 0]
points.G = [30, 70]
[bodies.cam]
points.O = [0, 0]
[bodies.cam.curves.outline]
type = "chain"
fillet = 2
spans = [
  { type = "segment", from = [0, 30], to = [-14, 0] },
  { type = "segment", from = [-14, 0], to = [0, -30] },
  { type = "segment", from = [0, -30], to = [14, 0] },
  { type = "segment", from = [14, 0], to = [0, 30] },
]
[bodies.tappet]
pose = { y = 37.27 }
points.P = [0, 0]
curves.roller = { type = "circle", center = [0, 0], radius = 10 }
[bodies.a]
pose = { x = 0, y = 37.27, angle = 30 }
points.P = [0, 0]
points.M = [26, 0]
[bodies.b]
pose = { x = 30, y = 70, angle = -110 }
points.G = [0, 0]
points.M = [20, 0]
[joints]
pivot = { type = "revolute", between = ["ground.O", "cam.O"] }
guide = { type = "prismatic", between = ["ground.O", "tappet.P"], direction = [0, 1] }
p = { type = "revolute", between = ["tappet.P", "a.P"] }
m = { type = "revolute", between = ["a.M", "b.M"] }
g = { type = "revolute", between = ["b.G", "ground.G"] }
[contacts.touch]
between = ["cam.outline", "tappet.roller"]
[driver]
joint = "pivot"
start = 0
end = 360
velocity = "1 rad/s"
)");
  const double d = 30 - 2 / std::sin(std::atan2(14, 30));
  const double lowest = 70 - std::sqrt(46 * 46 - 30 * 30);
  const double reach = std::acos((d * d + lowest * lowest - 144) / (2 * d * lowest)) / kDegree;
  for (const int samples : {7, 61, 601}) {
    const Motion motion = motion_of(model, samples);
    const auto driver = motion.column("driver");
    const auto y = motion.column("guide.position");
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const double off = std::remainder(driver[k], 180.0);
      ASSERT_EQ(motion.statuses()[k] == RowStatus::kOk, std::abs(off) < reach) << driver[k];
      if (std::abs(off) < reach) {
        const double side = d * std::sin(off * kDegree);
        EXPECT_NEAR(y[k], d * std::cos(off * kDegree) + std::sqrt(144 - side * side), 1e-12) << driver[k];
      }
    }
    expect_events(events_of(motion, EventType::kLimitPosition),
                  {reach, 180 - reach, 180 + reach, 360 - reach}, 1e-9);
  }
}

// A lever on a cam with rounded corners: where the two touch again, an event in the new stretch before the
// first probe or row is not missed.
TEST(TakenUpAgain, IsTheMotionFromWhereItsStretchBegins) {
  const Model model = model_of(R"([units]
length = "m"
angle = "rad"
[bodies.ground]
points.O1 = [-0.882, -0.5]
points.O2 = [-1.7208, -1.3193]
[bodies.cam]
points.O = [-0.8817, -0.50414]
curves.outline = { type = "chain", fillet = 0.05338490349444513, spans = [{ type = "segment", from = [-0.4, -0.504], to = [-0.88, -0.24] }, { type = "segment", from = [-0.88, -0.24], to = [-1.3, -0.504] }, { type = "segment", from = [-1.3, -0.504], to = [-0.9, -1] }, { type = "segment", from = [-0.9, -1], to = [-0.4, -0.504] }] }
[bodies.lever]
points.O = [-1.72, -1.319]
curves.tip = { type = "ellipse", center = [-2.09, -0.697], semi_axes = [0.226, 0.12], rotation = 2.9 }
[joints]
cam_pivot = { type = "revolute", between = ["cam.O", "ground.O1"] }
lever_pivot = { type = "revolute", between = ["ground.O2", "lever.O"] }
[contacts.touch]
between = ["cam.outline", "lever.tip"]
[driver]
joint = "cam_pivot"
start = 0
end = -3.42
)");
  for (const int samples : {7, 61, 601}) {
    const Motion motion = motion_of(model, samples);
    expect_events(events_of(motion, EventType::kLimitPosition), {-1.52348222158, -3.07314293942}, 1e-10);
    const auto jumps = events_of(motion, EventType::kCurvatureJump);
    ASSERT_EQ(jumps.size(), 4U) << samples;
    EXPECT_NEAR(jumps[3].driver, -3.08576543917, 1e-10) << samples;
  }
}

// The cam of profiles/tangent_cam.toml. Its tappet rests on a seat 0.3 above the base circle and has a face
// of 15 to either side.
const char* const kStruck = R"(
[bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O = [0, 0]
[bodies.cam.curves.outline]
type = "chain"
spans = [
  { type = "arc", center = [20, 0], radius = 8, from = -53.13010235415598, to = 53.13010235415598 },
  { type = "segment", from = [24.8, 6.4], to = [12, 16] },
  { type = "arc", center = [0, 0], radius = 20, from = 53.13010235415598, to = 306.86989764584402 },
  { type = "segment", from = [12, -16], to = [24.8, -6.4] },
]
[bodies.tappet]
pose = { y = 20.3 }
points.P = [0, 0]
curves.face = { type = "segment", from = [15, 0], to = [-15, 0], material = "right" }
[joints]
pivot = { type = "revolute", between = ["ground.O", "cam.O"] }
guide = { type = "prismatic", between = ["ground.O", "tappet.P"], direction = [0, 1], from = 20.3 }
[contacts.touch]
between = ["cam.outline", "tappet.face"]
keep = "gap"
[driver]
joint = "pivot"
start = 0
end = 360
velocity = "1 rad/s"
)";

void expect_struck(const Motion& motion) {
  double low = 0.3, high = std::acos(0.75);
  for (int i = 0; i < 80; ++i) {
    const double middle = (low + high) / 2;
    (reach_of_tangent_cam(middle, 15) < 20.3 ? low : high) = middle;
  }
  const double begins = low / kDegree, face = std::acos(0.75) / kDegree;
  const auto driver = motion.column("driver");
  const auto y = motion.column("guide.position");
  for (std::size_t k = 0; k < motion.size(); ++k) {
    ASSERT_EQ(motion.statuses()[k], RowStatus::kOk) << driver[k];
    EXPECT_NEAR(y[k], std::max(20.3, reach_of_tangent_cam(driver[k] * kDegree, 15)), 1e-9) << driver[k];
  }
  const auto engaged = events_of(motion, EventType::kEngage);
  const auto released = events_of(motion, EventType::kRelease);
  const auto ends = events_of(motion, EventType::kEnd);
  expect_events(engaged, {begins}, 1e-9);
  expect_events(released, {180 - begins}, 1e-9);
  expect_events(ends, {face, 180 - face}, 1e-9);
  EXPECT_TRUE(contains(engaged[0].cause, "touch at the edge at the end of the curve of tappet; for a unit"));
  EXPECT_TRUE(contains(released[0].cause, "comes to the end of its guide"));
  EXPECT_TRUE(events_of(motion, EventType::kOverlap).empty());
}

TEST(StruckEnds, LiftATappetFromItsSeatAndLowerItAgain) {
  const Model model = model_of(kStruck);
  for (const int samples : {7, 61, 73, 601}) {
    expect_struck(motion_of(model, samples));
  }
  expect_struck(motion_of(model_of(kStruck, {"units.length=\"um\""}), 61));
}

TEST(StruckEnds, DoTheSameBackwardsAndMirrored) {
  // The cam is symmetrical: when it turns back the angles are 360° - θ.
  const Motion back = motion_of(model_of(kStruck, {"driver.start=360", "driver.end=0"}), 61);
  const Motion motion = motion_of(model_of(kStruck), 61);
  for (std::size_t k = 0; k < motion.size(); ++k) {
    EXPECT_NEAR(back.column("guide.position")[k], motion.column("guide.position")[60 - k], 1e-9) << k;
  }
  for (const EventType type : {EventType::kEngage, EventType::kRelease, EventType::kEnd}) {
    const EventType other = type == EventType::kEngage    ? EventType::kRelease
                            : type == EventType::kRelease ? EventType::kEngage
                                                          : type;
    const auto one = events_of(motion, type);
    const auto two = events_of(back, other);
    ASSERT_EQ(one.size(), two.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_NEAR(one[i].driver, two[two.size() - 1 - i].driver, 1e-9);
    }
  }
  const Motion image = motion_of(mirrored(model_of(kStruck)), 61);
  const auto engaged = events_of(image, EventType::kEngage);
  ASSERT_EQ(engaged.size(), 1U);
  EXPECT_NEAR(engaged[0].driver, -events_of(motion, EventType::kEngage)[0].driver, 1e-9);
  for (std::size_t k = 0; k < motion.size(); ++k) {
    EXPECT_NEAR(image.column("guide.position")[k], motion.column("guide.position")[k], 1e-9) << k;
  }
}

// The flank of a tooth ends where the next tooth takes over: a disc that strikes its tip penetrates it.
TEST(StruckEnds, ThatAreNoEdgesAreSaidAndDoNotMoveTheirBody) {
  const Model model = model_of(
      profile_of({R"(curves.disc = { type = "circle", center = [10, 0], radius = 20 })",
                  R"(pose = { y = 25 }
curves.flank = { type = "involute", center = [0, -6], base_radius = 10, start = 0, hand = "right", roll = [0.6, 1] })",
                  "direction = [0, 1]\nfrom = 25",
                  "between = [\"cam.disc\", \"follower.flank\"]\nkeep = \"gap\"", "start = -90\nend = 270"}));
  for (const int samples : {7, 61, 601}) {
    const Motion motion = motion_of(model, samples);
    EXPECT_FALSE(motion.good());
    for (const double y : motion.column("guide.position")) {
      EXPECT_EQ(y, 25) << samples;
    }
    const auto struck = events_of(motion, EventType::kOverlap);
    ASSERT_EQ(struck.size(), 1U);
    EXPECT_TRUE(contains(struck[0].cause, "strike each other at the end of a curve"));
    EXPECT_TRUE(contains(struck[0].cause, "cannot hold follower"));
  }
}

}  // namespace
}  // namespace higherpair::testing
