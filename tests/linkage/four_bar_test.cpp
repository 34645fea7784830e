
#include "higherpair/geometry/pose.hpp"
#include "linkage/four_bar_motion.hpp"
#include "linkage/linkage_testing.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

/// The four-bar of the textbook chapter on four-bar position analysis.
constexpr FourBar kTextbook{1, 2, 3.5, 4, 0};

FourBar random_four_bar(Random& random) {
  return {random.between(0.2, 3), random.between(0.2, 3), random.between(0.2, 3), random.between(0.2, 3),
          random.angle()};
}

double size_of(const FourBar& linkage) {
  return std::max({linkage.r1, linkage.r2, linkage.r3, linkage.r4});
}

double closure_error(const FourBar& linkage, const FourBarMotion& motion) {
  const std::complex<double> gap =
      linkage.r2 * direction(motion.theta2) + linkage.r3 * direction(motion.theta3) -
      linkage.r1 * direction(linkage.theta1) - linkage.r4 * direction(motion.theta4);
  return std::abs(gap) / size_of(linkage);
}

/// θ4 from the angle at O4 between the diagonal and link 4, by the law of cosines in long double.
long double reference_theta4(const FourBar& linkage, double theta2, int sigma) {
  const long double delta = static_cast<long double>(theta2) - linkage.theta1;
  const long double r1 = linkage.r1, r2 = linkage.r2, r3 = linkage.r3, r4 = linkage.r4;
  const long double x = r2 * std::cos(delta) - r1;
  const long double y = r2 * std::sin(delta);
  const long double d = std::hypot(x, y);
  const long double cosine = (d * d + r4 * r4 - r3 * r3) / (2 * r4 * d);
  return std::atan2(y, x) + sigma * std::acos(std::min(1.0L, std::max(-1.0L, cosine))) + linkage.theta1;
}

TEST(FourBar, ReproducesTheTextbookTableOfPositions) {
  const auto rows = textbook("fourbar_000_table");
  ASSERT_EQ(rows.size(), 8U);
  for (const auto& row : rows) {
    const FourBarMotion motion =
        four_bar_by_crank(kTextbook, {number(row["theta2"]), 0, 0}, mode_of(row["sigma"]));
    ASSERT_EQ(motion.status, LinkageStatus::kOk);
    EXPECT_AT_MOST(std::abs(motion.theta3 - number(row["theta3_rad"])), 1e-15);
    EXPECT_AT_MOST(std::abs(motion.theta4 - number(row["theta4_rad"])), 1e-15);
  }
}

TEST(FourBar, ReproducesTheTextbookVelocitiesAndAccelerations) {
  const auto rows = textbook("fourbar_000_velocity_acceleration");
  ASSERT_EQ(rows.size(), 16U);
  for (const auto& row : rows) {
    const FourBarMotion motion =
        four_bar_by_crank(kTextbook, {number(row["theta2"]), number(row["omega2"]), number(row["alpha2"])},
                          mode_of(row["sigma"]));
    ASSERT_TRUE(motion.rates);
    EXPECT_AT_MOST(relative_error(motion.rates->omega3, number(row["omega3"])), 1e-15);
    EXPECT_AT_MOST(relative_error(motion.rates->omega4, number(row["omega4"])), 1e-15);
    // alpha3 is a difference of terms of about 300, whose rounding remains.
    EXPECT_AT_MOST(relative_error(motion.rates->alpha3, number(row["alpha3"])), 2e-14);
    EXPECT_AT_MOST(relative_error(motion.rates->alpha4, number(row["alpha4"])), 2e-14);
  }
}

