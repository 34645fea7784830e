#include "linkage/slider_crank.hpp"

#include "linkage/linkage_testing.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

SliderCrank random_slider_crank(Random& random) {
  return {random.between(0.2, 3), random.between(0.2, 3), random.between(-2, 2), random.angle()};
}

double closure_error(const SliderCrank& linkage, const SliderCrankMotion& motion) {
  const auto along = direction(linkage.theta1);
  const auto gap = linkage.r2 * direction(motion.theta2) + linkage.r3 * direction(motion.theta3) -
                   (motion.r1 + std::complex<double>(0, linkage.r4)) * along;
  return std::abs(gap) / std::max({linkage.r2, linkage.r3, std::abs(linkage.r4)});
}

enum class By { kCrank, kCoupler, kSlider };

SliderCrankMotion solve(const SliderCrank& linkage, By by, double q, double q_dot, double q_ddot,
                        AssemblyMode mode) {
  switch (by) {
    case By::kCrank:
      return slider_crank_by_crank(linkage, {q, q_dot, q_ddot}, mode);
    case By::kCoupler:
      return slider_crank_by_coupler(linkage, {q, q_dot, q_ddot}, mode);
    default:
      return slider_crank_by_slider(linkage, {q, q_dot, q_ddot}, mode);
  }
}

/// The determinant of the closure equations, dimensionless.
double determinant(const SliderCrank& linkage, By by, const SliderCrankMotion& motion) {
  switch (by) {
    case By::kCrank:
      return std::cos(motion.theta3 - linkage.theta1);
    case By::kCoupler:
      return std::cos(motion.theta2 - linkage.theta1);
    default:
      return std::sin(motion.theta3 - motion.theta2);
  }
}

struct TextbookRow {
  SliderCrank linkage;
  double theta2, omega2, alpha2;
  double theta3, omega3, alpha3;
  double r1, r1_dot, r1_ddot;
  int sigma;
};

std::vector<TextbookRow> textbook_rows() {
  const auto data = textbook("slider_crank_000");
  const SliderCrank linkage{number(data["r2"]), number(data["r3"]), number(data["r4"]),
                            number(data["theta1_deg"]) * kDegree};
  std::vector<TextbookRow> rows;
  for (const auto& row : data["rows"]) {
    rows.push_back({linkage, number(row["theta2_deg"]) * kDegree, number(data["omega2"]),
                    number(data["alpha2"]), number(row["theta3"]), number(row["omega3"]),
                    number(row["alpha3"]), number(row["r1"]), number(row["r1_dot"]), number(row["r1_ddot"]),
                    row["sigma"].get<int>()});
  }
  return rows;
}

TEST(SliderCrank, ReproducesTheTextbookLinkageDrivenByItsCrank) {
  for (const TextbookRow& row : textbook_rows()) {
    const SliderCrankMotion motion =
        slider_crank_by_crank(row.linkage, {row.theta2, row.omega2, row.alpha2}, mode_of(row.sigma));
    ASSERT_TRUE(motion.rates);
    EXPECT_AT_MOST(angle_error(motion.theta3, row.theta3), 2e-15);
    EXPECT_AT_MOST(relative_error(motion.r1, row.r1), 2e-15);
    EXPECT_AT_MOST(relative_error(motion.rates->omega3, row.omega3), 4e-15);
    EXPECT_AT_MOST(relative_error(motion.rates->r1_dot, row.r1_dot), 4e-15);
    EXPECT_AT_MOST(relative_error(motion.rates->alpha3, row.alpha3), 1e-14);
    EXPECT_AT_MOST(relative_error(motion.rates->r1_ddot, row.r1_ddot), 2e-14);
  }
}

