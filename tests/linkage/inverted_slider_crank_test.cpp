#include "linkage/inverted_slider_crank.hpp"

#include "linkage/linkage_testing.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

InvertedSliderCrank random_linkage(Random& random) {
  return {random.between(0.2, 3), random.between(0.2, 3), random.between(-2, 2), random.angle()};
}

double closure_error(const InvertedSliderCrank& linkage, const InvertedSliderCrankMotion& motion) {
  const auto gap = linkage.r2 * direction(motion.theta2) - linkage.r1 * direction(linkage.theta1) -
                   (motion.r3 + std::complex<double>(0, linkage.r4)) * direction(motion.theta3);
  return std::abs(gap) / std::max({linkage.r1, linkage.r2, std::abs(linkage.r4)});
}

InvertedSliderCrankMotion solve(const InvertedSliderCrank& linkage, bool by_slot, const AngleMotion& driver,
                                AssemblyMode mode) {
  return by_slot ? inverted_slider_crank_by_slot(linkage, driver, mode)
                 : inverted_slider_crank_by_crank(linkage, driver, mode);
}

TEST(InvertedSliderCrank, ClosesItsLoopInTheNamedModeForBothDrivers) {
  Random random(21);
  Worst worst;
  int closed = 0;
  for (int i = 0; i < 10000; ++i) {
    const InvertedSliderCrank linkage = random_linkage(random);
    const double theta = random.angle();
    for (const AssemblyMode mode : kModes) {
      for (const bool by_slot : {false, true}) {
        const InvertedSliderCrankMotion motion = solve(linkage, by_slot, {theta, 1, 0}, mode);
        if (motion.status == LinkageStatus::kNotAssemblable) continue;
        worst.see(closure_error(linkage, motion));
        const double measure = by_slot ? std::cos(motion.theta2 - motion.theta3) : motion.r3;
        if (motion.status == LinkageStatus::kOk) {
          EXPECT_GT(sign(mode) * measure, 0);
        }
        ++closed;
      }
    }
  }
  EXPECT_GT(closed, 10000);
  EXPECT_AT_MOST(worst.value(), 4e-15);
}

TEST(InvertedSliderCrank, RatesAreTheDerivativesOfPositions) {
  Random random(22);
  RatesCheck check;
  while (check.count() < 4000) {
    const InvertedSliderCrank linkage = random_linkage(random);
    const AngleMotion driver{random.angle(), random.between(-1.5, 1.5), random.between(-2, 2)};
    const AssemblyMode mode = mode_of(check.count() % 2 == 0 ? 1 : -1);
    for (const bool by_slot : {false, true}) {
      const InvertedSliderCrankMotion motion = solve(linkage, by_slot, driver, mode);
      if (motion.status != LinkageStatus::kOk) continue;
      const double determinant =
          by_slot ? std::cos(motion.theta2 - motion.theta3) : motion.r3 / (linkage.r1 + linkage.r2);
      if (std::abs(determinant) < 0.3) continue;
      const auto values_at = [&](double t) {
        const auto there =
            solve(linkage, by_slot, {driver.theta + driver.omega * t + driver.alpha * t * t / 2, 0, 0}, mode);
        return std::array<double, 3>{there.theta2, there.theta3, there.r3};
      };
      const InvertedSliderCrankRates& rates = motion.rates.value();
      check.compare<3>(values_at, {true, true, false}, {rates.omega2, rates.omega3, rates.r3_dot},
                       {rates.alpha2, rates.alpha3, rates.r3_ddot});
    }
  }
  check.expect_small();
}