TEST(FourBar, ReproducesTheTextbookCouplerPoint) {
  const auto expected = textbook("fourbar_000_pointE");
  const FourBarMotion motion = four_bar_by_crank(kTextbook, {0, 10, 0}, AssemblyMode::kPlus);
  ASSERT_TRUE(motion.rates);

  const BodyMotion crank{{}, 0, Vector2d::Zero(), 10, Vector2d::Zero(), 0};
  const PointMotion A = point_motion(crank, {kTextbook.r2, 0});
  const BodyMotion coupler{{Rotation<double>::from_angle(motion.theta3), A.p_W},
                           motion.theta3,
                           A.v_W,
                           motion.rates->omega3,
                           A.a_W,
                           motion.rates->alpha3};
  const PointMotion E = point_motion(coupler, {2, 1});
  for (int i = 0; i < 2; ++i) {
    EXPECT_AT_MOST(relative_error(E.v_W[i], number(expected["v"][i])), 1e-15);
    EXPECT_AT_MOST(relative_error(E.a_W[i], number(expected["a"][i])), 1e-14);
  }
}

TEST(FourBar, ReproducesTheTextbookLinkageDrivenByItsCoupler) {
  const auto expected = textbook("fourbar_000_coupler_driven");
  ASSERT_EQ(expected["rows"].size(), 24U);
  for (const auto& row : expected["rows"]) {
    const AngleMotion link3{number(row["theta3_deg"]) * kDegree, number(expected["omega3"]),
                            number(expected["alpha3"])};
    const FourBarMotion motion = four_bar_by_coupler(kTextbook, link3, mode_of(row["sigma"]));
    ASSERT_TRUE(motion.rates);
    EXPECT_AT_MOST(angle_error(motion.theta2, number(row["theta2"])), 4e-15);
    EXPECT_AT_MOST(angle_error(motion.theta4, number(row["theta4"])), 4e-15);
    EXPECT_AT_MOST(relative_error(motion.rates->omega2, number(row["omega2"])), 4e-15);
    EXPECT_AT_MOST(relative_error(motion.rates->omega4, number(row["omega4"])), 4e-15);
    // One rounding of θ3 (up to 4e-16) changes the accelerations by up to 60 times as much.
    EXPECT_AT_MOST(relative_error(motion.rates->alpha2, number(row["alpha2"])), 6e-14);
    EXPECT_AT_MOST(relative_error(motion.rates->alpha4, number(row["alpha4"])), 6e-14);
  }
}

TEST(FourBar, ReproducesTheTextbookExerciseOnACouplerThatTurnsFully) {
  const auto exercise = textbook("exercise3_000");
  const double arm = number(exercise["arm"]);
  const FourBar linkage{number(exercise["frame_2d"]), arm, number(exercise["coupler_2a"]), arm, 0};
  EXPECT_EQ(four_bar_coupler_range(linkage).reach, DriverReach::kFullTurn);

  const DriverRange range = four_bar_crank_range(linkage);
  ASSERT_EQ(range.reach, DriverReach::kRanges);
  ASSERT_EQ(range.count, 2);
  const double low = number(exercise["arm_angle_range_deg"][0]) * kDegree;
  const double high = number(exercise["arm_angle_range_deg"][1]) * kDegree;
  EXPECT_AT_MOST(std::abs(range.intervals[0].begin + high), 4e-16);
  EXPECT_AT_MOST(std::abs(range.intervals[0].end + low), 4e-16);
  EXPECT_AT_MOST(std::abs(range.intervals[1].begin - low), 4e-16);
  EXPECT_AT_MOST(std::abs(range.intervals[1].end - high), 4e-16);
}

TEST(FourBar, ClosesItsLoopInBothModesForEveryDriver) {
  Random random(1);
  Worst worst;
  int closed = 0;
  for (int i = 0; i < 20000; ++i) {
    const FourBar linkage = random_four_bar(random);
    const double theta = random.angle();
    for (const AssemblyMode mode : kModes) {
      for (const FourBarMotion& motion : {four_bar_by_crank(linkage, {theta, 1, 0}, mode),
                                          four_bar_by_coupler(linkage, {theta, 1, 0}, mode)}) {
        if (motion.status == LinkageStatus::kNotAssemblable) continue;
        worst.see(closure_error(linkage, motion));
        ++closed;
      }
    }
  }
  EXPECT_GT(closed, 20000);
  EXPECT_AT_MOST(worst.value(), 4e-15);
}

