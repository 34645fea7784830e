#include "higherpair/mechanism/loops.hpp"

#include "drawn_mechanism.hpp"
#include "higherpair/mechanism/pins.hpp"
#include "higherpair/mechanism/plan_text.hpp"
#include "support/texts.hpp"

#include <utility>

#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(FourBars, AreFoundWithTheirLengths) {
  const auto found = find_four_bars(drawn_four_bar(0.071, 0.023, 0.059, 0.047).mechanism);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].ground, 0);
  EXPECT_EQ(found[0].crank, 1);
  EXPECT_EQ(found[0].coupler, 2);
  EXPECT_EQ(found[0].rocker, 3);
  // To within the rounding of the drawing.
  EXPECT_NEAR(found[0].linkage.r1, 0.071, 1e-16);
  EXPECT_NEAR(found[0].linkage.r2, 0.023, 1e-16);
  EXPECT_NEAR(found[0].linkage.r3, 0.059, 1e-15);
  EXPECT_NEAR(found[0].linkage.r4, 0.047, 1e-15);
}

TEST(FourBars, AreSeenFromTheDriver) {
  DrawnMechanism drawn = drawn_four_bar(0.071, 0.023, 0.059, 0.047);
  drawn.mechanism.drivers.front().joint = 2;
  const auto found = find_four_bars(drawn.mechanism);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].crank, 3);
  EXPECT_NEAR(found[0].linkage.r2, 0.047, 1e-15);
}

// The link at the driven pin, whatever the order of the bodies.
TEST(FourBars, DrivenAtAPinOfTheCouplerAreSeenFromThere) {
  for (const auto& [r2, r4] : {std::pair(0.023, 0.047), std::pair(0.047, 0.023)}) {
    DrawnMechanism drawn = drawn_four_bar(0.071, r2, 0.059, r4);
    for (std::size_t j = 0; j < drawn.mechanism.joints.size(); ++j) {
      const Joint& joint = drawn.mechanism.joints[j];
      if (joint.first.body == 0 || joint.second.body == 0) continue;
      const bool at_crank = joint.first.body == 1 || joint.second.body == 1;
      drawn.mechanism.drivers.front().joint = static_cast<int>(j);
      const auto found = find_four_bars(drawn.mechanism);
      ASSERT_EQ(found.size(), 1U);
      EXPECT_EQ(found[0].crank, at_crank ? 1 : 3);
      EXPECT_NEAR(found[0].linkage.r2, at_crank ? r2 : r4, 1e-15);
    }
  }
}

// Both links on ground are as far from the driver: the shorter one is the crank.
TEST(FourBars, DrivenInTheMiddleOfTheCouplerAreSeenFromTheShorterLink) {
  for (const auto& [r2, r4] : {std::pair(0.023, 0.047), std::pair(0.047, 0.023)}) {
    DrawnMechanism drawn = drawn_four_bar(0.071, r2, 0.059, r4);
    drawn.mechanism.drivers.clear();
    const int wheel = drawn.crank("wheel", {0.03, 0.12});
    drawn.drive(static_cast<int>(drawn.mechanism.joints.size()) - 1);
    const int rod = drawn.body("rod");
    drawn.pin(wheel, rod, {0.04, 0.13});
    drawn.pin(rod, 2, {0.03, 0.05});
    const auto found = find_four_bars(drawn.mechanism);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].linkage.r2, 0.023, 1e-15);
    EXPECT_NEAR(found[0].linkage.r4, 0.047, 1e-15);
  }
}

TEST(FourBars, AreFoundAlsoOnAMovingBody) {
  DrawnMechanism drawn = drawn_four_bar(0.071, 0.023, 0.059, 0.047);
  const int arm = drawn.body("arm");
  drawn.pin(2, arm, {0.05, 0.11});
  drawn.dyad("upper", 3, {0.08, 0.03}, arm, {0.07, 0.12}, {0.11, 0.09});
  const auto found = find_four_bars(drawn.mechanism);
  // crank, coupler, rocker, ground; coupler and rocker with the upper three bodies would be a loop of five.
  ASSERT_EQ(found.size(), 1U);
  drawn.pin(2, 5, {0.03, 0.08});
  const auto more = find_four_bars(drawn.mechanism);
  ASSERT_EQ(more.size(), 2U);
  EXPECT_THAT((std::vector<int>{more[1].ground, more[1].coupler}), ::testing::Each(::testing::Ne(0)));
}

TEST(FourBars, AreFoundThroughAPinOfThreeBodiesWhicheverJointsHoldIt) {
  // Coupler and rocker are both pinned to a third link, not to each other.
  DrawnMechanism drawn;
  const Vector2d C(0.05, 0.06);
  const int crank = drawn.crank("crank", Vector2d::Zero());
  const int rocker = drawn.crank("rocker", {0.08, 0.01});
  const int coupler = drawn.body("coupler");
  const int rod = drawn.body("rod");
  drawn.pin(crank, coupler, {0.01, 0.02});
  drawn.pin(coupler, rod, C);
  drawn.pin(rocker, rod, C);
  EXPECT_EQ(find_four_bars(drawn.mechanism).size(), 1U);
  const auto pins = find_pins(drawn.mechanism);
  ASSERT_EQ(pins.size(), 4U);
  EXPECT_EQ(pins[3].ends.size(), 3U);
  EXPECT_THAT(pins[3].joints, ElementsAre(3, 4));
}