TEST(InvertedSliderCrank, DrivenByItsSlotUndoesDrivenByItsCrank) {
  Random random(23);
  int checked = 0;
  for (int i = 0; i < 5000; ++i) {
    const InvertedSliderCrank linkage = random_linkage(random);
    const auto forth =
        inverted_slider_crank_by_crank(linkage, {random.angle(), 1.3, -0.7}, AssemblyMode::kPlus);
    if (forth.status != LinkageStatus::kOk || forth.r3 < 0.2) continue;
    const double cosine = std::cos(forth.theta2 - forth.theta3);
    if (std::abs(cosine) < 0.2) continue;
    const auto back = inverted_slider_crank_by_slot(
        linkage, {forth.theta3, forth.rates->omega3, forth.rates->alpha3}, mode_of(cosine > 0 ? 1 : -1));
    ASSERT_TRUE(back.rates);
    EXPECT_AT_MOST(angle_error(back.theta2, forth.theta2), 1e-13);
    EXPECT_AT_MOST(relative_error(back.r3, forth.r3), 1e-13);
    EXPECT_AT_MOST(relative_error(back.rates->omega2, 1.3), 1e-12);
    EXPECT_AT_MOST(relative_error(back.rates->r3_dot, forth.rates->r3_dot), 1e-12);
    EXPECT_AT_MOST(relative_error(back.rates->alpha2, -0.7), 1e-10);
    EXPECT_AT_MOST(relative_error(back.rates->r3_ddot, forth.rates->r3_ddot), 1e-10);
    ++checked;
  }
  EXPECT_GT(checked, 1000);
}

TEST(InvertedSliderCrank, FollowsWhenScaledTurnedAndMirrored) {
  Random random(24);
  for (int i = 0; i < 3000; ++i) {
    const InvertedSliderCrank linkage = random_linkage(random);
    const double theta = random.angle();
    for (const bool by_slot : {false, true}) {
      const auto motion = solve(linkage, by_slot, {theta, 1.3, -0.7}, AssemblyMode::kPlus);
      if (motion.status != LinkageStatus::kOk || std::abs(motion.r3) < 0.2 ||
          std::abs(std::cos(motion.theta2 - motion.theta3)) < 0.2) {
        continue;
      }
      const auto expect_same = [&](const InvertedSliderCrankMotion& other, double scale, double turn,
                                   double mirror) {
        ASSERT_TRUE(other.rates);
        EXPECT_AT_MOST(angle_error(mirror * other.theta2 + turn, motion.theta2), 1e-13);
        EXPECT_AT_MOST(angle_error(mirror * other.theta3 + turn, motion.theta3), 1e-13);
        EXPECT_AT_MOST(relative_error(other.r3 / scale, motion.r3), 1e-13);
        EXPECT_AT_MOST(relative_error(mirror * other.rates->alpha2, motion.rates->alpha2), 1e-11);
        EXPECT_AT_MOST(relative_error(mirror * other.rates->alpha3, motion.rates->alpha3), 1e-11);
        EXPECT_AT_MOST(relative_error(other.rates->r3_ddot / scale, motion.rates->r3_ddot), 1e-11);
      };
      for (const double scale : {1e-6, 1e6}) {
        const InvertedSliderCrank scaled{scale * linkage.r1, scale * linkage.r2, scale * linkage.r4,
                                         linkage.theta1};
        expect_same(solve(scaled, by_slot, {theta, 1.3, -0.7}, AssemblyMode::kPlus), scale, 0, 1);
      }
      InvertedSliderCrank turned = linkage;
      turned.theta1 += 2.3;
      expect_same(solve(turned, by_slot, {theta + 2.3, 1.3, -0.7}, AssemblyMode::kPlus), 1, -2.3, 1);
      const InvertedSliderCrank mirrored{linkage.r1, linkage.r2, -linkage.r4, -linkage.theta1};
      expect_same(solve(mirrored, by_slot, {-theta, -1.3, 0.7}, AssemblyMode::kPlus), 1, 0, -1);
    }
  }
}

TEST(InvertedSliderCrank, LimitAnglesBoundWhatCanBeAssembled) {
  Random random(25);
  int ranges = 0;
  for (int i = 0; i < 5000; ++i) {
    const InvertedSliderCrank linkage = random_linkage(random);
    for (const bool by_slot : {false, true}) {
      const DriverRange range =
          by_slot ? inverted_slider_crank_slot_range(linkage) : inverted_slider_crank_crank_range(linkage);
      ranges += range.count;
      for (const AssemblyMode mode : kModes) {
        expect_limits_bound(range, [&](double theta) {
          return solve(linkage, by_slot, {theta, 1, 0}, mode).status;
        });
      }
    }
  }
  EXPECT_GT(ranges, 2000);
}