TEST(FourBar, AssemblesExactlyWhereTheTriangleInequalitySaysSo) {
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const FourBar linkage = random_four_bar(random);
    const double theta2 = random.angle();
    const double d = std::abs(linkage.r1 * direction(linkage.theta1) - linkage.r2 * direction(theta2));
    const double margin = std::min(linkage.r3 + linkage.r4 - d, d - std::abs(linkage.r3 - linkage.r4));
    if (std::abs(margin) < 1e-13) continue;
    EXPECT_EQ(four_bar_by_crank(linkage, {theta2, 1, 0}, AssemblyMode::kPlus).status,
              margin > 0 ? LinkageStatus::kOk : LinkageStatus::kNotAssemblable);
  }
}

TEST(FourBar, ModePlusPutsLink4CounterClockwiseOfTheDiagonal) {
  Random random(3);
  for (int i = 0; i < 5000; ++i) {
    const FourBar linkage = random_four_bar(random);
    const double theta2 = random.angle();
    for (const AssemblyMode mode : kModes) {
      const FourBarMotion motion = four_bar_by_crank(linkage, {theta2, 1, 0}, mode);
      if (motion.status != LinkageStatus::kOk) continue;
      const auto to_A = linkage.r2 * direction(theta2) - linkage.r1 * direction(linkage.theta1);
      EXPECT_GT(sign(mode) * std::imag(std::conj(to_A) * direction(motion.theta4)), 0);
      EXPECT_GT(sign(mode) * std::sin(motion.theta3 - motion.theta4), 0);
    }
  }
}

TEST(FourBar, RatesAreTheDerivativesOfPositions) {
  Random random(4);
  RatesCheck check;
  while (check.count() < 4000) {
    const FourBar linkage = random_four_bar(random);
    const AngleMotion driver{random.angle(), random.between(-2, 2), random.between(-2, 2)};
    const AssemblyMode mode = mode_of(check.count() % 2 == 0 ? 1 : -1);
    for (const bool by_coupler : {false, true}) {
      const auto solve = [&](const AngleMotion& at) {
        return by_coupler ? four_bar_by_coupler(linkage, at, mode) : four_bar_by_crank(linkage, at, mode);
      };
      const FourBarMotion motion = solve(driver);
      // Keep far enough from dead points for differences to be meaningful.
      const double between = by_coupler ? motion.theta2 - motion.theta4 : motion.theta3 - motion.theta4;
      if (motion.status != LinkageStatus::kOk || std::abs(std::sin(between)) < 0.5) continue;
      const auto values_at = [&](double t) {
        const FourBarMotion there = solve({driver.theta + driver.omega * t + driver.alpha * t * t / 2, 0, 0});
        return std::array<double, 3>{there.theta2, there.theta3, there.theta4};
      };
      const FourBarRates& rates = motion.rates.value();
      check.compare<3>(values_at, {true, true, true}, {rates.omega2, rates.omega3, rates.omega4},
                       {rates.alpha2, rates.alpha3, rates.alpha4});
    }
  }
  check.expect_small();
}

