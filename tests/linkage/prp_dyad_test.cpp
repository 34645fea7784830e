#include "higherpair/linkage/prp_dyad.hpp"

#include "linkage/moving_ends.hpp"
#include "linkage/scotch_yoke.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

TEST(PrpDyad, LiesWhereTwoMovingGuidesCrossAndMovesByTheDerivatives) {
  Random random(81);
  Worst closure;
  RatesCheck check;
  while (check.count() < 4000) {
    const MovingGuide guide1 = random_guide(random), guide2 = random_guide(random);
    const PrpMotion motion = prp_dyad(guide1.at(0), guide2.at(0));
    ASSERT_EQ(motion.status, LinkageStatus::kOk);
    if (std::abs(motion.sine) < 0.5) continue;
    for (const auto& [guide, s] : {std::pair{guide1.at(0), motion.s1}, std::pair{guide2.at(0), motion.s2}}) {
      closure.see((guide.P.p_W + s * vector_of(guide.u) - motion.p_WC).norm());
    }

    const auto values_at = [&](double t) {
      const PrpMotion there = prp_dyad(guide1.at(t), guide2.at(t));
      return std::array<double, 5>{there.s1, there.s2, there.p_WC.x(), there.p_WC.y(), there.sine};
    };
    const PrpMotion::Rates& rates = motion.rates.value();
    const Derivatives<5> expected = differentiate<5>(values_at, {}, 0.002);
    EXPECT_AT_MOST(std::abs(motion.sine_rate - expected.first[4]), 1e-11);
    check.compare<5>(values_at, {},
                     {rates.s1_dot, rates.s2_dot, rates.v_WC.x(), rates.v_WC.y(), motion.sine_rate},
                     {rates.s1_ddot, rates.s2_ddot, rates.a_WC.x(), rates.a_WC.y(), expected.second[4]});
  }
  EXPECT_AT_MOST(closure.value(), 1e-14);
  check.expect_small();
}

TEST(PrpDyad, DoesNotCareWhichGuideIsNamedFirst) {
  Random random(82);
  Worst worst;
  for (int i = 0; i < 3000; ++i) {
    const GuideMotion guide1 = random_guide(random).at(0), guide2 = random_guide(random).at(0);
    const PrpMotion one = prp_dyad(guide1, guide2), other = prp_dyad(guide2, guide1);
    if (std::abs(one.sine) < 0.3) continue;
    EXPECT_EQ(one.sine, -other.sine);
    worst.see(relative_error(one.s1, other.s2) + relative_error(one.s2, other.s1));
    worst.see(relative_error(one.rates->s1_ddot, other.rates->s2_ddot));
    worst.see((one.rates->a_WC - other.rates->a_WC).norm() / std::max(1.0, one.rates->a_WC.norm()));
  }
  EXPECT_AT_MOST(worst.value(), 2e-12);
}

TEST(PrpDyad, OnAMovingFrameIsTheSplitOfAVectorThatMovesInIt) {
  // An RPP group: a crank pin, a block in the yoke's slot, and the yoke on its guide.
  Random random(83);
  for (int i = 0; i < 3000; ++i) {
    const double beta = random.between(0.3, kPi - 0.3), theta1 = random.angle();
    const ScotchYoke linkage{random.between(0.2, 3), Rotation<double>::from_angle(beta), theta1};
    const AngleMotion crank{random.angle(), random.between(-2, 2), random.between(-2, 2)};
    const ScotchYokeMotion expected = scotch_yoke_by_crank(linkage, crank);
    const PointMotion pin = point_motion(turning(crank), Vector2d(linkage.r2, 0));
    for (const BodyMotion& frame : {resting(), random_body(random).at(0)}) {
      const GuideMotion guide = guide_motion(frame, Vector2d::Zero(), Rotation<double>::from_angle(theta1));
      const PrpMotion motion = prp_dyad(guide, guide_through(carried(frame, pin), guide, linkage.slot));
      ASSERT_TRUE(motion.rates);
      EXPECT_EQ(motion.sine_rate, 0);
      EXPECT_AT_MOST(relative_error(motion.s1, expected.r1), 4e-14);
      EXPECT_AT_MOST(relative_error(-motion.s2, expected.r3), 4e-14);
      EXPECT_AT_MOST(relative_error(motion.rates->s1_dot, expected.rates->r1_dot), 2e-13);
      EXPECT_AT_MOST(relative_error(-motion.rates->s2_dot, expected.rates->r3_dot), 2e-13);
      EXPECT_AT_MOST(relative_error(motion.rates->s1_ddot, expected.rates->r1_ddot), 2e-12);
      EXPECT_AT_MOST(relative_error(-motion.rates->s2_ddot, expected.rates->r3_ddot), 2e-12);
    }
  }
}