TEST(InvertedSliderCrank, CrankLimitsAgreeWithTheLawOfCosines) {
  Random random(26);
  Worst worst;
  for (int i = 0; i < 10000; ++i) {
    const InvertedSliderCrank linkage = random_linkage(random);
    const long double r1 = linkage.r1, r2 = linkage.r2, r4 = linkage.r4;
    const long double cosine = (r1 * r1 + r2 * r2 - r4 * r4) / (2 * r1 * r2);
    if (std::abs(std::abs(cosine) - 1) < 1e-4L) continue;
    const DriverRange range = inverted_slider_crank_crank_range(linkage);
    if (std::abs(cosine) > 1) {
      EXPECT_EQ(range.reach, cosine > 0 ? DriverReach::kFullTurn : DriverReach::kNever);
      continue;
    }
    ASSERT_EQ(range.count, 1);
    const auto limit = static_cast<double>(std::acos(cosine));
    worst.see(angle_error(range.intervals[0].begin, linkage.theta1 + limit));
    worst.see(angle_error(range.intervals[0].end, linkage.theta1 - limit));
  }
  EXPECT_AT_MOST(worst.value(), 1e-14);
}

TEST(InvertedSliderCrank, SlotLimitsAgreeWithTheSine) {
  Random random(27);
  Worst worst;
  for (int i = 0; i < 10000; ++i) {
    const InvertedSliderCrank linkage = random_linkage(random);
    const long double r1 = linkage.r1, r2 = linkage.r2, r4 = linkage.r4;
    std::vector<double> expected;
    bool near_top = false;
    for (const long double sine : {(r4 - r2) / r1, (r4 + r2) / r1}) {
      near_top = near_top || std::abs(std::abs(sine) - 1) < 1e-4L;
      if (std::abs(sine) > 1) continue;
      expected.push_back(linkage.theta1 + static_cast<double>(std::asin(sine)));
      expected.push_back(linkage.theta1 + kPi - static_cast<double>(std::asin(sine)));
    }
    if (near_top) continue;
    const DriverRange range = inverted_slider_crank_slot_range(linkage);
    ASSERT_EQ(expected.size(), 2 * static_cast<std::size_t>(range.count));
    for (int k = 0; k < range.count; ++k) {
      worst.see(distance_to_nearest(range.intervals[k].begin, expected));
      worst.see(distance_to_nearest(range.intervals[k].end, expected));
    }
  }
  EXPECT_AT_MOST(worst.value(), 1e-14);
}

TEST(InvertedSliderCrank, SaysSingularWithoutRatesExactlyAtADeadPoint) {
  const InvertedSliderCrank linkage{4, 3, -5, 0};  // 3, 4, 5: the pin is 5 from O2 at θ2 = 90°
  for (const AssemblyMode mode : kModes) {
    const auto motion = inverted_slider_crank_by_crank(linkage, {kPi / 2, 1, 0}, mode);
    EXPECT_EQ(motion.status, LinkageStatus::kSingular);
    EXPECT_FALSE(motion.rates);
    EXPECT_AT_MOST(closure_error(linkage, motion), 1e-15);
    EXPECT_EQ(inverted_slider_crank_by_crank(linkage, {kPi / 2 + 1e-9, 1, 0}, mode).status,
              LinkageStatus::kOk);
    EXPECT_EQ(inverted_slider_crank_by_crank(linkage, {kPi / 2 - 1e-9, 1, 0}, mode).status,
              LinkageStatus::kNotAssemblable);
  }
  const auto across = inverted_slider_crank_by_slot({5, 3, 2, 0}, {kPi / 2, 1, 0}, AssemblyMode::kPlus);
  EXPECT_EQ(across.status, LinkageStatus::kSingular);
  EXPECT_FALSE(across.rates);
}

