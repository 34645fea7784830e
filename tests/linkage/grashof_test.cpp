#include "higherpair/linkage/grashof.hpp"

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

TEST(Transmission, IsTheAngleBetweenCouplerAndRocker) {
  Random random(42);
  Worst worst;
  for (int i = 0; i < 5000; ++i) {
    const FourBar linkage{random.between(0.2, 3), random.between(0.2, 3), random.between(0.2, 3),
                          random.between(0.2, 3), random.angle()};
    const double theta2 = random.angle();
    const FourBarMotion motion = four_bar_by_crank(linkage, {theta2, 1, 0}, AssemblyMode::kPlus);
    const std::optional<double> angle = transmission_angle(linkage, theta2);
    ASSERT_EQ(angle.has_value(), motion.status != LinkageStatus::kNotAssemblable);
    if (!angle) continue;
    const double between = std::abs(std::remainder(motion.theta3 - motion.theta4, kPi));
    worst.see(std::abs(*angle - between));
    const auto range = transmission_range(linkage);
    ASSERT_TRUE(range);
    EXPECT_TRUE(*angle >= range->smallest - 1e-14 && *angle <= range->largest + 1e-14);
  }
  EXPECT_AT_MOST(worst.value(), 4e-14);
}

TEST(Transmission, ExtremesOfACrankRockerAreWithTheCrankInLineWithTheFrame) {
  // 7, 2, 6, 5: diagonals 5 and 9; cosines of the angle between 6 and 5 are 36/60 and -20/60.
  const auto range = transmission_range({7, 2, 6, 5, 0.7});
  ASSERT_TRUE(range);
  EXPECT_AT_MOST(std::abs(range->smallest - std::acos(0.6)), 1e-15);
  EXPECT_AT_MOST(std::abs(range->largest - kPi / 2), 1e-15);
  // 7, 1, 6, 3: diagonals 6 and 8; cosines 9/36 and -19/36, on both sides of 90°.
  EXPECT_AT_MOST(std::abs(transmission_range({7, 1, 6, 3, 0})->smallest - std::acos(19.0 / 36)), 1e-15);
  // 4, 1, 5.5, 4: diagonals 3 and 5; cosines 37.25/44 and 21.25/44, both acute.
  const auto acute = transmission_range({4, 1, 5.5, 4, 0});
  EXPECT_AT_MOST(std::abs(acute->smallest - std::acos(37.25 / 44)), 1e-15);
  EXPECT_AT_MOST(std::abs(acute->largest - std::acos(21.25 / 44)), 1e-15);
  EXPECT_FALSE(transmission_range({7, 1, 2, 3, 0}));
  // A triple rocker reaches its dead points.
  EXPECT_EQ(transmission_range({7, 4, 5, 3, 0})->smallest, 0);
}

}  // namespace
}  // namespace higherpair
