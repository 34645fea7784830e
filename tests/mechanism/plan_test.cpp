// The groups into which the plan divides known mechanisms.
#include "higherpair/mechanism/plan.hpp"

#include "analysis/mechanism_builder.hpp"
#include "higherpair/io/profile_reader.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace higherpair {
namespace {

using higherpair::testing::Builder;
using ::testing::UnorderedElementsAre;
using Settings = std::vector<std::string>;
using higherpair::testing::contains;
using higherpair::testing::lines_are;

std::string name_of(const GroupKind& kind) {
  static const std::vector<std::string> names = {"driven",  "RRR",      "RRP",  "RPR",    "slides",
                                                 "tracked", "touching", "idle", "geared", "coupled"};
  return names.at(kind.index());
}

// "kind: bodies" in the order of solution.
std::vector<std::string> groups_of(const Mechanism& mechanism) {
  std::vector<std::string> texts;
  const auto plan = make_plan(mechanism);
  if (!plan) return {plan.error()};
  for (const Group& group : plan->groups) {
    std::vector<std::string> names;
    for (const int body : group.bodies) names.push_back(mechanism.bodies[body].name);
    std::sort(names.begin(), names.end());
    std::string text = name_of(group.kind) + ":";
    for (const std::string& name : names) text += " " + name;
    texts.push_back(text);
  }
  return texts;
}

Mechanism shipped(const std::string& name, const Settings& settings = {}) {
  auto profile =
      read_profile_file(std::string(HIGHERPAIR_SOURCE_DIR "/profiles/") + name + ".toml", settings);
  if (!profile) {
    for (const Diagnostic& diagnostic : profile.error()) ADD_FAILURE() << to_string(diagnostic);
    return {};
  }
  return profile->mechanism;
}

// Wheels on an arm that turns on ground; the first one is driven relative to the arm.
TEST(Plan, TurnsAWheelByItsGearsOnceArmAndOtherWheelArePlaced) {
  const auto profile = read_profile_text(R"([bodies.ground]
points.O = [0, 0]
[bodies.arm]
points.O = [0, 0]
points.P = [40, 0]
[bodies.sun]
points.O = [0, 0]
[bodies.planet]
points.P = [40, 0]
[joints]
mesh         = { type = "gears", between = ["sun.O", "planet.P"], ratio = 1.5 }
arm_pivot    = { type = "revolute", between = ["ground.O", "arm.O"] }
sun_pivot    = { type = "revolute", between = ["arm.O", "sun.O"] }
planet_pivot = { type = "revolute", between = ["arm.P", "planet.P"] }
[drivers.arm]
joint = "arm_pivot"
[drivers.sun]
joint = "sun_pivot"
)",
                                         "wheels.toml");
  ASSERT_TRUE(profile) << to_string(profile.error().front());
  EXPECT_TRUE(lines_are(groups_of(profile->mechanism), {"driven: arm", "driven: sun", "geared: planet"}));
}

TEST(Plan, SolvesAFourBarAsADriverAndADyad) {
  EXPECT_TRUE(lines_are(groups_of(shipped("four_bar")), {"driven: crank", "RRR: coupler rocker"}));
}

TEST(Plan, FollowsTheDriverFromTheOtherSide) {
  EXPECT_TRUE(lines_are(groups_of(shipped("four_bar", {"driver.joint=rocker_pivot"})),
                        {"driven: rocker", "RRR: coupler crank"}));
}

TEST(Plan, CouplesAllBodiesOfALoopWhoseInnerJointIsDriven) {
  EXPECT_TRUE(lines_are(groups_of(shipped("double_rocker")), {"coupled: coupler left_arm right_arm"}));
}

TEST(Plan, KnowsTheGroupsOfSlidersAndSlots) {
  EXPECT_TRUE(lines_are(groups_of(shipped("slider_crank")), {"driven: crank", "RRP: piston rod"}));
  EXPECT_TRUE(lines_are(groups_of(shipped("slider_crank", {"driver={joint = \"slide\"}"})),
                        {"driven: piston", "RRR: crank rod"}));
  EXPECT_TRUE(lines_are(groups_of(shipped("scotch_yoke")), {"driven: crank", "slides: yoke"}));
  EXPECT_TRUE(lines_are(groups_of(shipped("scotch_yoke", {"driver={joint = \"slide\"}"})),
                        {"driven: yoke", "RRP: crank"}));
  EXPECT_TRUE(lines_are(groups_of(shipped("quick_return")), {"driven: crank", "RPR: lever"}));
  EXPECT_TRUE(
      lines_are(groups_of(shipped("quick_return", {"joints.slot.between=[\"crank.O\", \"lever.T\"]"})),
                {"driven: crank", "RRP: lever"}));
}

