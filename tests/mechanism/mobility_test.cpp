#include "drawn_mechanism.hpp"
#include "higherpair/mechanism/analyse_mobility.hpp"
#include "higherpair/mechanism/mobility_text.hpp"
#include "support/texts.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::a_line_contains;
using testing::contains;
using testing::contains_all;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::lines_are;
using testing::part;

TEST(Mobility, OfAFourBarIsOneByCountAndRank) {
  const DrawnMechanism drawn = drawn_four_bar(0.071, 0.023, 0.059, 0.047);
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(formula_text(mobility.count), "M = 3 (n - j - 1) + sum f = 3 (4 - 4 - 1) + 4 = 1");
  EXPECT_EQ(rank_text(mobility), "8 conditions on 9 coordinates have rank 8: freedom 9 - 8 = 1");
  EXPECT_EQ(mobility.freedom, 1);
  EXPECT_GE(mobility.positions, 3);
  EXPECT_TRUE(mobility.drivers_fit());
  EXPECT_THAT(explanations(drawn.mechanism, mobility), IsEmpty());
}

TEST(Mobility, IsTheSameForMechanismsOfEverySize) {
  for (const double scale : {1e-6, 1e-3, 1.0, 1e6}) {
    DrawnMechanism drawn = drawn_four_bar(0.071 * scale, 0.023 * scale, 0.059 * scale, 0.047 * scale);
    const Mobility mobility = analyse_mobility(drawn.mechanism);
    EXPECT_TRUE(mobility.assembled) << scale;
    EXPECT_EQ(mobility.freedom, 1) << scale;
    EXPECT_FALSE(mobility.singular) << scale;
  }
}

TEST(Mobility, AtAChangePointIsLargerAtTheStartOnly) {
  // A parallelogram folded flat: crank and rocker lie along the ground link.
  DrawnMechanism drawn;
  const int crank = drawn.crank("crank", Vector2d::Zero());
  drawn.drive(0);
  drawn.dyad("dyad", crank, {0.031, 0}, 0, {0.083, 0}, {0.114, 0});
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.start_freedom, 2);
  EXPECT_EQ(mobility.freedom, 1);
  EXPECT_EQ(mobility.shaky, 0);
  EXPECT_TRUE(mobility.singular);
  EXPECT_TRUE(mobility.drivers_fit());
  EXPECT_TRUE(a_line_contains(explanations(drawn.mechanism, mobility), "change point"));
}

// Equal wheels in a row on fixed pivots, whose pins one rod joins, drawn with all pins on the line of the
// pivots.
TEST(Mobility, OfARedundantMechanismDrawnAtItsChangePointIsThatOfItsMotion) {
  for (const int wheels : {3, 4, 5}) {
    for (const double arm : {0.35, -0.35}) {
      DrawnMechanism drawn;
      const int rod = drawn.body("rod");
      for (int i = 0; i < wheels; ++i) {
        const Vector2d O(1.2 * i, 0);
        drawn.pin(drawn.crank("wheel" + std::to_string(i), O), rod, O + Vector2d(arm, 0));
      }
      drawn.drive(0);
      const Mobility mobility = analyse_mobility(drawn.mechanism);
      EXPECT_EQ(mobility.count.mobility(), 3 - wheels);
      EXPECT_EQ(mobility.freedom, 1) << wheels << " " << arm;
      EXPECT_EQ(mobility.start_freedom, 2);
      EXPECT_EQ(mobility.shaky, 0);
      EXPECT_EQ(mobility.conditions - mobility.rank, wheels - 2);
      EXPECT_TRUE(mobility.drivers_fit());
      ASSERT_EQ(mobility.redundancies.size(), 1U);
      EXPECT_EQ(mobility.redundancies.front().cause, RedundancyCause::kParallelCranks);
    }
  }
}

