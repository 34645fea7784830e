#include "linkage/scotch_yoke.hpp"

#include "linkage/linkage_testing.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

struct Sample {
  ScotchYoke linkage;
  double beta;
};

Sample random_yoke(Random& random) {
  const double beta = random.between(0.4, kPi - 0.4) * (random.between(-1, 1) > 0 ? 1 : -1);
  return {{random.between(0.2, 3), Rotation<double>::from_angle(beta), random.angle()}, beta};
}

double closure_error(const Sample& sample, const ScotchYokeMotion& motion) {
  const double theta1 = sample.linkage.theta1;
  const auto gap = sample.linkage.r2 * direction(motion.theta2) - motion.r1 * direction(theta1) -
                   motion.r3 * direction(theta1 + sample.beta);
  return std::abs(gap) / sample.linkage.r2;
}

TEST(ScotchYoke, WithAStraightSlotMovesHarmonically) {
  const ScotchYoke linkage{1.7, {0, 1}, 0};
  const double theta = 2.2, omega = 3.1, alpha = -0.9;
  const ScotchYokeMotion motion = scotch_yoke_by_crank(linkage, {theta, omega, alpha});
  ASSERT_TRUE(motion.rates);
  EXPECT_AT_MOST(std::abs(motion.r1 - 1.7 * std::cos(theta)), 1e-15);
  EXPECT_AT_MOST(std::abs(motion.r3 - 1.7 * std::sin(theta)), 1e-15);
  EXPECT_AT_MOST(std::abs(motion.rates->r1_dot + 1.7 * omega * std::sin(theta)), 4e-15);
  const double r1_ddot = -1.7 * (alpha * std::sin(theta) + omega * omega * std::cos(theta));
  EXPECT_AT_MOST(std::abs(motion.rates->r1_ddot - r1_ddot), 1e-14);
}

TEST(ScotchYoke, ClosesItsLoopInTheNamedModeForBothDrivers) {
  Random random(31);
  Worst worst;
  for (int i = 0; i < 10000; ++i) {
    const Sample sample = random_yoke(random);
    worst.see(closure_error(sample, scotch_yoke_by_crank(sample.linkage, {random.angle(), 1, 0})));
    for (const AssemblyMode mode : kModes) {
      const auto motion = scotch_yoke_by_yoke(sample.linkage, {random.between(-3, 3), 1, 0}, mode);
      if (motion.status != LinkageStatus::kOk) continue;
      worst.see(closure_error(sample, motion));
      EXPECT_GT(sign(mode) * std::cos(motion.theta2 - sample.linkage.theta1 - sample.beta), 0);
    }
  }
  EXPECT_AT_MOST(worst.value(), 1e-14);
}

TEST(ScotchYoke, RatesAreTheDerivativesOfPositions) {
  Random random(32);
  RatesCheck check;
  while (check.count() < 4000) {
    const Sample sample = random_yoke(random);
    const double q = random.between(-3, 3), q_dot = random.between(-1.5, 1.5), q_ddot = random.between(-2, 2);
    const AssemblyMode mode = mode_of(check.count() % 2 == 0 ? 1 : -1);
    for (const bool by_yoke : {false, true}) {
      const auto solve = [&](double at, double rate, double second) {
        return by_yoke ? scotch_yoke_by_yoke(sample.linkage, {at, rate, second}, mode)
                       : scotch_yoke_by_crank(sample.linkage, {at, rate, second});
      };
      const ScotchYokeMotion motion = solve(q, q_dot, q_ddot);
      if (motion.status != LinkageStatus::kOk) continue;
      const double cosine = std::cos(motion.theta2 - sample.linkage.theta1 - sample.beta);
      if (by_yoke && (std::abs(cosine) < 0.5 || sample.linkage.r2 < 0.6)) continue;
      const auto values_at = [&](double t) {
        const auto there = solve(q + q_dot * t + q_ddot * t * t / 2, 0, 0);
        return std::array<double, 3>{there.theta2, there.r1, there.r3};
      };
      const ScotchYokeRates& rates = motion.rates.value();
      check.compare<3>(values_at, {true, false, false}, {rates.omega2, rates.r1_dot, rates.r3_dot},
                       {rates.alpha2, rates.r1_ddot, rates.r3_ddot});
    }
  }
  check.expect_small();
}