TEST(Pins, AreOneWhereALaterJointHasAPointOfEach) {
  DrawnMechanism drawn;
  const Vector2d C(0.05, 0.06);
  for (const char* name : {"one", "two", "three", "four"}) {
    drawn.body(name);
  }
  drawn.pin(1, 2, C);
  drawn.pin(2, 3, {0.01, 0.02});
  drawn.pin(3, 4, C);
  ASSERT_EQ(find_pins(drawn.mechanism).size(), 3U);  // nothing holds bodies 2 and 3 together at C
  drawn.pin(4, 1, C);
  const auto pins = find_pins(drawn.mechanism);
  ASSERT_EQ(pins.size(), 2U);
  EXPECT_THAT(pins[0].joints, ElementsAre(0, 2, 3));
  std::vector<int> bodies;
  for (const BodyPoint& end : pins[0].ends) bodies.push_back(end.body);
  EXPECT_THAT(bodies, ElementsAre(1, 2, 3, 4));
}

TEST(SliderCranks, AreFoundWithTheSignOfTheOffset) {
  for (const bool guide_first : {true, false}) {
    DrawnMechanism drawn;
    const Vector2d C(0.09, 0.013);
    const int crank = drawn.crank("crank", Vector2d::Zero());
    const int rod = drawn.body("rod");
    const int slider = drawn.body("slider");
    drawn.pin(crank, rod, {0.018, 0.024});
    drawn.pin(rod, slider, C);
    guide_first ? drawn.slide(0, slider, C, {1, 0}) : drawn.slide(slider, 0, C, {-1, 0});
    const auto found = find_slider_cranks(drawn.mechanism);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].guide, 0);
    EXPECT_EQ(found[0].crank, crank);
    EXPECT_EQ(found[0].slider, slider);
    EXPECT_EQ(found[0].inversion, SliderCrankInversion::kGuide);
    EXPECT_NEAR(found[0].linkage.r2, 0.03, 1e-16);
    // The line is to the left of the direction of sliding.
    EXPECT_NEAR(found[0].linkage.r4, 0.013, 1e-16);
  }
}

TEST(SliderCranks, AreFoundWithASlotAndInverted) {
  DrawnMechanism drawn;
  const int crank = drawn.crank("crank", {0, 0.05});
  const int arm = drawn.crank("arm", Vector2d::Zero());
  const int block = drawn.body("block");
  drawn.pin(crank, block, {0.021, 0.07});
  drawn.slide(arm, block, {0.021, 0.07}, {0.021, 0.07});
  const auto found = find_slider_cranks(drawn.mechanism);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].guide, arm);
  EXPECT_EQ(found[0].coupler, crank);
  EXPECT_EQ(found[0].inversion, SliderCrankInversion::kCrank);
  // The line passes through the arm's pivot.
  EXPECT_NEAR(found[0].linkage.r4, 0, 1e-17);

  DrawnMechanism slotted;
  const int wheel = slotted.crank("wheel", Vector2d::Zero());
  const int rod = slotted.body("rod");
  slotted.pin(wheel, rod, {0.01, 0.02});
  slotted.slot(0, rod, {0.08, 0}, {1, 0});
  ASSERT_EQ(find_slider_cranks(slotted.mechanism).size(), 1U);
  EXPECT_EQ(find_slider_cranks(slotted.mechanism)[0].slider, -1);
  EXPECT_THAT(find_four_bars(slotted.mechanism), IsEmpty());

  // A coupler of no length is none: the crank's own pin runs in the slot.
  DrawnMechanism yoke;
  const int disc = yoke.crank("disc", Vector2d::Zero());
  const int stone = yoke.body("stone");
  yoke.pin(disc, stone, {0.01, 0.02});
  yoke.slot(0, stone, {0.01, 0.02}, {1, 0});
  EXPECT_THAT(find_slider_cranks(yoke.mechanism), IsEmpty());
}

TEST(PlanText, NamesBodiesAndWhatPlacesThem) {
  const DrawnMechanism drawn = drawn_four_bar(0.071, 0.023, 0.059, 0.047);
  const auto plan = make_plan(drawn.mechanism);
  ASSERT_TRUE(plan) << plan.error();
  ASSERT_EQ(plan->groups.size(), 2U);
  EXPECT_EQ(describe(drawn.mechanism, plan->groups[0]), "crank: driven at pin0");
  EXPECT_TRUE(contains(describe(drawn.mechanism, plan->groups[1]), "dyad_a, dyad_b: dyad RRR"));
}

}  // namespace
}  // namespace higherpair