// Two cranks with two rods of equal length, drawn on the line of the pivots.
TEST(Mobility, OfTwoCranksWithTwoRodsInLineIsThatOfTheParallelMotion) {
  DrawnMechanism drawn;
  const int left = drawn.crank("left", Vector2d::Zero());
  drawn.drive(0);
  const int right = drawn.crank("right", {0.1, 0});
  for (const double arm : {0.03, 0.015}) {
    const int rod = drawn.body(arm > 0.02 ? "outer" : "inner");
    drawn.pin(left, rod, {arm, 0});
    drawn.pin(rod, right, {0.1 + arm, 0});
  }
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.freedom, 1);
  EXPECT_TRUE(mobility.singular);
  EXPECT_TRUE(mobility.drivers_fit());
}

TEST(Mobility, OfADriverAtItsDeadPointIsThatOfTheMechanism) {
  // The crank is driven where coupler and rocker are stretched: the crank cannot move, the rest may.
  DrawnMechanism drawn;
  const Vector2d A(0.04, 0.03);
  const Vector2d O4(0.1, -0.02);
  const int crank = drawn.crank("crank", Vector2d::Zero());
  drawn.drive(0);
  drawn.dyad("dyad", crank, A, 0, O4, 0.6 * A + 0.4 * O4);
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.freedom, 1);
  EXPECT_FALSE(mobility.singular);
  EXPECT_TRUE(mobility.drivers_fit());
  EXPECT_THAT(mobility.moving, IsEmpty());  // no motion has the rate of the driver
}

TEST(Mobility, OfAStructureIsNone) {
  DrawnMechanism drawn;
  drawn.dyad("truss", 0, {0, 0}, 0, {0.07, 0.01}, {0.03, 0.05});
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.count.mobility(), 0);
  EXPECT_EQ(mobility.freedom, 0);
  EXPECT_FALSE(mobility.singular);
  EXPECT_TRUE(lines_are(explanations(drawn.mechanism, mobility), {part("statically determinate")}));
}

TEST(Mobility, OfAStructureWithAMemberTooManySaysThatItIsIndeterminate) {
  DrawnMechanism drawn;
  const int link = drawn.dyad("truss", 0, {0, 0}, 0, {0.07, 0.01}, {0.03, 0.05});
  const int third = drawn.crank("third", {0.041, -0.013});
  drawn.pin(link, third, {0.03, 0.05});
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.count.mobility(), -1);
  EXPECT_EQ(mobility.freedom, 0);
  EXPECT_EQ(mobility.conditions - mobility.rank, 1);
  ASSERT_EQ(mobility.redundancies.size(), 1U);
  EXPECT_EQ(mobility.redundancies.front().cause, RedundancyCause::kMember);
  EXPECT_TRUE(a_line_contains(explanations(drawn.mechanism, mobility), "statically indeterminate"));
}

// Two struts of a plate are equal and parallel, but nothing goes round: the fourth is a member too many. So
// is the third of the rods that slide up and down with a plate, though all three are equal and parallel.
TEST(Mobility, OfParallelStrutsAndRodsIsNotTakenForThatOfCranks) {
  DrawnMechanism truss;
  const int plate = truss.body("plate");
  const auto strut = [&](const std::string& name, const Vector2d& foot, const Vector2d& head) {
    truss.pin(truss.crank(name, foot), plate, head);
  };
  strut("left", {0, 0}, {0, 0.05});
  strut("right", {0.08, 0}, {0.08, 0.05});
  strut("up", {0.01, -0.01}, {0.07, 0.05});
  strut("down", {0.09, -0.02}, {0.02, 0.06});
  DrawnMechanism press;
  const int ram = press.body("ram");
  for (const Vector2d& head : {Vector2d(0, 0), Vector2d(0.05, 0.03), Vector2d(0.09, -0.02)}) {
    const int rod = press.body("rod" + std::to_string(press.mechanism.bodies.size()));
    press.slide(0, rod, head - Vector2d(0, 0.1), {0, 1});
    press.pin(rod, ram, head);
  }
  for (const auto& [mechanism, freedom] : {std::pair(truss.mechanism, 0), std::pair(press.mechanism, 1)}) {
    const Mobility mobility = analyse_mobility(mechanism);
    EXPECT_EQ(mobility.freedom, freedom);
    ASSERT_EQ(mobility.redundancies.size(), 1U);
    EXPECT_EQ(mobility.redundancies.front().conditions, 1);
    EXPECT_EQ(mobility.redundancies.front().cause, RedundancyCause::kMember);
  }
}

