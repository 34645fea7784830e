#include "higherpair/linkage/rrp_dyad.hpp"

#include "linkage/inverted_slider_crank.hpp"
#include "linkage/moving_ends.hpp"
#include "linkage/scotch_yoke.hpp"
#include "linkage/slider_crank.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

TEST(RrpDyad, JoinsAMovingPointToAMovingGuideAndMovesByTheDerivatives) {
  Random random(63);
  Worst closure;
  RatesCheck check;
  for (int i = 0; check.count() < 4000; ++i) {
    const MovingPoint A = random_point(random);
    const MovingGuide guide = random_guide(random);
    const double r = random.between(0.2, 2);
    const AssemblyMode mode = alternating(i);
    const RrpMotion motion = rrp_dyad(A.at(0), guide.at(0), r, mode);
    if (motion.status != LinkageStatus::kOk) continue;

    const Vector2d u = vector_of(motion.u_link), u_guide = vector_of(guide.at(0).u);
    closure.see((A.at(0).p_W + r * u - guide.at(0).P.p_W - motion.s * u_guide).norm());
    closure.see((A.at(0).p_W + r * u - motion.p_WC).norm());
    closure.see(std::abs(u.norm() - 1));
    EXPECT_GT(sign(mode) * u.dot(u_guide), 0);
    if (std::abs(u.dot(u_guide)) < 0.5) continue;

    const auto values_at = [&](double t) {
      const RrpMotion there = rrp_dyad(A.at(t), guide.at(t), r, mode);
      return std::array<double, 4>{angle_of(there.u_link), there.s, there.p_WC.x(), there.p_WC.y()};
    };
    const RrpMotion::Rates& rates = motion.rates.value();
    check.compare<4>(values_at, {true, false, false, false},
                     {rates.omega, rates.s_dot, rates.v_WC.x(), rates.v_WC.y()},
                     {rates.alpha, rates.s_ddot, rates.a_WC.x(), rates.a_WC.y()});
  }
  // s itself can be several metres, and its rounding enters twice.
  EXPECT_AT_MOST(closure.value(), 1e-14);
  check.expect_small();
}

/// Tolerance relative to the largest possible rate of a linkage at least halfway from a dead point.
void expect_rates(double omega, double expected_omega, double alpha, double expected_alpha) {
  EXPECT_AT_MOST(relative_error(omega, expected_omega), 2e-13);
  EXPECT_AT_MOST(relative_error(alpha, expected_alpha), 2e-12);
}

TEST(RrpDyad, IsASliderCrankAlsoOnAMovingFrame) {
  Random random(65);
  for (int i = 0, compared = 0; compared < 3000; ++i) {
    const SliderCrank linkage{random.between(0.2, 3), random.between(0.2, 3), random.between(-2, 2),
                              random.angle()};
    const AngleMotion crank{random.angle(), random.between(-2, 2), random.between(-2, 2)};
    const SliderCrankMotion expected = slider_crank_by_crank(linkage, crank, alternating(i));
    if (!expected.rates || std::abs(std::cos(expected.theta3 - linkage.theta1)) < 0.5) continue;
    ++compared;

    const PointMotion A = point_motion(turning(crank), Vector2d(linkage.r2, 0));
    const Vector2d foot = linkage.r4 * perp(unit_vector(linkage.theta1));
    for (const BodyMotion& frame : {resting(), random_body(random).at(0)}) {
      const GuideMotion guide = guide_motion(frame, foot, Rotation<double>::from_angle(linkage.theta1));
      const RrpMotion motion = rrp_dyad(carried(frame, A), guide, linkage.r3, alternating(i));
      ASSERT_TRUE(motion.rates);
      EXPECT_AT_MOST(angle_error(angle_of(motion.u_link), expected.theta3 + frame.theta), 2e-14);
      EXPECT_AT_MOST(relative_error(motion.s, expected.r1), 2e-14);
      expect_rates(motion.rates->omega, expected.rates->omega3 + frame.omega, motion.rates->alpha,
                   expected.rates->alpha3 + frame.alpha);
      expect_rates(motion.rates->s_dot, expected.rates->r1_dot, motion.rates->s_ddot,
                   expected.rates->r1_ddot);
    }
  }
}

TEST(RrpDyad, IsAnInvertedSliderCrankDrivenByItsSlot) {
  Random random(66);
  for (int i = 0, compared = 0; compared < 3000; ++i) {
    const InvertedSliderCrank linkage{random.between(0.2, 3), random.between(0.2, 3), random.between(-1, 1),
                                      random.angle()};
    const AngleMotion slot{random.angle(), random.between(-2, 2), random.between(-2, 2)};
    const auto expected = inverted_slider_crank_by_slot(linkage, slot, alternating(i));
    if (!expected.rates || std::abs(std::cos(expected.theta2 - expected.theta3)) < 0.5) continue;
    ++compared;

    // The slot's body turns about O2, the origin; the foot of the slot's line is r4 to the left.
    const GuideMotion guide = guide_motion(turning(slot), Vector2d(0, linkage.r4), {1, 0});
    const PointMotion O1 = point_motion(resting(), -linkage.r1 * unit_vector(linkage.theta1));
    const RrpMotion motion = rrp_dyad(O1, guide, linkage.r2, alternating(i));
    ASSERT_TRUE(motion.rates);
    EXPECT_AT_MOST(angle_error(angle_of(motion.u_link), expected.theta2), 2e-14);
    EXPECT_AT_MOST(relative_error(motion.s, expected.r3), 2e-14);
    expect_rates(motion.rates->omega, expected.rates->omega2, motion.rates->alpha, expected.rates->alpha2);
    expect_rates(motion.rates->s_dot, expected.rates->r3_dot, motion.rates->s_ddot, expected.rates->r3_ddot);
  }
}