TEST(ScotchYoke, DrivenByItsYokeUndoesDrivenByItsCrank) {
  Random random(33);
  for (int i = 0; i < 3000; ++i) {
    const Sample sample = random_yoke(random);
    const ScotchYokeMotion forth = scotch_yoke_by_crank(sample.linkage, {random.angle(), 1.3, -0.7});
    const double cosine = std::cos(forth.theta2 - sample.linkage.theta1 - sample.beta);
    if (std::abs(cosine) < 0.2) continue;
    for (const double scale : {1.0, 1e-6, 1e6}) {
      ScotchYoke scaled = sample.linkage;
      scaled.r2 *= scale;
      const SlideMotion yoke{scale * forth.r1, scale * forth.rates->r1_dot, scale * forth.rates->r1_ddot};
      const ScotchYokeMotion back = scotch_yoke_by_yoke(scaled, yoke, mode_of(cosine > 0 ? 1 : -1));
      ASSERT_TRUE(back.rates);
      EXPECT_AT_MOST(angle_error(back.theta2, forth.theta2), 1e-13);
      EXPECT_AT_MOST(relative_error(back.r3 / scale, forth.r3), 1e-13);
      EXPECT_AT_MOST(relative_error(back.rates->omega2, 1.3), 1e-12);
      EXPECT_AT_MOST(relative_error(back.rates->alpha2, -0.7), 1e-11);
      EXPECT_AT_MOST(relative_error(back.rates->r3_ddot / scale, forth.rates->r3_ddot), 1e-11);
    }
  }
}

TEST(ScotchYoke, LimitsBoundWhereTheYokeCanGo) {
  Random random(34);
  EXPECT_EQ(scotch_yoke_crank_range({1.7, {0, 1}, 0}).reach, DriverReach::kFullTurn);
  for (int i = 0; i < 3000; ++i) {
    const Sample sample = random_yoke(random);
    const DriverRange range = scotch_yoke_yoke_range(sample.linkage);
    ASSERT_EQ(range.count, 1);
    const double limit = range.intervals[0].end;
    EXPECT_AT_MOST(relative_error(limit * std::abs(std::sin(sample.beta)), sample.linkage.r2), 1e-15);
    for (const AssemblyMode mode : kModes) {
      const auto status_at = [&](double r1) {
        return scotch_yoke_by_yoke(sample.linkage, {r1, 1, 0}, mode).status;
      };
      for (const double side : {limit, -limit}) {
        EXPECT_EQ(status_at(side), LinkageStatus::kSingular);
        EXPECT_EQ(status_at(side * (1 - 4e-15)), LinkageStatus::kOk);
        EXPECT_EQ(status_at(side * (1 + 4e-15)), LinkageStatus::kNotAssemblable);
      }
    }
  }
}

TEST(ScotchYoke, HasPositionButNoRatesAtItsLimit) {
  const Sample sample{{1.7, {0, 1}, 0.3}, kPi / 2};
  const ScotchYokeMotion motion = scotch_yoke_by_yoke(sample.linkage, {1.7, 1, 0}, AssemblyMode::kPlus);
  EXPECT_EQ(motion.status, LinkageStatus::kSingular);
  EXPECT_FALSE(motion.rates);
  EXPECT_AT_MOST(closure_error(sample, motion), 1e-15);
  EXPECT_AT_MOST(angle_error(motion.theta2, 0.3), 1e-15);
}

TEST(ScotchYoke, AnInputThatIsNotANumberIsNotAssemblable) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(scotch_yoke_by_crank({1.7, {0, 1}, 0}, {nan, 1, 0}).status, LinkageStatus::kNotAssemblable);
  EXPECT_EQ(scotch_yoke_by_yoke({1.7, {0, 1}, 0}, {nan, 1, 0}, AssemblyMode::kPlus).status,
            LinkageStatus::kNotAssemblable);
}

}  // namespace
}  // namespace higherpair
