#include "equal_discs.hpp"
#include "linkage/slider_crank_profile.hpp"
#include "run_testing.hpp"
#include "support/texts.hpp"

#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::analyze_text;
using testing::contains;
using testing::RunTable;
using testing::Settings;

std::vector<EventType> types_of(const RunTable& motion) {
  std::vector<EventType> types;
  for (const RunEvent& event : motion.events()) types.push_back(event.type);
  return types;
}

// A disc of radius 20 with its centre 10 from the pivot just reaches the line x = 25 at 60 degrees.
constexpr const char* kKnifeAtItsLimit = R"(
[bodies.ground]
points = { O = [0, 0], Q = [25, 0] }
[bodies.cam]
points.O = [0, 0]
curves.edge = { type = "circle", center = [10, 0], radius = 20 }
[bodies.follower]
pose = { x = 25, y = 10 }
points.Q = [0, 0]
curves.tip = { type = "point", at = [0, 0] }
[joints]
pivot = { type = "revolute", between = ["ground.O", "cam.O"] }
slide = { type = "prismatic", between = ["ground.Q", "follower.Q"], direction = [0, 1] }
[contacts]
touch = { between = ["cam.edge", "follower.tip"] }
[driver]
joint = "pivot"
start = 60
end = -60
samples = 25
)";

TEST(SingularStarts, AtTheLimitOfAContactGoOnTheBranchOfThePose) {
  for (const double side : {1.0, -1.0}) {
    const RunTable motion =
        analyze_text(kKnifeAtItsLimit, {side > 0 ? "bodies.follower.pose.y=9" : "bodies.follower.pose.y=8"});
    ASSERT_EQ(motion.size(), 25U) << motion.failure();
    EXPECT_EQ(motion.status(0), RowStatus::kSingular);
    EXPECT_NEAR(motion.value(0, "slide.position"), 10 * std::sqrt(0.75), 1e-13);
    EXPECT_TRUE(std::isnan(motion.value(0, "slide.velocity")));
    for (std::size_t k = 1; k < 24; ++k) {
      const double theta = motion.radians(k, "driver");
      const double x = 25 - 10 * std::cos(theta);
      EXPECT_EQ(motion.status(k), RowStatus::kOk);
      EXPECT_NEAR(motion.value(k, "slide.position"), 10 * std::sin(theta) + side * std::sqrt(400 - x * x),
                  1e-11);
    }
  }
}

TEST(SingularStarts, AtTheLimitOfAContactCanGoOneWayOnly) {
  const RunTable motion = analyze_text(kKnifeAtItsLimit, {"driver.end=80", "driver.samples=3"});
  ASSERT_EQ(motion.size(), 3U) << motion.failure();
  EXPECT_EQ(motion.status(0), RowStatus::kSingular);
  EXPECT_EQ(motion.count(RowStatus::kNotAssemblable), 2U);
  ASSERT_EQ(motion.events().size(), 1U);
  EXPECT_EQ(motion.events()[0].type, EventType::kLimitPosition);
  EXPECT_NEAR(motion.events()[0].driver, kPi / 3, 1e-12);
}

TEST(SingularStarts, OfAContactThatIsApproachedGoOnTheSideOfThePose) {
  for (const char* approach : {"contacts.touch.approach=-", "contacts.touch.approach=nearest"}) {
    const RunTable motion = analyze_text(kKnifeAtItsLimit, {approach});
    ASSERT_EQ(motion.size(), 25U) << motion.failure();
    EXPECT_EQ(motion.status(0), RowStatus::kSingular);
    EXPECT_GT(motion.value(6, "slide.position"), 10);
  }
  EXPECT_TRUE(contains(analyze_text(kKnifeAtItsLimit, {"driver.start=90"}).failure(), "do not touch"));
}