TEST(SliderCrank, ReproducesTheTextbookLinkageDrivenByItsCoupler) {
  int checked = 0;
  for (const TextbookRow& row : textbook_rows()) {
    const double cosine = std::cos(row.theta2 - row.linkage.theta1);
    const SliderCrankMotion motion = slider_crank_by_coupler(
        row.linkage, {row.theta3, row.omega3, row.alpha3}, mode_of(cosine > 0 ? 1 : -1));
    ASSERT_TRUE(motion.rates);
    // The coupler's rounding is magnified by dθ2/dθ3 in the crank.
    const double gain = std::max(1.0, std::abs(row.omega2 / row.omega3));
    EXPECT_AT_MOST(angle_error(motion.theta2, row.theta2), 4e-15 * gain);
    EXPECT_AT_MOST(relative_error(motion.r1, row.r1), 4e-15 * gain);
    EXPECT_AT_MOST(relative_error(motion.rates->omega2, row.omega2), 2e-14 * gain * gain);
    EXPECT_AT_MOST(relative_error(motion.rates->r1_dot, row.r1_dot), 2e-14 * gain * gain);
    EXPECT_AT_MOST(relative_error(motion.rates->alpha2, row.alpha2), 1e-13 * gain * gain * gain);
    EXPECT_AT_MOST(relative_error(motion.rates->r1_ddot, row.r1_ddot), 1e-13 * gain * gain * gain);
    ++checked;
  }
  EXPECT_EQ(checked, 24);
}

TEST(SliderCrank, ReproducesTheTextbookLinkageDrivenByItsSlider) {
  for (const TextbookRow& row : textbook_rows()) {
    // The mode follows from whether the crank is counter-clockwise of the line from O2 to the slider.
    const auto slider = row.r1 + std::complex<double>(0, row.linkage.r4);
    const double side = std::imag(std::conj(slider) * direction(row.theta2 - row.linkage.theta1));
    const SliderCrankMotion motion =
        slider_crank_by_slider(row.linkage, {row.r1, row.r1_dot, row.r1_ddot}, mode_of(side > 0 ? 1 : -1));
    ASSERT_TRUE(motion.rates);
    const double gain = std::max(1.0, std::abs(row.omega2 * row.r1 / row.r1_dot));
    EXPECT_AT_MOST(angle_error(motion.theta2, row.theta2), 4e-15 * gain);
    EXPECT_AT_MOST(angle_error(motion.theta3, row.theta3), 4e-15 * gain);
    EXPECT_AT_MOST(relative_error(motion.rates->omega2, row.omega2), 2e-14 * gain * gain);
    EXPECT_AT_MOST(relative_error(motion.rates->omega3, row.omega3), 2e-14 * gain * gain);
    EXPECT_AT_MOST(relative_error(motion.rates->alpha2, row.alpha2), 1e-13 * gain * gain * gain);
    EXPECT_AT_MOST(relative_error(motion.rates->alpha3, row.alpha3), 1e-13 * gain * gain * gain);
  }
}

TEST(SliderCrank, ClosesItsLoopInBothModesForEveryDriver) {
  Random random(11);
  Worst worst;
  int closed = 0;
  for (int i = 0; i < 10000; ++i) {
    const SliderCrank linkage = random_slider_crank(random);
    for (const AssemblyMode mode : kModes) {
      for (const By by : {By::kCrank, By::kCoupler, By::kSlider}) {
        const SliderCrankMotion motion = solve(linkage, by, random.angle(), 1, 0, mode);
        if (motion.status == LinkageStatus::kNotAssemblable) continue;
        worst.see(closure_error(linkage, motion));
        ++closed;
      }
    }
  }
  EXPECT_GT(closed, 10000);
  EXPECT_AT_MOST(worst.value(), 4e-15);
}

TEST(SliderCrank, ModesAreTheOnesTheHeaderNames) {
  Random random(12);
  for (int i = 0; i < 5000; ++i) {
    const SliderCrank linkage = random_slider_crank(random);
    const double q = random.angle();
    for (const AssemblyMode mode : kModes) {
      const auto check = [&](By by, auto measure) {
        const SliderCrankMotion motion = solve(linkage, by, q, 1, 0, mode);
        if (motion.status == LinkageStatus::kOk) {
          EXPECT_GT(sign(mode) * measure(motion), 0);
        }
      };
      check(By::kCrank, [&](const auto& m) { return std::cos(m.theta3 - linkage.theta1); });
      check(By::kCoupler, [&](const auto& m) { return std::cos(m.theta2 - linkage.theta1); });
      check(By::kSlider, [&](const auto& m) {
        const auto slider = m.r1 + std::complex<double>(0, linkage.r4);
        return std::imag(std::conj(slider) * direction(m.theta2 - linkage.theta1));
      });
    }
  }
}