TEST(Plan, TakesTheGroupsOfASixBarOneAfterTheOther) {
  EXPECT_TRUE(lines_are(groups_of(shipped("sixbar_slider")),
                        {"driven: link2", "RRR: link3 link4", "RRP: link5 slider"}));
  EXPECT_TRUE(lines_are(groups_of(shipped("watt_sixbar")),
                        {"driven: link2", "RRR: link3 link4", "RRR: link5 link6"}));
  EXPECT_TRUE(
      lines_are(groups_of(shipped("toggle_press")), {"driven: crank", "RRR: rod upper", "RRP: lower ram"}));
  // Driven at the other end the Watt chain also consists of dyads; driven at the end of its first loop the
  // list is the same.
  EXPECT_TRUE(lines_are(groups_of(shipped("watt_sixbar", {"driver.joint=F"})),
                        {"driven: link6", "RRR: link4 link5", "RRR: link2 link3"}));
}

TEST(Plan, TracksAContactOnADriverAndPlacesOneOnAnotherBody) {
  EXPECT_TRUE(
      lines_are(groups_of(shipped("cam_chain")), {"driven: cam", "tracked: arm", "touching: second_arm"}));
}

TEST(Plan, NamesTheRollerWhoseTurningIsIdle) {
  const Mechanism mechanism = shipped("roller_body");
  const auto plan = make_plan(mechanism);
  ASSERT_TRUE(plan) << plan.error();
  ASSERT_EQ(plan->idle_bodies.size(), 1U);
  EXPECT_EQ(mechanism.bodies[plan->idle_bodies[0]].name, "roller");
  EXPECT_TRUE(lines_are(groups_of(mechanism), {"driven: cam", "coupled: arm roller"}));
  const auto rolling = make_plan(shipped("roller_body", {"contacts.touch.rolling=true"}));
  ASSERT_TRUE(rolling) << rolling.error();
  EXPECT_TRUE(rolling->idle_bodies.empty());
}

// A roller that is not round about its pin moves its arm by turning, and nothing holds it.
TEST(Plan, RefusesARollerWhoseTurningIsNotIdle) {
  const std::string curve = "bodies.roller.curves.rim";
  for (const std::string& other :
       {curve + ".center=[3, 0]", curve + "={type = \"ellipse\", center = [0, 0], semi_axes = [15, 10]}"}) {
    const auto plan = make_plan(shipped("roller_body", {other}));
    ASSERT_FALSE(plan) << other;
    EXPECT_TRUE(contains(plan.error(),
                         "more freedom than drivers: 1 freedom left by the drivers, in which "
                         "arm, roller can move"))
        << other;
    // Where it rolls its angle follows from the way that it has rolled.
    EXPECT_TRUE(make_plan(shipped("roller_body", {other, "contacts.touch.rolling=true"}))) << other;
  }
}

TEST(Plan, TakesSeveralDrivers) {
  EXPECT_THAT(groups_of(shipped("five_bar")),
              UnorderedElementsAre("driven: left_crank", "driven: right_crank", "RRR: left_link right_link"));
}

TEST(Plan, CountsConditionsInSurplus) {
  EXPECT_EQ(make_plan(shipped("four_bar"))->surplus, 0);
  Builder b;
  const int crank = b.body("crank", {0, 0}, 0.4), coupler = b.body("coupler", {0.3, 0.2}, 0),
            second = b.body("second", {1, 0}, 0.4), third = b.body("third", {0.4, 0.7}, 0.4);
  b.drive(b.revolute(0, crank, {0, 0}));
  b.revolute(crank, coupler, {0.3, 0.2});
  for (const auto& [body, x, y] : {std::tuple(second, 1.0, 0.0), std::tuple(third, 0.4, 0.7)}) {
    b.revolute(0, body, {x, y});
    b.revolute(body, coupler, {x + 0.3, y + 0.2});
  }
  const auto plan = make_plan(b.mechanism);
  ASSERT_TRUE(plan) << plan.error();
  EXPECT_EQ(plan->surplus, 1);
}

TEST(Plan, MeasuresTheLargestDistanceOfJointPointsAndCurveCenters) {
  Builder b;
  const int crank = b.body("crank", {0, 0}, 0.3), far = b.body("far", {0.1, 0.2}, 0);
  b.drive(b.revolute(0, crank, {0, 0}));
  b.revolute(crank, far, {3, 0});
  b.contact(b.circle(far, {3, 4}, 0.5), b.circle(0, {3, 5}, 0.5));
  const auto plan = make_plan(b.mechanism);
  ASSERT_TRUE(plan) << plan.error();
  EXPECT_NEAR(plan->size, std::hypot(3, 5), 1e-15 * 6);
}