TEST(FourBar, FollowsWhenScaledTurnedAndMirrored) {
  Random random(5);
  for (int i = 0; i < 4000; ++i) {
    const FourBar linkage = random_four_bar(random);
    const AngleMotion driver{random.angle(), 1.3, -0.7};
    const FourBarMotion motion = four_bar_by_crank(linkage, driver, AssemblyMode::kPlus);
    if (motion.status != LinkageStatus::kOk || std::abs(std::sin(motion.theta3 - motion.theta4)) < 0.1) {
      continue;
    }
    const FourBarRates& rates = motion.rates.value();
    const auto expect_same = [&](const FourBarMotion& other, double turn, double mirror) {
      ASSERT_TRUE(other.rates);
      EXPECT_AT_MOST(angle_error(mirror * other.theta3 + turn, motion.theta3), 1e-13);
      EXPECT_AT_MOST(angle_error(mirror * other.theta4 + turn, motion.theta4), 1e-13);
      EXPECT_AT_MOST(relative_error(mirror * other.rates->omega3, rates.omega3), 1e-12);
      EXPECT_AT_MOST(relative_error(mirror * other.rates->omega4, rates.omega4), 1e-12);
      EXPECT_AT_MOST(relative_error(mirror * other.rates->alpha3, rates.alpha3), 1e-11);
      EXPECT_AT_MOST(relative_error(mirror * other.rates->alpha4, rates.alpha4), 1e-11);
    };
    for (const double scale : {1e-6, 1e-3, 1e6}) {
      const FourBar scaled{scale * linkage.r1, scale * linkage.r2, scale * linkage.r3, scale * linkage.r4,
                           linkage.theta1};
      expect_same(four_bar_by_crank(scaled, driver, AssemblyMode::kPlus), 0, 1);
    }
    FourBar turned = linkage;
    turned.theta1 -= 1.1;
    expect_same(four_bar_by_crank(turned, {driver.theta - 1.1, 1.3, -0.7}, AssemblyMode::kPlus), 1.1, 1);
    FourBar mirrored = linkage;
    mirrored.theta1 = -linkage.theta1;
    expect_same(four_bar_by_crank(mirrored, {-driver.theta, -1.3, 0.7}, AssemblyMode::kMinus), 0, -1);
  }
}

TEST(FourBar, CouplerDrivenUndoesCrankDriven) {
  Random random(6);
  int checked = 0;
  for (int i = 0; i < 4000; ++i) {
    const FourBar linkage = random_four_bar(random);
    const FourBarMotion forth = four_bar_by_crank(linkage, {random.angle(), 1.3, -0.7}, AssemblyMode::kPlus);
    if (forth.status != LinkageStatus::kOk || std::abs(std::sin(forth.theta3 - forth.theta4)) < 0.2) continue;
    const double other_sine = std::sin(forth.theta2 - forth.theta4);
    if (std::abs(other_sine) < 0.2) continue;
    const FourBarMotion back = four_bar_by_coupler(
        linkage, {forth.theta3, forth.rates->omega3, forth.rates->alpha3}, mode_of(other_sine > 0 ? 1 : -1));
    ASSERT_TRUE(back.rates);
    EXPECT_AT_MOST(angle_error(back.theta2, forth.theta2), 1e-13);
    EXPECT_AT_MOST(relative_error(back.rates->omega2, 1.3), 1e-11);
    EXPECT_AT_MOST(relative_error(back.rates->alpha2, -0.7), 1e-9);
    ++checked;
  }
  EXPECT_GT(checked, 500);
}

TEST(FourBar, LimitAnglesBoundWhatCanBeAssembled) {
  Random random(7);
  int ranges = 0;
  for (int i = 0; i < 5000; ++i) {
    const FourBar linkage = random_four_bar(random);
    for (const AssemblyMode mode : kModes) {
      const DriverRange crank = four_bar_crank_range(linkage);
      expect_limits_bound(crank, [&](double theta) {
        return four_bar_by_crank(linkage, {theta, 1, 0}, mode).status;
      });
      expect_limits_bound(four_bar_coupler_range(linkage), [&](double theta) {
        return four_bar_by_coupler(linkage, {theta, 1, 0}, mode).status;
      });
      ranges += crank.count;
    }
  }
  EXPECT_GT(ranges, 1000);
}

