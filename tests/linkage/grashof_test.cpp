#include "higherpair/linkage/grashof.hpp"

#include "linkage/four_bar_motion.hpp"
#include "linkage/linkage_testing.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

TEST(Grashof, NamesEachInversionByItsShortestLink) {
  EXPECT_EQ(classify_grashof({7, 2, 6, 5, 0}), GrashofClass::kCrankRocker);
  EXPECT_EQ(classify_grashof({2, 7, 5, 6, 0}), GrashofClass::kDoubleCrank);
  EXPECT_EQ(classify_grashof({7, 6, 2, 5, 0}), GrashofClass::kDoubleRocker);
  EXPECT_EQ(classify_grashof({7, 6, 5, 2, 0}), GrashofClass::kRockerCrank);
  EXPECT_EQ(classify_grashof({7, 4, 5, 3, 0}), GrashofClass::kTripleRocker);
  EXPECT_EQ(classify_grashof({7, 4, 5, 2, 0}), GrashofClass::kChangePoint);
  EXPECT_EQ(classify_grashof({0.4, 0.1, 0.3, 0.2, 0}), GrashofClass::kChangePoint);
  EXPECT_EQ(classify_grashof({3.1, 1.7, 3.1, 1.7, 0}), GrashofClass::kChangePoint);
  EXPECT_EQ(classify_grashof({7, 1, 2, 3, 0}), GrashofClass::kCannotClose);
  EXPECT_EQ(name_of(GrashofClass::kCrankRocker), "crank-rocker");
}

TEST(Grashof, ReproducesTheTextbookLengthsOfLink3) {
  // Crank 30, frame 100, rocker 60: a crank-rocker for coupler lengths strictly between the two bounds.
  const auto data = textbook("grashof_003");
  const double low = number(data["x_min"]), high = number(data["x_max"]);
  EXPECT_EQ(high - low, number(data["difference"]));
  const auto class_at = [&](double coupler) {
    return classify_grashof({number(data["frame"]), number(data["s"]), coupler, number(data["rocker"]), 0});
  };
  EXPECT_EQ(class_at(low), GrashofClass::kChangePoint);
  EXPECT_EQ(class_at(low + 1e-9), GrashofClass::kCrankRocker);
  EXPECT_EQ(class_at(high - 1e-9), GrashofClass::kCrankRocker);
  EXPECT_EQ(class_at(high), GrashofClass::kChangePoint);
  EXPECT_EQ(class_at(low - 1e-9), GrashofClass::kTripleRocker);
  EXPECT_EQ(class_at(high + 1e-9), GrashofClass::kTripleRocker);
}

TEST(Grashof, ReproducesTheTextbookExerciseOnADoubleRocker) {
  const auto data = textbook("exercise3_000");
  const double coupler = number(data["coupler_2a"]), frame = number(data["frame_2d"]);
  const double arm = number(data["arm"]), shortest_arm = number(data["limits"]["c_min"]);
  EXPECT_EQ(classify_grashof({frame, arm, coupler, arm, 0}), GrashofClass::kDoubleRocker);
  EXPECT_EQ(classify_grashof({frame, shortest_arm, coupler, shortest_arm, 0}), GrashofClass::kChangePoint);
}

TEST(Grashof, ReproducesTheTextbookMarginOfACouplerThatTurnsFully) {
  const auto data = textbook("exercise3_000");
  const double coupler = number(data["coupler_2a"]), frame = number(data["frame_2d"]);
  const double arm = number(data["arm"]), shortest_arm = number(data["limits"]["c_min"]);
  EXPECT_EQ(grashof_margin({frame, arm, coupler, arm, 0}), number(data["limits"]["margin"]));
  EXPECT_TRUE(turns_fully({frame, arm, coupler, arm, 0}, FourBarLink::kCoupler));
  EXPECT_FALSE(turns_fully({frame, arm, coupler, arm, 0}, FourBarLink::kCrank));
  EXPECT_EQ(grashof_margin({frame, shortest_arm, coupler, shortest_arm, 0}), 0);
  EXPECT_FALSE(turns_fully({frame, shortest_arm, coupler, shortest_arm, 0}, FourBarLink::kCoupler));
}

TEST(Grashof, ALinkTurnsFullyIfItsRangeIsAFullTurn) {
  Random random(43);
  int full = 0;
  for (int i = 0; i < 5000; ++i) {
    const FourBar linkage{random.between(0.2, 3), random.between(0.2, 3), random.between(0.2, 3),
                          random.between(0.2, 3), 0.4};
    const FourBar from_O4{linkage.r1, linkage.r4, linkage.r3, linkage.r2, 0.4 + kPi};
    const auto is_full = [&](const DriverRange& range) { return range.reach == DriverReach::kFullTurn; };
    EXPECT_EQ(turns_fully(linkage, FourBarLink::kCrank), is_full(four_bar_crank_range(linkage)));
    EXPECT_EQ(turns_fully(linkage, FourBarLink::kCoupler), is_full(four_bar_coupler_range(linkage)));
    EXPECT_EQ(turns_fully(linkage, FourBarLink::kRocker), is_full(four_bar_crank_range(from_O4)));
    full += turns_fully(linkage, FourBarLink::kRocker) ? 1 : 0;
  }
  EXPECT_GT(full, 500);
}

TEST(Grashof, LengthsThatBalanceInDecimalsAreChangePoints) {
  // 0.3, 0.7, 1.1: decimal numbers whose sums are not exact in binary.
  for (const double coupler : {0.1, 0.7, 1.5, 2.1}) {
    EXPECT_EQ(classify_grashof({0.7, 0.3, coupler, 1.1, 0}), GrashofClass::kChangePoint) << coupler;
    EXPECT_NE(classify_grashof({0.7, 0.3, coupler + 1e-13, 1.1, 0}), GrashofClass::kChangePoint);
  }
}