TEST(Plan, MeasuresByTheCoordinatesWhereAllPointsCoincide) {
  for (const double off : {0.0, 1e-16, 1e-14, 1e-9}) {
    Builder b;
    const int slide = b.body("slide", {-0.2, 0.4}, -2.3);
    b.drive(b.prismatic(0, slide, {-0.8, -0.5}, {0.6, 0.8}, off));
    const auto plan = make_plan(b.mechanism);
    ASSERT_TRUE(plan) << plan.error();
    EXPECT_NEAR(plan->size, std::hypot(0.6, 0.9), 1e-8) << off;
  }
  Builder b;
  const int crank = b.body("crank", {0, 1e-14}, 0);
  b.drive(b.revolute(0, crank, {0, 0}));
  EXPECT_EQ(make_plan(b.mechanism)->size, 1);
}

TEST(Plan, TakesDistancesForRoundingThatAreSmallAgainstASlide) {
  Builder b;
  const int slide = b.body("slide", {0, 0}, 0);
  b.drive(b.prismatic(0, slide, {0, 0}, {1, 0}, 1e-9));
  double& travel = b.mechanism.drivers.front().travel;
  EXPECT_NEAR(size_of(b.mechanism), 1e-9, 1e-24);
  travel = 0.9e-5;
  EXPECT_NEAR(size_of(b.mechanism), 1e-9, 1e-24);
  travel = 1.1e-5;
  EXPECT_EQ(size_of(b.mechanism), 1);
  travel = 0.08;
  EXPECT_EQ(make_plan(b.mechanism)->size, 1);
}

// Without the driver the coordinates that enter would do to place what is joined twice to ground.
TEST(Plan, DoesNotPlaceAYokeByTwoParallelGuides) {
  for (const bool slot : {false, true}) {
    Builder b;
    const int crank = b.body("crank", {0, 0}, 0.3), rod = b.body("rod", {0.1, 0}, 0.2);
    const int yoke = b.body("yoke", {0, 0.4}, 0);
    b.drive(b.revolute(0, crank, {0, 0}));
    b.revolute(crank, rod, {0.1, 0});
    b.revolute(rod, yoke, {0, 0.4});
    b.prismatic(0, yoke, {0, 0.4}, {0, 1}, 0);
    slot ? b.slot(0, yoke, {0.3, 0.4}, {0, -1}, 0) : b.prismatic(0, yoke, {0.3, 0.4}, {0, -1}, 0);
    EXPECT_TRUE(lines_are(groups_of(b.mechanism), {"driven: crank", "coupled: rod yoke"}));
    EXPECT_EQ(make_plan(b.mechanism)->surplus, slot ? 1 : 2);
  }
}

TEST(Plan, DoesNotPlaceThreeParallelCranksOnTheirOwn) {
  Builder b;
  const int crank = b.body("crank", {-3, 0}, 0.3), rod = b.body("rod", {-2.5, 0}, 0.2);
  std::vector<int> cranks;
  for (const double x : {0.0, 1.0, 3.0}) cranks.push_back(b.body(fmt::format("at{}", x), {x, 0}, 1));
  const int coupler = b.body("coupler", {0.6, 0.8}, 0);
  b.drive(b.revolute(0, crank, {-3, 0}));
  b.revolute(crank, rod, {-2.5, 0});
  for (const int index : cranks) {
    const double x = b.mechanism.bodies[index].guess_p_WB.x();
    b.revolute(0, index, {x, 0});
    b.revolute(index, coupler, {x + 0.6, 0.8});
  }
  b.revolute(rod, cranks[0], {0.6, 0.8});
  EXPECT_TRUE(lines_are(groups_of(b.mechanism),
                        {"driven: crank", "RRR: at0 rod", "RRR: at1 coupler", "coupled: at3"}));
}

TEST(Plan, SaysWhatIsLoose) {
  Builder b;
  const int crank = b.body("crank", {0, 0}, 0.3), rod = b.body("rod", {0.1, 0.2}, 0);
  b.drive(b.revolute(0, crank, {0, 0}));
  b.revolute(crank, rod, {0.3, 0});
  const auto plan = make_plan(b.mechanism);
  ASSERT_FALSE(plan);
  EXPECT_TRUE(contains(plan.error(), "2 drivers needed, 1 given"));
  EXPECT_TRUE(contains(plan.error(), "in which rod can move"));
}

}  // namespace
}  // namespace higherpair