TEST(RrpDyad, IsAScotchYokeDrivenByItsYoke) {
  Random random(67);
  for (int i = 0, compared = 0; compared < 3000; ++i) {
    const double beta = random.between(0.3, kPi - 0.3), theta1 = random.angle();
    const ScotchYoke linkage{random.between(0.2, 3), Rotation<double>::from_angle(beta), theta1};
    const SlideMotion yoke{random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)};
    const ScotchYokeMotion expected = scotch_yoke_by_yoke(linkage, yoke, alternating(i));
    if (!expected.rates || std::abs(std::cos(expected.theta2 - theta1 - beta)) < 0.5) continue;
    ++compared;

    const Vector2d along = unit_vector(theta1);
    const GuideMotion guide{{yoke.r * along, yoke.r_dot * along, yoke.r_ddot * along},
                            Rotation<double>::from_angle(theta1 + beta),
                            0,
                            0};
    const RrpMotion motion = rrp_dyad(PointMotion{}, guide, linkage.r2, alternating(i));
    ASSERT_TRUE(motion.rates);
    EXPECT_AT_MOST(angle_error(angle_of(motion.u_link), expected.theta2), 2e-14);
    EXPECT_AT_MOST(relative_error(motion.s, expected.r3), 2e-14);
    expect_rates(motion.rates->omega, expected.rates->omega2, motion.rates->alpha, expected.rates->alpha2);
    expect_rates(motion.rates->s_dot, expected.rates->r3_dot, motion.rates->s_ddot, expected.rates->r3_ddot);
  }
}

PointMotion mirrored_scaled(const PointMotion& point, double k) {
  const auto change = [&](const Vector2d& v) { return Vector2d(k * v.x(), -k * v.y()); };
  return {change(point.p_W), change(point.v_W), change(point.a_W)};
}

TEST(RrpDyad, FollowsWhenMirroredAndScaled) {
  Random random(68);
  for (int i = 0; i < 2000; ++i) {
    const PointMotion A = random_point(random).at(0);
    const GuideMotion guide = random_guide(random).at(0);
    const double r = random.between(0.2, 2);
    const RrpMotion motion = rrp_dyad(A, guide, r, alternating(i));
    for (const double k : {1e-6, 1.0, 1e6}) {
      const GuideMotion other_guide{mirrored_scaled(guide.P, k), guide.u.inverse(), -guide.omega,
                                    -guide.alpha};
      const RrpMotion other = rrp_dyad(mirrored_scaled(A, k), other_guide, k * r, alternating(i));
      ASSERT_EQ(other.status, motion.status);
      if (!motion.rates || motion.reach.slack() < 0.1 * r) continue;
      EXPECT_AT_MOST(angle_error(angle_of(other.u_link), -angle_of(motion.u_link)), 1e-14);
      EXPECT_AT_MOST(relative_error(other.s / k, motion.s), 1e-14);
      EXPECT_AT_MOST(relative_error(other.rates->alpha, -motion.rates->alpha), 2e-12);
      EXPECT_AT_MOST(relative_error(other.rates->s_ddot / k, motion.rates->s_ddot), 2e-12);
    }
  }
}

TEST(RrpDyad, TellsEachStatus) {
  // A is 3 m left of a guide along 0.6, 0.8 through (1, 2).
  const GuideMotion guide{{{1, 2}, {3, 4}, {5, 6}}, {0.6, 0.8}, 0.7, 0.9};
  const Vector2d foot = Vector2d(1, 2) + 2.5 * Vector2d(0.6, 0.8);
  const PointMotion A{foot + 3 * Vector2d(-0.8, 0.6), {1, 2}, {3, 4}};
  EXPECT_EQ(rrp_dyad(A, guide, 3.1, AssemblyMode::kMinus).status, LinkageStatus::kOk);
  const RrpMotion short_link = rrp_dyad(A, guide, 2.9, AssemblyMode::kMinus);
  EXPECT_EQ(short_link.status, LinkageStatus::kNotAssemblable);
  EXPECT_AT_MOST(std::abs(short_link.reach.slack() + 0.1), 1e-14);
  const RrpMotion limit = rrp_dyad(A, guide, 3, AssemblyMode::kMinus);
  EXPECT_EQ(limit.status, LinkageStatus::kSingular);
  EXPECT_FALSE(limit.rates);
  EXPECT_AT_MOST((limit.p_WC - foot).norm(), 4e-15);
  // Half of the digits are lost in the direction in which the link may still move.
  EXPECT_AT_MOST(std::abs(limit.s - 2.5), 1e-7);
}

TEST(RrpDyad, FarFromTheOriginIsAtItsLimitToWithinTheRoundingOfItsPlace) {
  for (const double y : {1e4 / 3, 1e6 / 3, 1e8 / 3}) {
    for (const double r : {1.1, 1.3, 1.7, 2.3}) {
      const GuideMotion guide{{{5 * y, y}, {3, 4}, {5, 6}}, {1, 0}, 0.7, 0.9};
      const PointMotion A{{5 * y, y + r}, {1, 2}, {3, 4}};
      EXPECT_EQ(rrp_dyad(A, guide, r, AssemblyMode::kPlus).status, LinkageStatus::kSingular);
    }
  }
}

}  // namespace
}  // namespace higherpair