// The arm of a roller points to the centre of a disc that turns about that centre, or both discs turn about
// their own centres: they touch whatever the driver does, and nothing determines the motion of the follower.
TEST(SingularStarts, OfContactsThatGiveNoConditionAreSingularThroughout) {
  const Settings arm{"bodies.cam.curves.edge.center.0=0", "bodies.ground.points.Q.0=45",
                     "bodies.follower.pose.x=45", "bodies.follower.pose.angle=180", "driver.samples=5"};
  const Settings concentric{"bodies.cam.curves.edge.center.0=0", "bodies.follower.curves.edge.center.0=0",
                            "bodies.follower.pose.angle=77", "driver.samples=5"};
  for (const auto& [settings, angle] : {std::pair{arm, 180.0}, std::pair{concentric, 77.0}}) {
    const RunTable motion = analyze_text(testing::kEqualDiscs, settings);
    ASSERT_EQ(motion.size(), 5U) << motion.failure();
    EXPECT_EQ(motion.count(RowStatus::kSingular), 5U);
    EXPECT_TRUE(motion.events().empty());
    for (std::size_t k = 0; k < 5; ++k) {
      EXPECT_NEAR(motion.value(k, "follower.angle"), angle, 1e-12);
      EXPECT_NEAR(motion.value(k, "touch.x"), 20, 1e-13);
      EXPECT_TRUE(std::isnan(motion.value(k, "follower.omega")));
      EXPECT_EQ(motion.value(k, "cam.alpha"), 0);
    }
  }
}

TEST(SingularStarts, OfContactsThatTheDriverOpensAreRefused) {
  // An eccentric disc and a roller that turns about its own centre touch only in isolated positions.
  const RunTable motion =
      analyze_text(testing::kEqualDiscs, {"bodies.follower.curves.edge.center.0=0", "driver.start=0",
                                          "bodies.ground.points.Q.0=45", "bodies.follower.pose.x=45"});
  EXPECT_TRUE(contains(motion.failure(), "more drivers than freedom"));
}

// Equal eccentric discs move like the cranks of a parallelogram, whose branches cross at 0 and 180 degrees.
TEST(SingularStarts, WhereContactsCrossGoStraightOn) {
  for (const std::string samples : {"2", "3", "5", "6", "9", "37", "361", "3601"}) {
    SCOPED_TRACE(samples);
    const RunTable motion =
        analyze_text(testing::kEqualDiscs,
                     {"bodies.follower.pose.angle=0", "driver.start=0", "driver.samples=" + samples});
    ASSERT_EQ(motion.failure(), "");
    EXPECT_EQ(motion.status(0), RowStatus::kSingular);
    for (std::size_t k = 0; k < motion.size(); ++k) {
      EXPECT_NEAR(motion.value(k, "follower.angle"), motion.value(k, "driver"), 1e-8);
    }
    for (const EventType type : types_of(motion)) EXPECT_EQ(type, EventType::kDeadPoint);
  }
}

// However close to a crossing a row is, it is as accurate as any other.
TEST(SingularStarts, RowsBesideACrossingOfContactsAreNotSingular) {
  const std::vector<double> beside{1e-3, 1e-4, 2e-5, 1e-5, 1e-6, 1e-7, 1e-8};
  std::vector<double> positions{170};
  for (const double delta : beside) positions.push_back(180 - delta);
  positions.push_back(180);
  for (const double delta : beside) positions.push_back(180 + delta);
  const RunTable motion = analyze_text(
      testing::kEqualDiscs,
      {"bodies.follower.pose.angle=170", fmt::format("driver.positions=[{}]", fmt::join(positions, ","))});
  ASSERT_EQ(motion.size(), positions.size()) << motion.failure();
  EXPECT_EQ(motion.count(RowStatus::kSingular), 1U);
  EXPECT_EQ(motion.status(1 + beside.size()), RowStatus::kSingular);
  EXPECT_EQ(motion.count(RowStatus::kOk), positions.size() - 1);
  for (std::size_t k = 0; k < motion.size(); ++k) {
    SCOPED_TRACE(positions[k]);
    EXPECT_NEAR(motion.value(k, "follower.angle"), positions[k], 1e-10);
    if (motion.status(k) == RowStatus::kOk) {
      EXPECT_NEAR(motion.value(k, "follower.omega") / motion.value(k, "driver.velocity"), 1, 1e-8);
      EXPECT_NEAR(motion.value(k, "follower.alpha"), 0, 1e-3);
    }
  }
  ASSERT_EQ(types_of(motion), std::vector{EventType::kDeadPoint});
  EXPECT_NEAR(motion.events()[0].driver, kPi, 1e-12);
}

// Driven by its piston, a slider-crank starts and ends at its dead centres, 120 and 60.
const std::string kDrivenPiston = testing::slider_crank_profile(30, 90) + R"([driver]
joint = "cylinder"
start = 120
end = 60
samples = 7
)";