TEST(FourBar, LimitAnglesAgreeWithTheLawOfCosines) {
  Random random(8);
  Worst worst;
  int limits = 0;
  for (int i = 0; i < 20000; ++i) {
    const FourBar linkage = random_four_bar(random);
    const long double r1 = linkage.r1, r2 = linkage.r2;
    std::vector<double> expected;
    for (const long double d : {static_cast<long double>(linkage.r3) + linkage.r4,
                                static_cast<long double>(linkage.r3) - linkage.r4}) {
      const long double cosine = (r1 * r1 + r2 * r2 - d * d) / (2 * r1 * r2);
      if (std::abs(cosine) > 0.9999L) continue;  // acos itself loses its digits there
      expected.push_back(linkage.theta1 + static_cast<double>(std::acos(cosine)));
      expected.push_back(linkage.theta1 - static_cast<double>(std::acos(cosine)));
    }
    const DriverRange range = four_bar_crank_range(linkage);
    EXPECT_GE(2 * range.count, static_cast<int>(range.count > 0 ? expected.size() : 0));
    for (int k = 0; k < range.count; ++k) {
      const DriverInterval& interval = range.intervals[k];
      EXPECT_TRUE(interval.begin > -kPi - 1e-15 && interval.begin <= kPi);
      EXPECT_LE(interval.end - interval.begin, 2 * kPi);
      if (expected.size() != 2 * static_cast<std::size_t>(range.count)) continue;
      worst.see(distance_to_nearest(interval.begin, expected));
      worst.see(distance_to_nearest(interval.end, expected));
      ++limits;
    }
  }
  EXPECT_GT(limits, 10000);
  EXPECT_AT_MOST(worst.value(), 1e-14);
}

TEST(FourBar, TellsFullTurnFromRangesFromNever) {
  EXPECT_EQ(four_bar_crank_range({7, 2, 6, 5, 0.3}).reach, DriverReach::kFullTurn);
  EXPECT_EQ(four_bar_crank_range({7, 2, 1.3, 1.9, 0.3}).reach, DriverReach::kNever);  // d >= 5 > 3.2
  EXPECT_EQ(four_bar_crank_range({1.1, 0.7, 6, 3, 0.3}).reach, DriverReach::kNever);  // d <= 1.8 < 3
  const DriverRange around_0 = four_bar_crank_range({5, 4, 3, 2.5, 0});
  EXPECT_EQ(around_0.count, 1);
  EXPECT_EQ(around_0.intervals[0].begin, -around_0.intervals[0].end);
  const DriverRange around_pi = four_bar_crank_range({5, 4.5, 9, 2, 0});
  ASSERT_EQ(around_pi.count, 1);
  EXPECT_AT_MOST(std::abs(0.5 * (around_pi.intervals[0].begin + around_pi.intervals[0].end) - kPi), 1e-15);
  EXPECT_EQ(four_bar_crank_range({7, 2, 3, 2, 0}).count, 1);
  EXPECT_AT_MOST(four_bar_crank_range({7, 2, 3, 2, 0}).intervals[0].end, 0);  // it only just closes
}

TEST(FourBar, IsAsAccurateAsItsInputNearDeadPoints) {
  if (!kLongDoubleIsLonger) GTEST_SKIP() << "needs a reference with more digits than double";
  Random random(9);
  Worst worst;
  int checked = 0;
  while (checked < 20000) {
    FourBar linkage = random_four_bar(random);
    linkage.theta1 = 0;
    const DriverRange range = four_bar_crank_range(linkage);
    if (range.count == 0) continue;
    const DriverInterval& interval = range.intervals[0];
    for (const double gap : {1e-9, 1e-6, 1e-3}) {
      if (interval.end - interval.begin < 2 * gap) continue;
      for (const double theta2 : {interval.begin + gap, interval.end - gap}) {
        for (const AssemblyMode mode : kModes) {
          const FourBarMotion motion = four_bar_by_crank(linkage, {theta2, 1, 0}, mode);
          ASSERT_EQ(motion.status, LinkageStatus::kOk);
          const auto expected =
              static_cast<double>(reference_theta4(linkage, theta2, mode == AssemblyMode::kPlus ? 1 : -1));
          // The effect of a rounding of θ2 on θ4, and the rounding of θ4 itself.
          const double forced = 2.3e-16 * (std::abs(motion.rates->omega4) * std::abs(theta2) + kPi);
          worst.see(angle_error(motion.theta4, expected) / forced);
          ++checked;
        }
      }
    }
  }
  EXPECT_AT_MOST(worst.value(), 3);
}