TEST(SliderCrank, RatesAreTheDerivativesOfPositions) {
  Random random(13);
  RatesCheck check;
  while (check.count() < 4000) {
    const SliderCrank linkage = random_slider_crank(random);
    const double q = random.angle(), q_dot = random.between(-1.5, 1.5), q_ddot = random.between(-2, 2);
    const AssemblyMode mode = mode_of(check.count() % 2 == 0 ? 1 : -1);
    for (const By by : {By::kCrank, By::kCoupler, By::kSlider}) {
      const SliderCrankMotion motion = solve(linkage, by, q, q_dot, q_ddot, mode);
      if (motion.status != LinkageStatus::kOk || std::abs(determinant(linkage, by, motion)) < 0.5) continue;
      const auto values_at = [&](double t) {
        const auto there = solve(linkage, by, q + q_dot * t + q_ddot * t * t / 2, 0, 0, mode);
        return std::array<double, 3>{there.theta2, there.theta3, there.r1};
      };
      const SliderCrankRates& rates = motion.rates.value();
      check.compare<3>(values_at, {true, true, false}, {rates.omega2, rates.omega3, rates.r1_dot},
                       {rates.alpha2, rates.alpha3, rates.r1_ddot});
    }
  }
  check.expect_small();
}

TEST(SliderCrank, FollowsWhenScaledTurnedAndMirrored) {
  Random random(14);
  for (int i = 0; i < 3000; ++i) {
    const SliderCrank linkage = random_slider_crank(random);
    const double theta2 = random.angle();
    const SliderCrankMotion motion = slider_crank_by_crank(linkage, {theta2, 1.3, -0.7}, AssemblyMode::kPlus);
    if (motion.status != LinkageStatus::kOk || std::abs(determinant(linkage, By::kCrank, motion)) < 0.1) {
      continue;
    }
    const SliderCrankRates& rates = motion.rates.value();
    for (const double scale : {1e-6, 1e6}) {
      const SliderCrank scaled{scale * linkage.r2, scale * linkage.r3, scale * linkage.r4, linkage.theta1};
      const auto other = slider_crank_by_crank(scaled, {theta2, 1.3, -0.7}, AssemblyMode::kPlus);
      ASSERT_TRUE(other.rates);
      EXPECT_AT_MOST(relative_error(other.r1 / scale, motion.r1), 1e-13);
      EXPECT_AT_MOST(relative_error(other.rates->alpha3, rates.alpha3), 1e-12);
      EXPECT_AT_MOST(relative_error(other.rates->r1_ddot / scale, rates.r1_ddot), 1e-12);
    }
    SliderCrank turned = linkage;
    turned.theta1 += 2.3;
    const auto after = slider_crank_by_crank(turned, {theta2 + 2.3, 1.3, -0.7}, AssemblyMode::kPlus);
    ASSERT_TRUE(after.rates);
    EXPECT_AT_MOST(angle_error(after.theta3, motion.theta3 + 2.3), 1e-13);
    EXPECT_AT_MOST(relative_error(after.rates->r1_ddot, rates.r1_ddot), 1e-11);
    const SliderCrank mirrored{linkage.r2, linkage.r3, -linkage.r4, -linkage.theta1};
    const auto other = slider_crank_by_crank(mirrored, {-theta2, -1.3, 0.7}, AssemblyMode::kPlus);
    ASSERT_TRUE(other.rates);
    EXPECT_AT_MOST(angle_error(-other.theta3, motion.theta3), 1e-14);
    EXPECT_AT_MOST(relative_error(other.r1, motion.r1), 1e-14);
    EXPECT_AT_MOST(relative_error(-other.rates->alpha3, rates.alpha3), 1e-13);
  }
}

TEST(SliderCrank, LimitAnglesBoundWhatCanBeAssembled) {
  Random random(15);
  for (int i = 0; i < 5000; ++i) {
    const SliderCrank linkage = random_slider_crank(random);
    for (const AssemblyMode mode : kModes) {
      expect_limits_bound(slider_crank_crank_range(linkage), [&](double theta) {
        return slider_crank_by_crank(linkage, {theta, 1, 0}, mode).status;
      });
      expect_limits_bound(slider_crank_coupler_range(linkage), [&](double theta) {
        return slider_crank_by_coupler(linkage, {theta, 1, 0}, mode).status;
      });
      expect_limits_bound(slider_crank_slider_range(linkage), [&](double r1) {
        return slider_crank_by_slider(linkage, {r1, 1, 0}, mode).status;
      });
    }
  }
}