TEST(SingularStarts, AndEndsOfAStrokeAreRowsAndTheLimitIsSaidOnce) {
  for (const Settings& settings : {Settings{}, Settings{"driver.end=50", "driver.samples=8"},
                                   Settings{"driver.start=110", "driver.end=50", "driver.samples=7"}}) {
    const RunTable motion = analyze_text(kDrivenPiston.c_str(), settings);
    ASSERT_EQ(motion.failure(), "");
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const double x = motion.value(k, "driver");
      const bool dead = x == 120 || x == 60;
      EXPECT_EQ(motion.status(k), dead     ? RowStatus::kSingular
                                  : x < 60 ? RowStatus::kNotAssemblable
                                           : RowStatus::kOk);
      if (x >= 60) {
        const double cosine = (x * x + 900 - 8100) / (60 * x);
        EXPECT_NEAR(std::abs(motion.radians(k, "main.position")), std::acos(cosine), 1e-13);
      }
    }
    ASSERT_EQ(motion.events().size(), 1U);
    EXPECT_NEAR(motion.events()[0].driver, 0.060, 1e-14);
    EXPECT_TRUE(contains(motion.events()[0].cause, "links are in line"));
  }
}

// With a rod shorter than its crank the piston has two ranges, 40 to 20 and -20 to -40.
TEST(SingularStarts, AndRowsAtBothEndsOfEachStretchAreSingular) {
  const std::string profile = testing::slider_crank_profile(30, 10) + R"([driver]
joint = "cylinder"
start = 40
end = -40
)";
  for (const int rows : {5, 9, 81}) {
    const RunTable motion = analyze_text(profile.c_str(), {fmt::format("driver.samples={}", rows)});
    ASSERT_EQ(motion.failure(), "");
    for (std::size_t k = 0; k < motion.size(); ++k) {
      SCOPED_TRACE(fmt::format("row {} of {}", k, rows));
      const double x = std::abs(motion.value(k, "driver"));
      EXPECT_EQ(motion.status(k), x == 40 || x == 20 ? RowStatus::kSingular
                                  : x < 20           ? RowStatus::kNotAssemblable
                                                     : RowStatus::kOk);
      if (x >= 20) {
        const double cosine = (x * x + 900 - 100) / (60 * motion.value(k, "driver"));
        EXPECT_NEAR(std::cos(motion.radians(k, "main.position")), cosine, 1e-13);
        if (x == 40 || x == 20) {
          EXPECT_NEAR(std::sin(motion.radians(k, "main.position")), 0, 1e-15);
        }
      }
    }
    std::vector<double> limits;
    for (const RunEvent& event : motion.events()) {
      if (event.type == EventType::kLimitPosition) limits.push_back(event.driver);
    }
    EXPECT_THAT(limits, ::testing::Pointwise(::testing::DoubleNear(1e-14), {0.020, -0.020, -0.040})) << rows;
  }
}

// Two four-bars of discs in series: the second one locks before the first, whatever the rows.
TEST(LimitPositions, OfAChainAreThoseOfTheContactThatLocksFirst) {
  constexpr const char* kChain = R"(
[bodies.ground]
points = { O1 = [0, 0], O2 = [80, 0], O3 = [80, -60] }
[bodies.a]
points.O = [0, 0]
curves.c = { type = "circle", center = [30, 0], radius = 20 }
[bodies.b]
pose = { x = 80, angle = 136 }
points.O = [0, 0]
curves.c = { type = "circle", center = [40, 0], radius = 15 }
curves.o = { type = "circle", center = [-20, 0], radius = 10 }
[bodies.c]
pose = { x = 80, y = -60, angle = 60 }
points.O = [0, 0]
curves.c = { type = "circle", center = [30, 0], radius = 10 }
[joints]
p1 = { type = "revolute", between = ["ground.O1", "a.O"] }
p2 = { type = "revolute", between = ["ground.O2", "b.O"] }
p3 = { type = "revolute", between = ["ground.O3", "c.O"] }
[contacts]
k = { between = ["a.c", "b.c"] }
l = { between = ["b.o", "c.c"] }
[driver]
joint = "p1"
end = 70
)";
  for (const char* samples : {"driver.samples=2", "driver.samples=8", "driver.samples=71"}) {
    const RunTable motion = analyze_text(kChain, {samples});
    std::vector<double> limits;
    for (const RunEvent& event : motion.events()) {
      if (event.type == EventType::kLimitPosition) limits.push_back(event.driver * 180 / kPi);
    }
    ASSERT_EQ(limits.size(), 1U) << samples;
    EXPECT_NEAR(limits[0], 62.58487431164, 1e-10);
  }
}

