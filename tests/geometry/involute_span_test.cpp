#include "higherpair/geometry/involute_span.hpp"

#include "geometry/span_testing.hpp"

namespace higherpair {
namespace {

Involute example(Hand hand) {
  return {{0.003, -0.002}, 0.0231, 0.7, hand, {0.05, 1.31}};
}

TEST(InvoluteSpan, ItsRadiusOfCurvatureIsTheStringThatIsUnwound) {
  for (const Hand hand : {Hand::kLeft, Hand::kRight}) {
    const Involute involute = example(hand);
    const SpanPtr span = involute_span(involute);
    const double sense = hand == Hand::kRight ? 1 : -1;
    for (const double roll : {0.05, 0.3, 0.777, 1.31}) {
      const SpanPoint point = span->at(sense * roll);
      const double rho = involute.base_radius * roll;
      EXPECT_NEAR(point.kappa * rho, 1, 1e-14);
      // The centre of curvature is on the base circle, where the string leaves it.
      const Vector2d foot = point.p_B - rho * point.n_B - involute.center_B;
      EXPECT_NEAR(foot.norm(), involute.base_radius, 1e-16);
      EXPECT_NEAR(foot.dot(point.n_B), 0, 1e-16);
      EXPECT_NEAR(angle_of(foot), involute.start + sense * roll, 1e-13);
      EXPECT_NEAR(point.speed, rho, 1e-16);
    }
  }
}

TEST(InvoluteSpan, NormalAndCurvaturesAreDerivativesOfThePoints) {
  testing::expect_span_laws(*involute_span(example(Hand::kLeft)), 0.002, 1e-6);
  testing::expect_span_laws(*involute_span(example(Hand::kRight)), 0.002, 1e-6);
}

TEST(InvoluteSpan, HandsAreSidesOfAToothSeenFromTheCentre) {
  const InvoluteTooth tooth = {0.002, 23, 20 * kPi / 180, 0.1};
  Involute flank;
  flank.base_radius = base_radius(tooth);
  flank.roll = {0.1, roll_at_tip(tooth)};
  const double upwards = kPi / 2;
  flank.hand = Hand::kLeft;
  flank.start = upwards + half_angle_at_base(tooth);
  const SpanPtr left = involute_span(flank);
  flank.hand = Hand::kRight;
  flank.start = upwards - half_angle_at_base(tooth);
  const SpanPtr right = involute_span(flank);
  const SpanPoint l = left->at(left->range().low);
  const SpanPoint r = right->at(right->range().high);
  EXPECT_LT(l.n_B.x(), 0);
  EXPECT_GT(r.n_B.x(), 0);
  EXPECT_LT(l.p_B.x(), r.p_B.x());
  EXPECT_NEAR(l.p_B.x(), -r.p_B.x(), 1e-16);  // one is the mirror image of the other
  EXPECT_NEAR(l.p_B.y(), r.p_B.y(), 1e-16);
  EXPECT_NEAR(r.p_B.norm(), 0.002 * (23 / 2.0 + 1.1), 1e-15);  // the tip circle
}

TEST(InvoluteTooth, IsAsThickAtThePitchCircleAsItsRackSays) {
  const InvoluteTooth tooth = {0.003, 17, 20 * kPi / 180, 0.25};
  Involute flank;
  flank.base_radius = base_radius(tooth);
  flank.hand = Hand::kRight;
  flank.start = -half_angle_at_base(tooth);
  flank.roll = {0.01, 1};
  const double at_pitch = std::tan(tooth.pressure_angle);  // roll where |p| = r/cos α
  const Vector2d p = involute_span(flank)->at(at_pitch).p_B;
  const double pitch_radius = 0.003 * 17 / 2;
  EXPECT_NEAR(p.norm(), pitch_radius, 1e-16);
  const double thickness = -2 * angle_of(p) * pitch_radius;
  EXPECT_NEAR(thickness, 0.003 * (kPi / 2 + 2 * 0.25 * std::tan(tooth.pressure_angle)), 1e-16);
}

TEST(InvoluteTooth, IsUndercutByARackBelowSeventeenTeeth) {
  const double limit = 2 / std::pow(std::sin(20 * kPi / 180), 2);  // 17.0973
  EXPECT_NEAR(roll_at_root({1, limit, 20 * kPi / 180, 0}), 0, 1e-15);
  EXPECT_LT(roll_at_root({1, 17, 20 * kPi / 180, 0}), 0);
  EXPECT_GT(roll_at_root({1, 18, 20 * kPi / 180, 0}), 0);
  EXPECT_GT(roll_at_root({1, 17, 20 * kPi / 180, 0.1}), 0);
}

}  // namespace
}  // namespace higherpair