TEST(InvertedSliderCrank, IsAsAccurateAsItsInputNearDeadPoints) {
  if (!kLongDoubleIsLonger) GTEST_SKIP() << "needs a reference with more digits than double";
  Random random(28);
  Worst worst;
  int checked = 0;
  while (checked < 4000) {
    InvertedSliderCrank linkage = random_linkage(random);
    linkage.theta1 = 0;
    const DriverRange range = inverted_slider_crank_crank_range(linkage);
    if (range.count == 0 || range.intervals[0].end - range.intervals[0].begin < 1e-3) continue;
    for (const double gap : {1e-9, 1e-6}) {
      const double theta2 = range.intervals[0].begin + gap;
      const auto motion = inverted_slider_crank_by_crank(linkage, {theta2, 1, 0}, AssemblyMode::kPlus);
      ASSERT_EQ(motion.status, LinkageStatus::kOk);
      const long double x = linkage.r2 * std::cos(static_cast<long double>(theta2)) - linkage.r1;
      const long double y = linkage.r2 * std::sin(static_cast<long double>(theta2));
      const long double r4 = linkage.r4;
      const long double r3 = std::sqrt(x * x + y * y - r4 * r4);
      const auto theta3 = static_cast<double>(std::atan2(y, x) - std::atan2(r4, r3));
      const double forced = 2.3e-16 * (std::abs(motion.rates->omega3) * std::abs(theta2) + kPi);
      worst.see(angle_error(motion.theta3, theta3) / forced);
      ++checked;
    }
  }
  EXPECT_AT_MOST(worst.value(), 3);
}

TEST(InvertedSliderCrank, WithEqualLinksAndNoOffsetTurnsTheSlotAtHalfSpeed) {
  // Thales: the pin's circle passes through O2.
  const InvertedSliderCrank linkage{1.9, 1.9, 0, 0};
  for (const double theta2 : {1e-9, 1e-4, 0.3, 2.9}) {
    const auto motion = inverted_slider_crank_by_crank(linkage, {theta2, 2, 0.6}, AssemblyMode::kPlus);
    ASSERT_TRUE(motion.rates) << theta2;
    EXPECT_AT_MOST(angle_error(motion.theta3, kPi / 2 + theta2 / 2), 1e-15);
    EXPECT_AT_MOST(std::abs(motion.r3 - 3.8 * std::sin(theta2 / 2)), 1e-15 * motion.r3 + 1e-24);
    EXPECT_AT_MOST(std::abs(motion.rates->omega3 - 1), 1e-14);
    EXPECT_AT_MOST(std::abs(motion.rates->r3_dot - 3.8 * std::cos(theta2 / 2)), 1e-14);
  }
  for (const AssemblyMode mode : kModes) {
    const auto home = inverted_slider_crank_by_crank(linkage, {0, 2, 0}, mode);
    EXPECT_EQ(home.status, LinkageStatus::kSingular);
    EXPECT_AT_MOST(closure_error(linkage, home), 1e-15);
  }
}

TEST(InvertedSliderCrank, WithBothPivotsInOnePlaceTurnsAsOneBody) {
  const InvertedSliderCrank linkage{0, 5, 3, 0};
  const auto motion = inverted_slider_crank_by_crank(linkage, {0.7, 2, -1.1}, AssemblyMode::kPlus);
  ASSERT_TRUE(motion.rates);
  EXPECT_AT_MOST(std::abs(motion.r3 - 4), 1e-15);
  EXPECT_AT_MOST(angle_error(motion.theta3, 0.7 - std::atan2(3, 4)), 1e-15);
  EXPECT_AT_MOST(std::abs(motion.rates->omega3 - 2), 1e-15);
  EXPECT_AT_MOST(std::abs(motion.rates->alpha3 + 1.1), 1e-14);
  EXPECT_AT_MOST(std::abs(motion.rates->r3_dot), 1e-14);
}

}  // namespace
}  // namespace higherpair