// A block on the line x = 20 in the slot of a crank: it runs off to infinity where line and slot are
// parallel.
TEST(LimitPositions, OfTwoSlidesAreWhereTheyAreParallel) {
  const RunTable motion = analyze_text(R"(
[bodies.ground]
points = { O = [0, 0], Q = [20, 0] }
[bodies.crank]
points.O = [0, 0]
[bodies.block]
pose = { x = 20 }
points.B = [0, 0]
[joints]
pivot = { type = "revolute", between = ["ground.O", "crank.O"] }
guide = { type = "prismatic", between = ["ground.Q", "block.B"], direction = [0, 1] }
slit  = { type = "slot", between = ["crank.O", "block.B"], direction = 0 }
[driver]
joint = "pivot"
positions = [0, 60, 90, 120]
)");
  ASSERT_EQ(motion.size(), 4U) << motion.failure();
  EXPECT_EQ(motion.status(2), RowStatus::kNotAssemblable);
  EXPECT_NEAR(motion.value(3, "guide.position"), -20 * std::sqrt(3), 1e-12);
  ASSERT_EQ(motion.events().size(), 1U);
  EXPECT_EQ(motion.events()[0].type, EventType::kLimitPosition);
  EXPECT_NEAR(motion.events()[0].driver, kPi / 2, 1e-12);
  EXPECT_TRUE(contains(motion.events()[0].cause, "slides are parallel"));
}

// The same arm on ground, with a sliding ellipse: where the arm's tip begins to reach the top, two contacts
// merge, and two others are far away. The run must not start at a far one, nor jump to it past the end of its
// own branch.
TEST(SingularStarts, TakeNoFarContactForTheOneAtItsLimit) {
  constexpr const char* kArmOnASlide = R"(
[bodies.ground]
points = { O = [0, 0], Q = [0, -10] }
[bodies.cam]
points.O = [0, 0]
curves.edge = { type = "ellipse", center = [0, 0], semi_axes = [20, 10] }
[bodies.arm]
pose = { y = -10, angle = 93 }
points.Q = [0, 0]
curves.tip = { type = "point", at = [20, 0] }
[joints]
slide = { type = "prismatic", between = ["ground.O", "cam.O"], direction = [0, 1] }
pivot = { type = "revolute", between = ["ground.Q", "arm.Q"] }
[contacts]
touch = { between = ["cam.edge", "arm.tip"] }
[driver]
joint = "slide"
start = 0
end = -4
samples = 5
)";
  const RunTable from_limit = analyze_text(kArmOnASlide);
  ASSERT_EQ(from_limit.size(), 5U) << from_limit.failure();
  EXPECT_EQ(from_limit.status(0), RowStatus::kSingular);
  EXPECT_NEAR(from_limit.value(0, "arm.angle"), 90, 1e-10);
  EXPECT_NEAR(from_limit.value(4, "arm.angle"), 180 - std::asin(0.6) * 180 / kPi, 1e-11);
  const RunTable beyond = analyze_text(
      kArmOnASlide, {"driver.start=-4", "driver.end=4", "driver.samples=9", "bodies.arm.pose.angle=120"});
  for (std::size_t k = 5; k < 9; ++k) EXPECT_EQ(beyond.status(k), RowStatus::kNotAssemblable);
}

// Where two pins of a rhombus coincide, the links on them may point in any direction, but the motion
// continues straight on.
TEST(SingularStarts, AndRowsWherePinsCoincideGoStraightOn) {
  constexpr const char* kRhombus = R"(
[bodies.ground]
points = { A = [0, 0], D = [50, 0] }
[bodies.crank]
points = { A = [0, 0], B = [50, 0] }
[bodies.coupler]
pose = { x = 50 }
points = { B = [0, 0], C = [50, 0] }
[bodies.rocker]
pose = { x = 50 }
points = { D = [0, 0], C = [50, 0] }
[joints]
a = { type = "revolute", between = ["ground.A", "crank.A"] }
b = { type = "revolute", between = ["crank.B", "coupler.B"] }
c = { type = "revolute", between = ["coupler.C", "rocker.C"] }
d = { type = "revolute", between = ["ground.D", "rocker.D"] }
[driver]
joint = "a"
start = 60
end = -60
samples = 3
)";
  const Settings placed = {"bodies.crank.pose.angle=60", "bodies.coupler.pose={x=25,y=43.3}",
                           "bodies.rocker.pose={x=50,angle=60}"};
  for (const Settings& settings : {placed, Settings{"driver.start=0", "driver.samples=4"}}) {
    for (const char* samples :
         {"driver.samples=2", "driver.samples=3", "driver.samples=7", "driver.samples=121"}) {
      Settings all = settings;
      all.emplace_back(samples);
      const RunTable motion = analyze_text(kRhombus, all);
      ASSERT_EQ(motion.failure(), "");
      for (std::size_t k = 0; k < motion.size(); ++k) {
        EXPECT_NEAR(motion.value(k, "rocker.angle"), motion.value(k, "driver"), 1e-9);
        EXPECT_NEAR(motion.value(k, "coupler.angle"), 0, 1e-9);
      }
    }
  }
}

