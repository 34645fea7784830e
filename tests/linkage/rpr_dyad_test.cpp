#include "higherpair/linkage/rpr_dyad.hpp"

#include "linkage/inverted_slider_crank.hpp"
#include "linkage/moving_ends.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

TEST(RprDyad, JoinsTwoMovingPinsAndMovesByTheDerivatives) {
  Random random(71);
  Worst closure;
  RatesCheck check;
  for (int i = 0; check.count() < 4000; ++i) {
    const MovingPoint A = random_point(random), B = random_point(random);
    const double e = random.between(-0.8, 0.8);
    const AssemblyMode mode = alternating(i);
    const RprMotion motion = rpr_dyad(A.at(0), B.at(0), e, mode);
    if (motion.status != LinkageStatus::kOk) continue;

    const Vector2d u = vector_of(motion.u), D = B.at(0).p_W - A.at(0).p_W;
    closure.see((D - motion.s * u - e * perp(u)).norm());
    closure.see(std::abs(u.norm() - 1));
    EXPECT_GT(sign(mode) * motion.s, 0);
    // The direction has a branch point at D = 0: the steps of the differences have to be small compared with
    // D.
    if (std::abs(motion.s) < 0.5 * D.norm() || D.norm() < 0.3) continue;

    const auto values_at = [&](double t) {
      const RprMotion there = rpr_dyad(A.at(t), B.at(t), e, mode);
      return std::array<double, 2>{angle_of(there.u), there.s};
    };
    const RprMotion::Rates& rates = motion.rates.value();
    check.compare<2>(values_at, {true, false}, {rates.omega, rates.s_dot}, {rates.alpha, rates.s_ddot});
  }
  EXPECT_AT_MOST(closure.value(), 4e-15);
  check.expect_small();
}

TEST(RprDyad, IsAnInvertedSliderCrankAlsoOnAMovingFrame) {
  Random random(73);
  for (int i = 0, compared = 0; compared < 3000; ++i) {
    const InvertedSliderCrank linkage{random.between(0.2, 3), random.between(0.2, 3), random.between(-1, 1),
                                      random.angle()};
    const AngleMotion crank{random.angle(), random.between(-2, 2), random.between(-2, 2)};
    const auto expected = inverted_slider_crank_by_crank(linkage, crank, alternating(i));
    if (!expected.rates || std::abs(expected.r3) < 0.5) continue;
    ++compared;

    const PointMotion O2{linkage.r1 * unit_vector(linkage.theta1), Vector2d::Zero(), Vector2d::Zero()};
    const PointMotion pin = point_motion(turning(crank), Vector2d(linkage.r2, 0));
    for (const BodyMotion& frame : {resting(), random_body(random).at(0)}) {
      const RprMotion motion = rpr_dyad(carried(frame, O2), carried(frame, pin), linkage.r4, alternating(i));
      ASSERT_TRUE(motion.rates);
      EXPECT_AT_MOST(angle_error(angle_of(motion.u), expected.theta3 + frame.theta), 2e-14);
      EXPECT_AT_MOST(relative_error(motion.s, expected.r3), 2e-14);
      EXPECT_AT_MOST(relative_error(motion.rates->omega, expected.rates->omega3 + frame.omega), 2e-13);
      EXPECT_AT_MOST(relative_error(motion.rates->alpha, expected.rates->alpha3 + frame.alpha), 2e-12);
      EXPECT_AT_MOST(relative_error(motion.rates->s_dot, expected.rates->r3_dot), 2e-13);
      EXPECT_AT_MOST(relative_error(motion.rates->s_ddot, expected.rates->r3_ddot), 2e-12);
    }
  }
}

TEST(RprDyad, FollowsWhenMirroredAndScaled) {
  Random random(74);
  for (int i = 0; i < 2000; ++i) {
    const PointMotion A = random_point(random).at(0), B = random_point(random).at(0);
    const double e = random.between(-1, 1);
    const RprMotion motion = rpr_dyad(A, B, e, alternating(i));
    for (const double k : {1e-6, 1.0, 1e6}) {
      const auto change = [&](const PointMotion& point) {
        const auto flip = [&](const Vector2d& v) { return Vector2d(k * v.x(), -k * v.y()); };
        return PointMotion{flip(point.p_W), flip(point.v_W), flip(point.a_W)};
      };
      const RprMotion other = rpr_dyad(change(A), change(B), -k * e, alternating(i));
      ASSERT_EQ(other.status, motion.status);
      if (!motion.rates || std::abs(motion.s) < 0.1) continue;
      EXPECT_AT_MOST(angle_error(angle_of(other.u), -angle_of(motion.u)), 1e-14);
      EXPECT_AT_MOST(relative_error(other.s / k, motion.s), 1e-14);
      EXPECT_AT_MOST(relative_error(other.rates->alpha, -motion.rates->alpha), 1e-11);
      EXPECT_AT_MOST(relative_error(other.rates->s_ddot / k, motion.rates->s_ddot), 1e-11);
    }
  }
}

TEST(RprDyad, TellsEachStatus) {
  const PointMotion A{{1, 2}, {1, 2}, {3, 4}}, B{{4, 6}, {-1, 2}, {3, -4}};  // 5 m apart
  for (const double side : {1.0, -1.0}) {
    EXPECT_EQ(rpr_dyad(A, B, side * 4.9, AssemblyMode::kPlus).status, LinkageStatus::kOk);
    EXPECT_EQ(rpr_dyad(A, B, side * 5.1, AssemblyMode::kPlus).status, LinkageStatus::kNotAssemblable);
    const RprMotion limit = rpr_dyad(A, B, side * 5, AssemblyMode::kPlus);
    EXPECT_EQ(limit.status, LinkageStatus::kSingular);
    EXPECT_FALSE(limit.rates);
    EXPECT_AT_MOST((side * perp(vector_of(limit.u)) - Vector2d(0.6, 0.8)).norm(), 1e-15);
  }
}

TEST(RprDyad, APinThatMeetsTheOtherIsAChangePoint) {
  const PointMotion A{{1, 2}, {1, 2}, {3, 4}};
  PointMotion B = A;
  B.v_W.x() += 1;
  const RprMotion motion = rpr_dyad(A, B, 0, AssemblyMode::kPlus);
  EXPECT_EQ(motion.status, LinkageStatus::kSingular);
  EXPECT_EQ(motion.s, 0);
  EXPECT_EQ(vector_of(motion.u), Vector2d(1, 0));
  EXPECT_EQ(rpr_dyad(A, B, 0.1, AssemblyMode::kPlus).status, LinkageStatus::kNotAssemblable);
  // An offset within the rounding of the points is none.
  EXPECT_EQ(rpr_dyad(A, B, 1e-16, AssemblyMode::kPlus).status, LinkageStatus::kSingular);
}

}  // namespace
}  // namespace higherpair