TEST(FourBar, SaysSingularWithoutRatesExactlyAtADeadPoint) {
  // 3 + 4 = 5 + 2 with the crank turned away: stretched at θ2 = π; 3, 4, 5 and a square: folded at θ2 = 90°.
  const FourBarMotion stretched = four_bar_by_crank({5, 2, 3, 4, 0}, {kPi, 1, 0}, AssemblyMode::kPlus);
  EXPECT_EQ(stretched.status, LinkageStatus::kSingular);
  EXPECT_FALSE(stretched.rates);
  EXPECT_AT_MOST(closure_error({5, 2, 3, 4, 0}, stretched), 1e-15);
  const FourBarMotion folded = four_bar_by_crank({4, 3, 7, 2, 0}, {kPi / 2, 1, 0}, AssemblyMode::kMinus);
  EXPECT_EQ(folded.status, LinkageStatus::kSingular);
  EXPECT_FALSE(folded.rates);
  EXPECT_AT_MOST(closure_error({4, 3, 7, 2, 0}, folded), 1e-15);
}

TEST(FourBar, ParallelogramHasFullAccuracyNextToItsChangePoint) {
  const double L = 3.1, s = 1.7;
  const FourBar linkage{L, s, L, s, 0};
  EXPECT_EQ(four_bar_by_crank(linkage, {0, 1, 0}, AssemblyMode::kPlus).status, LinkageStatus::kSingular);
  EXPECT_EQ(four_bar_crank_range(linkage).reach, DriverReach::kFullTurn);
  for (const double theta2 : {1e-9, 1e-6, 1e-3, 0.7, kPi - 1e-6, -1e-9, -0.7}) {
    const double x = std::tan(theta2 / 2), m = -(L + s) / (L - s);
    // From Freudenstein's equation: tan(θ4/2) is x (parallelogram) or m x (crossed).
    for (const AssemblyMode mode : kModes) {
      const FourBarMotion motion = four_bar_by_crank(linkage, {theta2, 2, 0}, mode);
      ASSERT_EQ(motion.status, LinkageStatus::kOk) << theta2;
      const bool crossed =
          angle_error(motion.theta4, 2 * std::atan(m * x)) < angle_error(motion.theta4, theta2);
      const double theta4 = crossed ? 2 * std::atan(m * x) : theta2;
      const double omega4 = crossed ? 2 * m * (1 + x * x) / (1 + m * m * x * x) : 2;
      EXPECT_AT_MOST(std::abs(motion.theta4 - theta4), 4e-15 * std::max(std::abs(theta4), 1e-9));
      EXPECT_AT_MOST(std::abs(motion.rates->omega4 - omega4), 1e-14 * std::abs(omega4)) << theta2;
      if (!crossed) {
        EXPECT_AT_MOST(std::abs(motion.theta3), 1e-15);
        EXPECT_AT_MOST(std::abs(motion.rates->omega3), 1e-14);
      }
    }
  }
}

TEST(FourBar, ChangePointOfDecimalLengthsStaysOne) {
  // 0.1 + 0.4 = 0.2 + 0.3 holds in decimal numbers only.
  const FourBar linkage{0.4, 0.1, 0.3, 0.2, 0};
  EXPECT_EQ(four_bar_by_crank(linkage, {kPi, 1, 0}, AssemblyMode::kPlus).status, LinkageStatus::kSingular);
  EXPECT_EQ(four_bar_crank_range(linkage).reach, DriverReach::kFullTurn);
  EXPECT_EQ(four_bar_by_crank(linkage, {kPi - 1e-9, 1, 0}, AssemblyMode::kPlus).status, LinkageStatus::kOk);
}