// An arm of 20 on a cart keeps its tip on an ellipse 20 by 10 from below: at the top it cannot go lower. Near
// that limit predictions are useless.
TEST(LimitPositions, OfACarriedFollowerEndTheRunOnItsBranch) {
  constexpr const char* kArmOnACart = R"(
[bodies.ground]
points.Q = [0, -10]
curves.edge = { type = "ellipse", center = [0, 0], semi_axes = [20, 10] }
[bodies.cart]
pose = { y = -10 }
points.Q = [0, 0]
[bodies.arm]
pose = { y = -10, angle = 93 }
points.Q = [0, 0]
curves.tip = { type = "point", at = [20, 0] }
[joints]
slide = { type = "prismatic", between = ["ground.Q", "cart.Q"], direction = [0, 1] }
pivot = { type = "revolute", between = ["cart.Q", "arm.Q"] }
[contacts]
touch = { between = ["ground.edge", "arm.tip"] }
[driver]
joint = "slide"
start = 4
end = -4
samples = 9
)";
  for (const char* angle : {"bodies.arm.pose.angle=93", "bodies.arm.pose.angle=120"}) {
    const RunTable motion = analyze_text(kArmOnACart, {angle});
    ASSERT_EQ(motion.size(), 9U) << motion.failure();
    for (std::size_t k = 0; k < 4; ++k) {
      // The tip on the ellipse: (20 cos a)²/400 + (y + 20 sin a)²/100 = 1 with y = -10 + driver.
      const double a = motion.radians(k, "arm.angle");
      const double y = motion.value(k, "driver") - 10 + 20 * std::sin(a);
      EXPECT_EQ(motion.status(k), RowStatus::kOk);
      EXPECT_NEAR(std::cos(a) * std::cos(a) + y * y / 100, 1, 1e-12);
      EXPECT_GT(a, kPi / 2);
      EXPECT_LT(a, kPi);
    }
    EXPECT_EQ(motion.status(4), RowStatus::kSingular);
    EXPECT_NEAR(motion.value(4, "arm.angle"), 90, 1e-12);
    EXPECT_EQ(motion.count(RowStatus::kNotAssemblable), 4U);
    ASSERT_EQ(motion.events().size(), 1U);
    EXPECT_NEAR(motion.events()[0].driver, 0, 1e-15);
  }
}

// However a row comes to a limit, its status there is singular and it has no rates; from there the branch
// continues.
TEST(LimitPositions, OfAContactAreSingularRows) {
  const std::vector<double> positions{0, 30, 59, 60, 45, 60, 61, 60, 30, 60, 59.999};
  const RunTable motion =
      analyze_text(kKnifeAtItsLimit, {fmt::format("driver.positions=[{}]", fmt::join(positions, ","))});
  ASSERT_EQ(motion.size(), positions.size()) << motion.failure();
  for (std::size_t k = 0; k < motion.size(); ++k) {
    SCOPED_TRACE(fmt::format("row {}, {}", k, positions[k]));
    if (positions[k] > 60) {
      EXPECT_EQ(motion.status(k), RowStatus::kNotAssemblable);
      continue;
    }
    const double theta = motion.radians(k, "driver");
    const double x = 25 - 10 * std::cos(theta);
    const bool limit = positions[k] == 60;
    EXPECT_EQ(motion.status(k), limit ? RowStatus::kSingular : RowStatus::kOk);
    EXPECT_NEAR(motion.value(k, "slide.position"),
                10 * std::sin(theta) + (limit ? 0 : std::sqrt(400 - x * x)), limit ? 1e-12 : 1e-9);
    EXPECT_EQ(std::isnan(motion.value(k, "slide.velocity")), limit);
  }
  for (const RunEvent& event : motion.events()) {
    EXPECT_NEAR(event.driver, event.type == EventType::kLimitPosition ? kPi / 3 : event.driver, 1e-12);
  }
}