// Rolling between fixed pivots removes the slip; between discs that cannot turn it removes nothing.
TEST(Mobility, OfDiscsHeldByStrutsHasBothConditionsOfTheirContactTooMany) {
  DrawnMechanism drawn;
  const int one = drawn.crank("one", {0, 0}), two = drawn.crank("two", {0.1, 0});
  drawn.touch(one, *make_circle({0, 0}, 0.04), two, *make_circle({0.1, 0}, 0.06), true);
  drawn.pin(drawn.crank("left", {-0.03, 0.07}), one, {-0.02, 0.01});
  drawn.pin(drawn.crank("right", {0.13, 0.07}), two, {0.12, 0.02});
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.freedom, 0);
  ASSERT_EQ(mobility.redundancies.size(), 1U);
  EXPECT_EQ(mobility.redundancies.front().conditions, 2);
  EXPECT_EQ(mobility.redundancies.front().cause, RedundancyCause::kMember);
}

TEST(Mobility, OfTwoLinksInLineBetweenFixedPinsIsAShakyNone) {
  DrawnMechanism drawn;
  drawn.dyad("bars", 0, {0, 0}, 0, {0.07, 0}, {0.03, 0});
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.start_freedom, 1);
  EXPECT_EQ(mobility.shaky, 1);
  EXPECT_EQ(mobility.freedom, 0);
  EXPECT_TRUE(mobility.singular);
  EXPECT_TRUE(a_line_contains(explanations(drawn.mechanism, mobility), "shaky"));
}

TEST(Mobility, OfAShakyPartOnAMovingBodyIsThatOfTheBody) {
  DrawnMechanism drawn;
  const int crank = drawn.crank("crank", Vector2d::Zero());
  drawn.drive(0);
  drawn.dyad("bars", crank, {0.02, 0.03}, crank, {0.08, 0.05}, {0.05, 0.04});
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.start_freedom, 2);
  EXPECT_EQ(mobility.freedom, 1);
  EXPECT_EQ(mobility.shaky, 1);
  EXPECT_TRUE(mobility.drivers_fit());
}

DrawnMechanism cam_with_roller() {
  DrawnMechanism drawn;
  const Vector2d M(0.06, 0.04);
  const Vector2d eccentric(0.01, 0.005);
  const int cam = drawn.crank("cam", Vector2d::Zero());
  drawn.drive(0);
  const int lever = drawn.crank("lever", {0.09, -0.01});
  const int roller = drawn.body("roller");
  drawn.pin(lever, roller, M);
  const double distance = (M - eccentric).norm();
  drawn.touch(cam, *make_circle(eccentric, 0.7 * distance), roller, *make_circle(M, 0.3 * distance));
  return drawn;
}

TEST(Mobility, NamesTheRollerThatSpinsIdly) {
  const DrawnMechanism drawn = cam_with_roller();
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.count.mobility(), 2);
  EXPECT_EQ(mobility.freedom, 2);
  EXPECT_EQ(mobility.useful(), 1);
  ASSERT_EQ(mobility.idle.size(), 1U);
  EXPECT_EQ(mobility.idle.front().body, 3);
  // Assembled positions are accurate to 1e-10 of the size.
  EXPECT_NEAR((mobility.idle.front().p_W - Vector2d(0.06, 0.04)).norm(), 0, 1e-9);
  EXPECT_TRUE(mobility.drivers_fit());
  EXPECT_TRUE(lines_are(idle_texts(drawn.mechanism, mobility), {part("roller turns freely")}));
}

TEST(Mobility, DoesNotTakeARollerOffItsCentreForIdle) {
  DrawnMechanism drawn = cam_with_roller();
  drawn.mechanism.bodies[3].curves.front().curve.vertex_B += Vector2d(0.002, 0);
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.freedom, 2);
  EXPECT_THAT(mobility.idle, IsEmpty());
  EXPECT_EQ(mobility.missing_drivers, 1);
}