TEST(FourBar, KiteWithItsPinOnTheGroundPivotIsSingular) {
  const FourBar linkage{2.3, 2.3, 1.9, 1.9, 0.4};
  for (const AssemblyMode mode : kModes) {
    const FourBarMotion motion = four_bar_by_crank(linkage, {0.4, 1, 0}, mode);
    EXPECT_EQ(motion.status, LinkageStatus::kSingular);
    EXPECT_AT_MOST(closure_error(linkage, motion), 1e-15);
    EXPECT_FALSE(motion.rates);
    const FourBarMotion next = four_bar_by_crank(linkage, {0.4 + 1e-7, 1, 0}, mode);
    EXPECT_EQ(next.status, LinkageStatus::kOk);
    EXPECT_AT_MOST(closure_error(linkage, next), 1e-15);
  }
  // With the same pivots but unequal links this angle is out of reach.
  EXPECT_EQ(four_bar_by_crank({2.3, 2.3, 1.9, 1.7, 0.4}, {0.4, 1, 0}, AssemblyMode::kPlus).status,
            LinkageStatus::kNotAssemblable);
}

TEST(FourBar, WithoutGroundLinkTurnsAsARigidTriangle) {
  const FourBar linkage{0, 2.1, 1.3, 1.7, 0};
  EXPECT_EQ(four_bar_crank_range(linkage).reach, DriverReach::kFullTurn);
  const FourBarMotion motion = four_bar_by_crank(linkage, {0.9, 3.1, -0.7}, AssemblyMode::kPlus);
  ASSERT_TRUE(motion.rates);
  EXPECT_AT_MOST(closure_error(linkage, motion), 1e-15);
  EXPECT_AT_MOST(relative_error(motion.rates->omega3, 3.1), 1e-14);
  EXPECT_AT_MOST(relative_error(motion.rates->omega4, 3.1), 1e-14);
  EXPECT_AT_MOST(relative_error(motion.rates->alpha4, -0.7), 1e-13);
}

TEST(FourBar, StaysClosedAndFiniteWithLengthsOfVeryDifferentSize) {
  Random random(10);
  Worst worst;
  int closed = 0;
  for (int i = 0; i < 50000; ++i) {
    const auto length = [&] { return std::pow(10.0, random.between(-6, 6)); };
    FourBar linkage{length(), length(), length(), length(), random.angle()};
    // Two long links of nearly equal length allow two short ones to close the loop.
    if (i % 2 == 0) linkage.r3 = linkage.r1 * (1 + 1e-3 * random.between(-1, 1));
    if (i % 3 == 0) linkage.r4 = linkage.r2 * (1 + 1e-6 * random.between(-1, 1));
    for (const AssemblyMode mode : kModes) {
      const FourBarMotion motion = four_bar_by_crank(linkage, {random.angle(), 1, 1}, mode);
      if (motion.status == LinkageStatus::kNotAssemblable) continue;
      worst.see(closure_error(linkage, motion));
      ++closed;
      if (!motion.rates) continue;
      EXPECT_TRUE(std::isfinite(motion.rates->omega3) && std::isfinite(motion.rates->omega4) &&
                  std::isfinite(motion.rates->alpha3) && std::isfinite(motion.rates->alpha4));
    }
  }
  EXPECT_GT(closed, 5000);
  EXPECT_AT_MOST(worst.value(), 4e-15);
}

TEST(FourBar, AnAngleThatIsNotANumberIsNotAssemblable) {
  const FourBarMotion motion =
      four_bar_by_crank(kTextbook, {std::numeric_limits<double>::quiet_NaN(), 1, 0}, AssemblyMode::kPlus);
  EXPECT_EQ(motion.status, LinkageStatus::kNotAssemblable);
  EXPECT_FALSE(motion.rates);
}

}  // namespace
}  // namespace higherpair