// The crank of a parallelogram and an unconnected pointer, each with its driver.
constexpr const char* kTwoDrivers = R"(
[bodies.ground]
points = { A = [0, 0], D = [100, 0], Z = [0, -100] }
[bodies.crank]
points = { A = [0, 0], B = [40, 0] }
[bodies.coupler]
pose = { x = 40 }
points = { B = [0, 0], C = [100, 0] }
[bodies.rocker]
pose = { x = 100 }
points = { D = [0, 0], C = [40, 0] }
[bodies.pointer]
pose = { y = -100 }
points = { Z = [0, 0], T = [10, 0] }
[joints]
a = { type = "revolute", between = ["ground.A", "crank.A"] }
b = { type = "revolute", between = ["crank.B", "coupler.B"] }
c = { type = "revolute", between = ["coupler.C", "rocker.C"] }
d = { type = "revolute", between = ["ground.D", "rocker.D"] }
z = { type = "revolute", between = ["ground.Z", "pointer.Z"] }
[drivers.crank]
joint = "a"
velocity = 100
samples = 3
[drivers.pointer]
joint = "z"
end = 30
velocity = 7
samples = 3
)";

// A belt turns the disc, so that the pair is not a driver and its follower: still a parallelogram of discs.
TEST(DeadPoints, OfContactsOnCarriedBodiesAreCrossedStraightOn) {
  constexpr const char* kDrivenByABelt = R"(
[bodies.ground]
points = { M = [0, 0], O = [100, 0], Q = [190, 0] }
[bodies.motor]
pose = { angle = 60 }
points.O = [0, 0]
[bodies.disc]
pose = { x = 100, angle = 60 }
points.O = [0, 0]
curves.c = { type = "circle", center = [30, 0], radius = 50 }
[bodies.follower]
pose = { x = 190, angle = 60 }
points.O = [0, 0]
curves.c = { type = "circle", center = [30, 0], radius = 40 }
[joints]
m = { type = "revolute", between = ["ground.M", "motor.O"] }
o = { type = "revolute", between = ["ground.O", "disc.O"] }
q = { type = "revolute", between = ["ground.Q", "follower.O"] }
belt = { type = "belt", between = ["motor.O", "disc.O"], ratio = 1 }
[contacts]
k = { between = ["disc.c", "follower.c"] }
[driver]
joint = "m"
start = 60
end = 780
)";
  for (const char* samples : {"2", "3", "5", "9", "13", "37", "361"}) {
    for (const char* start : {"driver.start=60", "driver.start=60.5"}) {
      SCOPED_TRACE(samples);
      const RunTable motion = analyze_text(kDrivenByABelt, {start, std::string("driver.samples=") + samples});
      ASSERT_EQ(motion.failure(), "");
      for (std::size_t k = 0; k < motion.size(); ++k) {
        EXPECT_NEAR(motion.value(k, "follower.angle"), motion.value(k, "driver"), 1e-7);
      }
      std::vector<double> places;
      for (const RunEvent& event : motion.events()) {
        EXPECT_EQ(event.type, EventType::kDeadPoint);
        places.push_back(event.driver);
      }
      ASSERT_EQ(places.size(), 4U);
      for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(places[i], static_cast<double>(i + 1) * kPi, 1e-7);
    }
  }
}

TEST(DeadPoints, WithTwoDriversLeaveTheirRatesToBoth) {
  for (const char* end : {"359.9", "359.9998", "360"}) {
    SCOPED_TRACE(end);
    const RunTable motion = analyze_text(kTwoDrivers, {std::string("drivers.crank.end=") + end});
    ASSERT_EQ(motion.size(), 3U) << motion.failure();
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(motion.value(k, "pointer.omega"), 7, 1e-13);
      EXPECT_NEAR(motion.value(k, "rocker.angle"), motion.value(k, "driver.crank"), 1e-10);
      if (motion.status(k) == RowStatus::kOk) {
        EXPECT_NEAR(motion.value(k, "rocker.omega"), 100, 1e-9);
      } else {
        EXPECT_TRUE(std::isnan(motion.value(k, "rocker.omega")));
      }
    }
    EXPECT_EQ(motion.status(1), std::string(end) == "360" ? RowStatus::kSingular : RowStatus::kOk);
  }
}

}  // namespace
}  // namespace higherpair