TEST(Mobility, CountsAPinOfThreeBodiesTwice) {
  // A five-bar whose two links and a rocker meet in one pin.
  DrawnMechanism drawn;
  const int crank = drawn.crank("crank", Vector2d::Zero());
  drawn.drive(0);
  const Vector2d C(0.06, 0.05);
  const int link = drawn.dyad("dyad", crank, {0.01, 0.03}, 0, {0.09, 0}, C);
  const int slider = drawn.body("slider");
  const int rod = drawn.body("rod");
  drawn.pin(link, rod, C);
  drawn.pin(rod, slider, {0.13, 0.02});
  drawn.slide(0, slider, {0.13, 0.02}, {1, 0.2});
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.count.revolutes, 6);
  EXPECT_EQ(mobility.count.mobility(), 1);
  EXPECT_EQ(mobility.freedom, 1);
}

TEST(Mobility, FindsTheJointThatHoldsAPinOnceMore) {
  DrawnMechanism drawn = drawn_four_bar(0.071, 0.023, 0.059, 0.047);
  drawn.mechanism.joints.push_back(drawn.mechanism.joints.back());
  drawn.mechanism.joints.back().name = "again";
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.count.mobility(), -1);
  EXPECT_EQ(mobility.freedom, 1);
  ASSERT_EQ(mobility.redundancies.size(), 1U);
  EXPECT_EQ(mobility.redundancies.front().cause, RedundancyCause::kSamePin);
  EXPECT_EQ(mobility.redundancies.front().conditions, 2);
}

TEST(Mobility, OfALoopOfSlidesAloneIsOneMoreThanTheCount) {
  DrawnMechanism drawn;
  const int wedge = drawn.body("wedge");
  const int plunger = drawn.body("plunger");
  const int driven = drawn.slide(0, wedge, {0, 0}, {1, 0});
  drawn.slide(wedge, plunger, {0.05, 0.02}, {1, 0.3});
  drawn.slide(0, plunger, {0.05, 0.06}, {0, 1});
  drawn.drive(driven);
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.count.mobility(), 0);
  EXPECT_EQ(mobility.freedom, 1);
  ASSERT_EQ(mobility.redundancies.size(), 1U);
  EXPECT_EQ(mobility.redundancies.front().cause, RedundancyCause::kSlidesAlone);
}

TEST(Mobility, OfEllipsesThatRollAboutTheirFociIsOne) {
  // Two equal ellipses with semi-axes a = 50, b = 40 mm, pivoted at foci 2a apart.
  const double a = 0.05;
  const double b = 0.04;
  const double c = 0.03;
  for (const bool foci : {true, false}) {
    SCOPED_TRACE(foci ? "about their foci" : "about their centres");
    DrawnMechanism drawn;
    const Vector2d O2(2 * a, 0);
    const int one = drawn.crank("one", Vector2d::Zero());
    const int two = drawn.crank("two", O2);
    const Vector2d shift(foci ? c : 0, 0);
    drawn.touch(one, *make_ellipse(-shift, {a, b}, 0), two, *make_ellipse(O2 - shift, {a, b}, 0), true);
    const Mobility mobility = analyse_mobility(drawn.mechanism);
    EXPECT_TRUE(mobility.assembled);
    EXPECT_EQ(mobility.count.mobility(), 0);
    // About their centres they touch on the line of pivots only in the drawn position.
    EXPECT_EQ(mobility.freedom, foci ? 1 : 0);
    EXPECT_EQ(mobility.start_freedom, 1);
  }
}