TEST(Grashof, AgreesWithTheRangesOfCrankAndCoupler) {
  Random random(41);
  for (int i = 0; i < 20000; ++i) {
    const FourBar linkage{random.between(0.2, 3), random.between(0.2, 3), random.between(0.2, 3),
                          random.between(0.2, 3), 0};
    const bool crank = four_bar_crank_range(linkage).reach == DriverReach::kFullTurn;
    const bool coupler = four_bar_coupler_range(linkage).reach == DriverReach::kFullTurn;
    switch (classify_grashof(linkage)) {
      case GrashofClass::kCrankRocker:
        EXPECT_TRUE(crank && !coupler);
        break;
      case GrashofClass::kDoubleCrank:
        EXPECT_TRUE(crank && coupler);
        break;
      case GrashofClass::kDoubleRocker:
        EXPECT_TRUE(!crank && coupler);
        break;
      case GrashofClass::kRockerCrank:
      case GrashofClass::kTripleRocker:
        EXPECT_TRUE(!crank && !coupler);
        break;
      case GrashofClass::kCannotClose:
        EXPECT_EQ(four_bar_crank_range(linkage).reach, DriverReach::kNever);
        break;
      case GrashofClass::kChangePoint:
        ADD_FAILURE() << "unlikely among random lengths";
    }
  }
}

// The angle between the lines of coupler and rocker; none where the linkage cannot be assembled.
std::optional<double> transmission_angle(const FourBar& linkage, double theta2) {
  const FourBarMotion motion = four_bar_by_crank(linkage, {theta2, 1, 0}, AssemblyMode::kPlus);
  if (motion.status == LinkageStatus::kNotAssemblable) return std::nullopt;
  return std::abs(std::remainder(motion.theta3 - motion.theta4, kPi));
}

TEST(Transmission, NoAngleOfTheCrankLeavesItsRange) {
  Random random(42);
  for (int i = 0; i < 5000; ++i) {
    const FourBar linkage{random.between(0.2, 3), random.between(0.2, 3), random.between(0.2, 3),
                          random.between(0.2, 3), random.angle()};
    const std::optional<double> angle = transmission_angle(linkage, random.angle());
    if (!angle) continue;
    const auto range = transmission_range(linkage);
    ASSERT_TRUE(range);
    EXPECT_TRUE(*angle >= range->smallest - 4e-14 && *angle <= range->largest + 4e-14);
  }
}

TEST(Transmission, ExtremesAreAtTheCrankAnglesTheyNameOnBothSidesOfTheFrame) {
  Random random(45);
  for (int i = 0; i < 3000; ++i) {
    const FourBar linkage{random.between(0.2, 3), random.between(0.2, 3), random.between(0.2, 3),
                          random.between(0.2, 3), random.angle()};
    const auto range = transmission_range(linkage);
    if (!range) continue;
    // Near 0 the angle behaves like the square root of the distance from the limit, which is known to 1e-15.
    const double tolerance = range->smallest > 0.01 ? 1e-12 : 3e-7;
    for (const double side : {1.0, -1.0}) {
      const auto mirrored = [&](double theta2) { return linkage.theta1 + side * (theta2 - linkage.theta1); };
      EXPECT_AT_MOST(
          std::abs(transmission_angle(linkage, mirrored(range->at_smallest)).value() - range->smallest),
          tolerance);
      EXPECT_AT_MOST(
          std::abs(transmission_angle(linkage, mirrored(range->at_largest)).value() - range->largest),
          tolerance);
    }
  }
}

TEST(Transmission, ExtremesOfACrankRockerAreWithTheCrankInLineWithTheFrame) {
  // 7, 2, 6, 5: diagonals 5 and 9; cosines of the angle between 6 and 5 are 36/60 and -20/60.
  const auto range = transmission_range({7, 2, 6, 5, 0.7});
  ASSERT_TRUE(range);
  EXPECT_AT_MOST(std::abs(range->smallest - std::acos(0.6)), 1e-15);
  EXPECT_AT_MOST(std::abs(range->largest - kPi / 2), 1e-15);
  EXPECT_AT_MOST(angle_error(range->at_smallest, 0.7), 1e-15);
  // A right angle between 6 and 5: 61 = 49 + 4 - 28 cos ψ.
  EXPECT_AT_MOST(angle_error(range->at_largest, 0.7 + std::acos(-8.0 / 28)), 1e-15);
  // 7, 1, 6, 3: diagonals 6 and 8; cosines 9/36 and -19/36, on both sides of 90°.
  EXPECT_AT_MOST(std::abs(transmission_range({7, 1, 6, 3, 0})->smallest - std::acos(19.0 / 36)), 1e-15);
  // 4, 1, 5.5, 4: diagonals 3 and 5; cosines 37.25/44 and 21.25/44, both acute.
  const auto acute = transmission_range({4, 1, 5.5, 4, 0});
  EXPECT_AT_MOST(std::abs(acute->smallest - std::acos(37.25 / 44)), 1e-15);
  EXPECT_AT_MOST(std::abs(acute->largest - std::acos(21.25 / 44)), 1e-15);
  EXPECT_FALSE(transmission_range({7, 1, 2, 3, 0}));
  // A triple rocker reaches its dead points, where the transmission angle is 0.
  EXPECT_EQ(transmission_range({7, 4, 5, 3, 0})->smallest, 0);
}

}  // namespace
}  // namespace higherpair