TEST(SliderCrank, LimitsAgreeWithTheSineAndWithPythagoras) {
  Random random(16);
  Worst worst_angle, worst_length;
  for (int i = 0; i < 10000; ++i) {
    const SliderCrank linkage = random_slider_crank(random);
    const long double r2 = linkage.r2, r3 = linkage.r3, r4 = linkage.r4;
    std::vector<double> expected;
    bool near_top = false;
    for (const long double sine : {(r4 - r3) / r2, (r4 + r3) / r2}) {
      near_top = near_top || std::abs(std::abs(sine) - 1) < 1e-4L;
      if (std::abs(sine) > 1) continue;
      expected.push_back(linkage.theta1 + static_cast<double>(std::asin(sine)));
      expected.push_back(linkage.theta1 + kPi - static_cast<double>(std::asin(sine)));
    }
    const DriverRange crank = slider_crank_crank_range(linkage);
    if (near_top) continue;  // asin itself loses its digits there
    ASSERT_EQ(expected.size(), 2 * static_cast<std::size_t>(crank.count));
    for (int k = 0; k < crank.count; ++k) {
      worst_angle.see(distance_to_nearest(crank.intervals[k].begin, expected));
      worst_angle.see(distance_to_nearest(crank.intervals[k].end, expected));
    }

    const DriverRange slider = slider_crank_slider_range(linkage);
    const long double outer = (r2 + r3) * (r2 + r3) - r4 * r4;
    const long double inner = (r2 - r3) * (r2 - r3) - r4 * r4;
    if (std::abs(outer) < 1e-4L || std::abs(inner) < 1e-4L) continue;
    ASSERT_EQ(slider.count, outer < 0 ? 0 : inner > 0 ? 2 : 1);
    if (slider.count == 0) continue;
    worst_length.see(std::abs(slider.intervals[0].begin + static_cast<double>(std::sqrt(outer))));
    if (slider.count == 2) {
      worst_length.see(std::abs(slider.intervals[1].begin - static_cast<double>(std::sqrt(inner))));
    }
  }
  EXPECT_AT_MOST(worst_angle.value(), 1e-14);
  EXPECT_AT_MOST(worst_length.value(), 4e-15);
}

TEST(SliderCrank, TellsFullTurnFromRangesFromNever) {
  EXPECT_EQ(slider_crank_crank_range({2, 5, 0.75, 0.3}).reach, DriverReach::kFullTurn);
  EXPECT_EQ(slider_crank_coupler_range({2, 5, 0.75, 0.3}).reach, DriverReach::kRanges);
  EXPECT_EQ(slider_crank_crank_range({2, 5, 7.5, 0.3}).reach, DriverReach::kNever);
  EXPECT_EQ(slider_crank_slider_range({2, 5, 7.5, 0.3}).reach, DriverReach::kNever);
  EXPECT_EQ(slider_crank_slider_range({2, 5, 0.75, 0.3}).count, 2);
  EXPECT_EQ(slider_crank_slider_range({2, 5, 4, 0.3}).count, 1);
  EXPECT_EQ(slider_crank_crank_range({5, 2, 0, 0}).count, 2);
  EXPECT_EQ(slider_crank_crank_range({5, 2, 4, 0}).count, 1);
}

TEST(SliderCrank, IsAsAccurateAsItsInputNearDeadPoints) {
  if (!kLongDoubleIsLonger) GTEST_SKIP() << "needs a reference with more digits than double";
  Random random(17);
  Worst worst;
  int checked = 0;
  while (checked < 5000) {
    SliderCrank linkage = random_slider_crank(random);
    linkage.theta1 = 0;
    const DriverRange range = slider_crank_crank_range(linkage);
    if (range.count == 0) continue;
    for (const double gap : {1e-9, 1e-6}) {
      const DriverInterval& interval = range.intervals[0];
      if (interval.end - interval.begin < 2 * gap) continue;
      const double theta2 = interval.begin + gap;
      const SliderCrankMotion motion = slider_crank_by_crank(linkage, {theta2, 1, 0}, AssemblyMode::kPlus);
      ASSERT_EQ(motion.status, LinkageStatus::kOk);
      const long double r2 = linkage.r2, r3 = linkage.r3;
      const long double h = linkage.r4 - r2 * std::sin(static_cast<long double>(theta2));
      const auto theta3 = static_cast<double>(std::asin(h / r3));
      const double forced = 2.3e-16 * (std::abs(motion.rates->omega3) * std::abs(theta2) + kPi);
      worst.see(angle_error(motion.theta3, theta3) / forced);
      ++checked;
    }
  }
  EXPECT_AT_MOST(worst.value(), 3);
}