TEST(DriverObjection, SaysWhatToAddToAFiveBarWithOneDriver) {
  DrawnMechanism drawn;
  const int crank = drawn.crank("crank", Vector2d::Zero());
  const int second = drawn.crank("second", {0.09, 0.01});
  drawn.drive(0);
  drawn.dyad("dyad", crank, {0.01, 0.04}, second, {0.1, 0.05}, {0.05, 0.09});
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.freedom, 2);
  EXPECT_EQ(mobility.missing_drivers, 1);
  EXPECT_THAT(mobility.loose_bodies, ElementsAre(2, 3, 4));
  EXPECT_THAT(mobility.joints_to_drive, ElementsAre(1, 2, 3, 4));
  EXPECT_TRUE(contains_all(
      driver_objection(drawn.mechanism, mobility).value_or(""),
      {"2 freedoms by rank", "2 drivers needed, 1 given", "add 1 driver", "pin1, pin2, pin3, pin4"}));
  drawn.drive(1, "other");
  EXPECT_EQ(driver_objection(drawn.mechanism, std::vector<double>{0, 0}), std::nullopt);
}

TEST(DriverObjection, NamesTheDriverThatIsTooMany) {
  DrawnMechanism drawn = drawn_four_bar(0.071, 0.023, 0.059, 0.047);
  drawn.drive(2, "rocker");
  EXPECT_TRUE(contains_all(driver_objection(drawn.mechanism, analyse_mobility(drawn.mechanism)).value_or(""),
                           {"1 driver needed, 2 given", "remove drivers.rocker (of pin2)"}));
}

TEST(DriverObjection, SaysThatAStructureCannotBeDriven) {
  DrawnMechanism drawn;
  drawn.dyad("truss", 0, {0, 0}, 0, {0.07, 0.01}, {0.03, 0.05});
  drawn.drive(0);
  EXPECT_TRUE(contains_all(driver_objection(drawn.mechanism, std::vector<double>{0}).value_or(""),
                           {"0 drivers needed, 1 given", "nothing can move"}));
}

TEST(SurplusObjection, IsThereForADriverTooManyAndNotForAMemberThatFits) {
  DrawnMechanism drawn = drawn_four_bar(0.071, 0.023, 0.059, 0.047);
  drawn.drive(2, "rocker");
  const auto plan = make_plan(drawn.mechanism);
  ASSERT_TRUE(plan) << plan.error();
  EXPECT_EQ(plan->surplus, 1);
  EXPECT_TRUE(contains(surplus_objection(drawn.mechanism, *plan, {0, 0}).value_or(""), "2 given"));
  drawn.mechanism.drivers.pop_back();
  drawn.mechanism.joints.push_back(drawn.mechanism.joints.back());
  const auto fitting = make_plan(drawn.mechanism);
  ASSERT_TRUE(fitting) << fitting.error();
  EXPECT_EQ(fitting->surplus, 2);
  EXPECT_EQ(surplus_objection(drawn.mechanism, *fitting, {0}), std::nullopt);
}

TEST(Plan, RefusesLooseBodiesInTheSameWords) {
  DrawnMechanism drawn = drawn_four_bar(0.071, 0.023, 0.059, 0.047);
  drawn.mechanism.drivers.clear();
  const auto plan = make_plan(drawn.mechanism);
  ASSERT_FALSE(plan);
  EXPECT_TRUE(contains_all(plan.error(), {"1 driver needed, 0 given", "crank, dyad_a, dyad_b"}));
}

TEST(Mobility, IsCountedOnlyWhereTheMechanismDoesNotClose) {
  DrawnMechanism drawn = drawn_four_bar(0.071, 0.023, 0.059, 0.047);
  // The rocker's ground pin is far away.
  drawn.mechanism.bodies.front().points.back().p_B = {1.5, 0};
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_FALSE(mobility.assembled);
  EXPECT_EQ(mobility.count.mobility(), 1);
}

TEST(Mobility, HoldsTheDriversAtTheStartWhereItCan) {
  const DrawnMechanism drawn = drawn_four_bar(0.071, 0.023, 0.059, 0.047);
  const Mobility turned = analyse_mobility(drawn.mechanism, {{0.4}, {}, std::nullopt});
  EXPECT_TRUE(turned.drivers_held);
  EXPECT_NEAR(turned.start[1].theta, 0.4, 1e-9);
  ASSERT_FALSE(turned.moving.empty());
  EXPECT_NEAR(turned.moving[1].omega, 1, 1e-9);
}

}  // namespace
}  // namespace higherpair