TEST(PrpDyad, IsTheEllipticTrammelInItsFixedCross) {
  // Both guides turn together about the origin at ω: a cross through the pivot keeps its centre, so that the
  // pin stays in place whatever the motion.
  for (const double angle : {0.3, 1.9, -2.2}) {
    const BodyMotion cross_body = turning({angle, 1.7, -0.4});
    const PrpMotion motion =
        prp_dyad(guide_motion(cross_body, {0.7, 0}, {1, 0}), guide_motion(cross_body, {0, -1.1}, {0, 1}));
    ASSERT_TRUE(motion.rates);
    EXPECT_AT_MOST(motion.p_WC.norm() + motion.rates->v_WC.norm() + motion.rates->a_WC.norm(), 1e-14);
    EXPECT_AT_MOST(std::abs(motion.s1 + 0.7) + std::abs(motion.s2 - 1.1), 1e-15);
    EXPECT_AT_MOST(std::abs(motion.rates->s1_dot) + std::abs(motion.rates->s2_ddot), 1e-14);
  }
}

TEST(PrpDyad, FollowsWhenMirroredAndScaled) {
  Random random(84);
  for (int i = 0; i < 2000; ++i) {
    const GuideMotion guide1 = random_guide(random).at(0), guide2 = random_guide(random).at(0);
    const PrpMotion motion = prp_dyad(guide1, guide2);
    if (std::abs(motion.sine) < 0.2) continue;
    for (const double k : {1e-6, 1.0, 1e6}) {
      const auto change = [&](const GuideMotion& guide) {
        const auto flip = [&](const Vector2d& v) { return Vector2d(k * v.x(), -k * v.y()); };
        return GuideMotion{{flip(guide.P.p_W), flip(guide.P.v_W), flip(guide.P.a_W)},
                           guide.u.inverse(),
                           -guide.omega,
                           -guide.alpha};
      };
      const PrpMotion other = prp_dyad(change(guide1), change(guide2));
      ASSERT_TRUE(other.rates);
      EXPECT_AT_MOST(relative_error(other.s1 / k, motion.s1), 1e-13);
      EXPECT_AT_MOST(relative_error(other.rates->s2_dot / k, motion.rates->s2_dot), 1e-12);
      EXPECT_AT_MOST(relative_error(other.rates->s1_ddot / k, motion.rates->s1_ddot), 1e-11);
    }
  }
}

TEST(PrpDyad, ParallelGuidesMeetNowhereOrEverywhere) {
  const GuideMotion guide{{{1, 2}, {3, 4}, {5, 6}}, {0.6, 0.8}, 0.7, 0.9};
  for (const double turn : {1.0, -1.0}) {
    GuideMotion other = guide;
    other.u = {turn * 0.6, turn * 0.8};
    other.omega = 0.2;
    other.P.p_W += Vector2d(-0.8, 0.6);
    const PrpMotion apart = prp_dyad(guide, other);
    EXPECT_EQ(apart.status, LinkageStatus::kNotAssemblable);
    EXPECT_EQ(apart.sine, 0);
    EXPECT_AT_MOST(std::abs(apart.sine_rate + turn * 0.5), 1e-15);

    other.P.p_W = Vector2d(1, 2) + 1e-13 * Vector2d(-0.8, 0.6);
    EXPECT_EQ(prp_dyad(guide, other).status, LinkageStatus::kNotAssemblable);

    other.P.p_W = Vector2d(1, 2) + 2.5 * Vector2d(0.6, 0.8);
    const PrpMotion coincident = prp_dyad(guide, other);
    EXPECT_EQ(coincident.status, LinkageStatus::kSingular);
    EXPECT_FALSE(coincident.rates);
    EXPECT_AT_MOST(std::abs(coincident.s1 - 2.5) + std::abs(coincident.s2), 1e-14);
    EXPECT_EQ(coincident.p_WC, other.P.p_W);
  }
}

}  // namespace
}  // namespace higherpair