TEST(SliderCrank, SaysSingularWithoutRatesExactlyAtADeadPoint) {
  const SliderCrank linkage{5, 3, 2, 0};
  const SliderCrankMotion across = slider_crank_by_crank(linkage, {kPi / 2, 1, 0}, AssemblyMode::kPlus);
  EXPECT_EQ(across.status, LinkageStatus::kSingular);  // 5 - 2 = 3: the coupler is square to the line
  EXPECT_FALSE(across.rates);
  EXPECT_AT_MOST(closure_error(linkage, across), 1e-15);

  const SliderCrankMotion stretched = slider_crank_by_slider({2, 3, 3, 0}, {4, 1, 0}, AssemblyMode::kMinus);
  EXPECT_EQ(stretched.status, LinkageStatus::kSingular);  // 3, 4, 5
  EXPECT_FALSE(stretched.rates);
  EXPECT_AT_MOST(closure_error({2, 3, 3, 0}, stretched), 1e-15);
}

TEST(SliderCrank, InLineWithEqualLinksMovesTheSliderByTwiceTheCosine) {
  const SliderCrank linkage{1.7, 1.7, 0, 0};
  for (const double theta2 : {0.3, 1.2, kPi / 2 - 1e-6, kPi / 2 - 1e-9}) {
    const SliderCrankMotion motion = slider_crank_by_crank(linkage, {theta2, 2, 0}, AssemblyMode::kPlus);
    ASSERT_TRUE(motion.rates);
    EXPECT_AT_MOST(std::abs(motion.r1 - 3.4 * std::cos(theta2)), 1e-15);
    EXPECT_AT_MOST(std::abs(motion.theta3 + theta2), 4e-15);
    EXPECT_AT_MOST(std::abs(motion.rates->omega3 + 2), 1e-13);
    EXPECT_AT_MOST(std::abs(motion.rates->r1_dot + 6.8 * std::sin(theta2)), 1e-13);
  }
  // Beyond the change point this mode leaves the slider at the crank's pivot.
  EXPECT_AT_MOST(std::abs(slider_crank_by_crank(linkage, {2.1, 2, 0}, AssemblyMode::kPlus).r1), 1e-15);
  EXPECT_EQ(slider_crank_by_crank(linkage, {kPi / 2, 2, 0}, AssemblyMode::kPlus).status,
            LinkageStatus::kSingular);
  EXPECT_EQ(slider_crank_crank_range(linkage).reach, DriverReach::kFullTurn);

  const SliderCrankMotion home = slider_crank_by_slider(linkage, {0, 1, 0}, AssemblyMode::kPlus);
  EXPECT_EQ(home.status, LinkageStatus::kSingular);
  EXPECT_AT_MOST(closure_error(linkage, home), 1e-15);
  const SliderCrankMotion near_home = slider_crank_by_slider(linkage, {1e-9, 1, 0}, AssemblyMode::kPlus);
  ASSERT_TRUE(near_home.rates);
  EXPECT_AT_MOST(std::abs(near_home.theta2 - std::acos(1e-9 / 3.4)), 1e-15);
  EXPECT_AT_MOST(std::abs(near_home.rates->omega2 + 1 / 3.4), 1e-15);
}

TEST(SliderCrank, WithACrankOfNoLengthStandsStill) {
  const SliderCrankMotion motion = slider_crank_by_crank({0, 5, 3, 0}, {0.7, 2, 1}, AssemblyMode::kMinus);
  ASSERT_TRUE(motion.rates);
  EXPECT_AT_MOST(std::abs(motion.r1 + 4), 1e-15);
  EXPECT_EQ(motion.rates->omega3, 0);
  EXPECT_EQ(motion.rates->r1_ddot, 0);
  EXPECT_EQ(slider_crank_crank_range({0, 5, 3, 0}).reach, DriverReach::kFullTurn);
  EXPECT_EQ(slider_crank_crank_range({0, 3, 5, 0}).reach, DriverReach::kNever);
}

}  // namespace
}  // namespace higherpair
