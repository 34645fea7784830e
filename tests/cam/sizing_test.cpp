// The sizes of cams: published worked examples, closed forms, and flanks generated with the sizes found,
// whose pressure angles and curvatures must be at the limit.
#include "higherpair/cam/sizing.hpp"

#include "cam/law_testing.hpp"

#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

constexpr double kDeg = kPi / 180;

// Dwell, rise by 1, dwell and return, each over 90 degrees.
MotionLaw four_quarters(LawType type) {
  const double quarter = kPi / 2;
  return testing::law_of(
      {{LawType::kDwell, quarter}, {type, quarter, 1}, {LawType::kDwell, quarter}, {type, quarter, -1}},
      true);
}

OneFreedom turning(const Vector2d& pivot = Vector2d::Zero()) {
  OneFreedom freedom;
  freedom.p_WO = pivot;
  return freedom;
}

OneFreedom sliding(double offset = 0) {
  OneFreedom freedom;
  freedom.turns = false;
  freedom.p_WO = {offset, 0};
  freedom.direction_W = Vector2d::UnitY();
  return freedom;
}

FlankOrigin cam_of(const OneFreedom& follower, double sign, double rest, const MotionLaw& law,
                   const Curve& curve) {
  return {{turning(), 1, follower, sign, rest, law}, curve, false};
}

FlankOrigin roller_cam(const MotionLaw& law, double rest, double radius, double offset = 0) {
  return cam_of(sliding(offset), 1, rest, law, make_circle({0, 0}, radius).value());
}

FlankOrigin flat_cam(const MotionLaw& law, double rest) {
  return cam_of(sliding(), 1, rest, law, make_line({0, 0}, {0, -1}).value());
}

// A roller at the end of an arm of 3, whose pivot is 4 from the cam's.
FlankOrigin swinging_cam(const MotionLaw& law, double rest, double radius) {
  return cam_of(turning({4, 0}), -1, rest, law, make_circle({-3, 0}, radius).value());
}

// Largest and smallest curvature of a flank, sampled so densely that they are off by about 1e-7.
Bounds curvatures_of(const FlankOrigin& cam) {
  const auto spans = cam_flank(cam.motion, cam.curve, cam.outer);
  if (!spans) {
    ADD_FAILURE() << "undercut at " << spans.error().coordinate;
    return {};
  }
  Bounds bounds{1e9, -1e9};
  for (const SpanPtr& span : *spans) {
    for (int i = 0; i <= 20000; ++i) {
      const double kappa = span->at(std::lerp(span->range().low, span->range().high, i / 20000.0)).kappa;
      bounds = {std::min(bounds.low, kappa), std::max(bounds.high, kappa)};
    }
  }
  return bounds;
}

// Norton's cam example, as computed by the package `mechanism` of gabemorris12.
TEST(CamSizing, GivesThePublishedPrimeCircleOfACycloidalCam) {
  const FlankOrigin cam = roller_cam(four_quarters(LawType::kCycloidal), 2, 0.5);
  const auto size = smallest_for_pressure(cam, {30 * kDeg, 30 * kDeg});
  ASSERT_TRUE(size);
  EXPECT_NEAR(size->radius, 1.750944530, 5e-10);
  EXPECT_NEAR(size->base_radius, 1.250944530, 5e-10);
  EXPECT_NEAR(size->at / kDeg - 90, 40.893, 5e-4);
  // The radius is the largest value of d = s′/tan α - s: there its derivative along the law is 0.
  const MotionLaw& law = cam.motion.law;
  EXPECT_NEAR(law.derivative(2, size->at) / std::tan(30 * kDeg), law.derivative(1, size->at), 1e-11);
  EXPECT_NEAR(law.derivative(1, size->at) / std::tan(30 * kDeg) - law(size->at), size->radius, 1e-14);

  const FlankOrigin sized = roller_cam(law, size->rest, 0.5);
  EXPECT_NEAR(largest_center_pressure(sized)->value / kDeg, 30, 1e-12);
  EXPECT_NEAR(largest_center_pressure(sized)->at, size->at, 1e-9);
  const CamPlace curvature = largest_pitch_curvature(sized).value();
  EXPECT_NEAR(1 / curvature.value, 1.394110, 5e-7);
  EXPECT_NEAR(curvature.at / kDeg - 90, 66.423, 5e-4);
}

TEST(CamSizing, GivesThePublishedOffsetOfAFreeGuide) {
  const FlankOrigin cam = roller_cam(four_quarters(LawType::kCycloidal), 2, 0.5);
  const auto size = smallest_with_offset(cam, {30 * kDeg, 45 * kDeg});
  ASSERT_TRUE(size);
  EXPECT_NEAR(size->radius, 1.225614472, 5e-10);
  EXPECT_NEAR(size->offset, 0.329322519, 5e-10);
  EXPECT_NEAR(std::hypot(size->offset, size->rest), size->radius, 1e-15);
  // With the guide already at this offset the same radius is needed.
  const auto there =
      smallest_for_pressure(roller_cam(cam.motion.law, 2, 0.5, size->offset), {30 * kDeg, 45 * kDeg});
  EXPECT_NEAR(there->radius, size->radius, 1e-12);
  // A cam that turns the other way needs the opposite offset, with the limits of rise and return exchanged.
  const auto other = smallest_with_offset(cam, {30 * kDeg, 45 * kDeg, -1});
  EXPECT_NEAR(other->offset, -size->offset, 1e-12);
  EXPECT_NEAR(other->radius, size->radius, 1e-12);
}

TEST(CamSizing, GivesThePublishedBaseCircleOfAFlatFace) {
  const auto size = smallest_for_radius(flat_cam(four_quarters(LawType::kCycloidal), 2), {0.25});
  ASSERT_TRUE(size);
  EXPECT_NEAR(size->base_radius, 1.892631279, 5e-10);
  EXPECT_NEAR(size->rest, size->base_radius, 1e-15);
}

// s = h/2 (1 - cos 2x): ρ = r + s + s″ = r + h/2 + 3/2 h cos 2x, which is at least r - h.
TEST(CamSizing, OfAHarmonicLawUnderAFlatFaceIsTheClosedForm) {
  const auto size = smallest_for_radius(flat_cam(four_quarters(LawType::kHarmonic), 7), {0.31});
  EXPECT_NEAR(size->base_radius, 1.31, 1e-13);
}

// A harmonic rise over half a turn under a flat face: the cam is a circle about a point beside the pivot.
TEST(CamSizing, OfASimpleHarmonicLawGivesACircle) {
  const MotionLaw law =
      testing::law_of({{LawType::kHarmonic, kPi, 0.050}, {LawType::kHarmonic, kPi, -0.050}}, true);
  const auto size = smallest_for_radius(flat_cam(law, 1), {0.025});
  // ρ = r + h/2 everywhere: with a minimum radius of 25 the base circle may shrink to 0.
  EXPECT_NEAR(size->base_radius, 0, 1e-15);
  const auto spans = cam_flank(flat_cam(law, 0.025).motion, make_line({0, 0}, {0, -1}).value(), false);
  ASSERT_TRUE(spans);
  for (const SpanPtr& span : *spans) {
    for (const double share : {0.0, 0.21, 0.5, 0.83, 1.0}) {
      const SpanPoint point = span->at(std::lerp(span->range().low, span->range().high, share));
      EXPECT_NEAR(1 / point.kappa, 0.050, 1e-15);
      EXPECT_NEAR((point.p_B - 0.050 * point.n_B - Vector2d(0, -0.025)).norm(), 0, 1e-15);
    }
  }
}

TEST(CamSizing, ForARadiusGivesAFlankThatHasIt) {
  for (const LawType type : {LawType::kCycloidal, LawType::kModifiedSine, LawType::kPolynomial4567}) {
    const RadiusLimits limits{0.25, 3.1};
    FlankOrigin cam = roller_cam(four_quarters(type), 3, 0.5);
    cam.motion.follower_rest = smallest_for_radius(cam, limits)->rest;
    const Bounds bounds = curvatures_of(cam);
    EXPECT_NEAR(std::max(bounds.high * limits.convex, -bounds.low * limits.concave), 1, 1e-6);
    EXPECT_LE(bounds.high * limits.convex, 1 + 1e-12);
    EXPECT_LE(-bounds.low * limits.concave, 1 + 1e-12);
  }
}

TEST(CamSizing, WithoutUndercutGivesTheLastFlankThatCanBe) {
  FlankOrigin cam = roller_cam(four_quarters(LawType::kCycloidal), 3, 0.9);
  const double rest = smallest_for_radius(cam, {})->rest;
  cam.motion.follower_rest = rest * (1 + 1e-6);
  EXPECT_TRUE(cam_flank(cam.motion, cam.curve, false));
  cam.motion.follower_rest = rest * (1 - 1e-3);
  const auto fault = cam_flank(cam.motion, cam.curve, false);
  ASSERT_FALSE(fault);
  EXPECT_EQ(fault.error().kind, FlankFault::Kind::kUndercut);
  // Where the flank begins to run backwards the pitch curve has the roller's own curvature.
  EXPECT_NEAR(fault.error().coordinate, smallest_for_radius(cam, {})->at, 0.1);
}

TEST(CamSizing, OfTheLargestRollerGivesTheRadiusAskedFor) {
  const MotionLaw law = four_quarters(LawType::kCycloidal);
  const auto largest = largest_follower(roller_cam(law, 1.75, 0.5), 0.2);
  ASSERT_TRUE(largest);
  const Bounds bounds = curvatures_of(roller_cam(law, 1.75, largest->value));
  EXPECT_NEAR(1 / bounds.high, 0.2, 1e-6);
  EXPECT_GE(1 / bounds.high, 0.2 * (1 - 1e-12));
}

TEST(CamSizing, OfASwingingRollerIsAtTheLimitAndNotSmaller) {
  const MotionLaw law = testing::law_of({{LawType::kDwell, 1.5},
                                         {LawType::kCycloidal, 1.6, 0.4},
                                         {LawType::kDwell, 1.5},
                                         {LawType::kCycloidal, 2 * kPi - 4.6, -0.4}},
                                        true);
  FlankOrigin cam = swinging_cam(law, 0.6, 0.3);
  const auto size = smallest_for_pressure(cam, {32 * kDeg, 32 * kDeg});
  ASSERT_TRUE(size);
  cam.motion.follower_rest = size->rest;
  EXPECT_NEAR(largest_center_pressure(cam)->value / kDeg, 32, 1e-11);
  EXPECT_NEAR(size_of(cam)->radius, size->radius, 1e-15);
  // Law of cosines between the pivots.
  EXPECT_NEAR(size->radius, std::sqrt(25 - 24 * std::cos(size->rest)), 1e-14);
  cam.motion.follower_rest = size->rest - 1e-3;
  EXPECT_GT(largest_center_pressure(cam)->value / kDeg, 32);

  const auto round = smallest_for_radius(cam, {0.2, 1.5});
  ASSERT_TRUE(round);
  cam.motion.follower_rest = round->rest;
  const Bounds bounds = curvatures_of(cam);
  EXPECT_NEAR(std::max(bounds.high * 0.2, -bounds.low * 1.5), 1, 1e-6);
}

TEST(CamSizing, OfASwingingFaceGivesAFlankThatHasTheRadius) {
  const MotionLaw law = testing::law_of({{LawType::kDwell, 1.5},
                                         {LawType::kCycloidal, 1.9, 0.2},
                                         {LawType::kDwell, 1.1},
                                         {LawType::kCycloidal, 2 * kPi - 4.5, -0.2}},
                                        true);
  FlankOrigin cam = cam_of(turning({4, 0}), -1, 0.35, law, make_line({0, -0.1}, {0, -1}).value());
  const auto size = smallest_for_radius(cam, {0.15});
  ASSERT_TRUE(size);
  cam.motion.follower_rest = size->rest;
  EXPECT_NEAR(1 / curvatures_of(cam).high, 0.15, 1e-6);
}

// A follower whose coordinate is counted downwards has the lifts of the opposite law; one below the cam moves
// as one above it, seen after half a turn.
TEST(CamSizing, DoesNotDependOnWhereTheFollowerIsAndHowItIsCounted) {
  for (const double rise : {1.0, -1.0}) {
    const auto law = [](double by) {
      const double quarter = kPi / 2;
      return testing::law_of({{LawType::kDwell, quarter},
                              {LawType::kCycloidal, quarter, by},
                              {LawType::kDwell, quarter},
                              {LawType::kCycloidal, quarter, -by}},
                             true);
    };
    const Curve roller = *make_circle({0, 0}, 0.5), face = *make_line({0, 0}, {0, -1});
    const Curve face_below = *make_line({0, 0}, {0, 1});
    const double of_roller =
        smallest_for_pressure(cam_of(sliding(), 1, 3, law(rise), roller), {30 * kDeg, 45 * kDeg})->radius;
    const double of_face = smallest_for_radius(cam_of(sliding(), 1, 3, law(rise), face), {0.25})->base_radius;
    for (const auto& [rest, by, below] : {std::tuple(-3, -rise, false), std::tuple(3, rise, true)}) {
      const auto other =
          smallest_for_pressure(cam_of(sliding(), -1, rest, law(by), roller), {30 * kDeg, 45 * kDeg});
      const auto other_face =
          smallest_for_radius(cam_of(sliding(), -1, rest, law(by), below ? face_below : face), {0.25});
      ASSERT_TRUE(other && other_face);
      EXPECT_NEAR(other->radius, of_roller, 1e-12);
      EXPECT_NEAR(other_face->base_radius, of_face, 1e-12);
    }
  }
}

TEST(CamSizing, OfAMirroredSwingingFaceIsTheSame) {
  const MotionLaw law = testing::law_of(
      {{LawType::kDwell, 2}, {LawType::kCycloidal, 1.9, 0.2}, {LawType::kCycloidal, 2 * kPi - 3.9, -0.2}},
      true);
  const Curve face = *make_line({0, -0.1}, {0, -1});
  const FlankOrigin cam = cam_of(turning({4, 0}), -1, 0.35, law, face);
  const FlankOrigin mirrored{{turning(), -1, turning({-4, 0}), 1, 0.35, law}, face, false};
  const auto size = smallest_for_radius(cam, {0.15}), other = smallest_for_radius(mirrored, {0.15});
  ASSERT_TRUE(size && other);
  EXPECT_NEAR(other->rest, size->rest, 1e-12);
  EXPECT_NEAR(other->base_radius, size->base_radius, 1e-12);
}

TEST(CamSizing, OfAnOuterFlankIsBeyondTheRoller) {
  FlankOrigin cam = roller_cam(four_quarters(LawType::kCycloidal), 2, 0.5);
  EXPECT_EQ(size_of(cam)->base_radius, 1.5);
  cam.outer = true;
  EXPECT_EQ(size_of(cam)->base_radius, 2.5);
}

TEST(CamSizing, ScalesWithTheCam) {
  for (const double scale : {1e-4, 1e3}) {
    MotionLaw law = testing::law_of({{LawType::kDwell, kPi / 2},
                                     {LawType::kCycloidal, kPi / 2, scale},
                                     {LawType::kDwell, kPi / 2},
                                     {LawType::kCycloidal, kPi / 2, -scale}},
                                    true);
    const FlankOrigin cam = roller_cam(law, 2 * scale, 0.5 * scale);
    EXPECT_NEAR(smallest_for_pressure(cam, {30 * kDeg, 30 * kDeg})->radius / scale, 1.750944530030, 1e-11);
    EXPECT_NEAR(smallest_with_offset(cam, {30 * kDeg, 45 * kDeg})->offset / scale, 0.329322519342, 1e-11);
  }
}

TEST(CamSizing, IsNoneForOtherFollowersAndCamsThatSlide) {
  const MotionLaw law = four_quarters(LawType::kCycloidal);
  FlankOrigin ellipse = roller_cam(law, 2, 0.5);
  ellipse.curve = make_ellipse({0, 0}, {0.5, 0.3}, 0).value();
  EXPECT_FALSE(size_of(ellipse));
  EXPECT_FALSE(largest_center_pressure(ellipse));
  EXPECT_FALSE(smallest_for_radius(ellipse, {}));
  EXPECT_FALSE(largest_follower(ellipse, 0));
  FlankOrigin slide = roller_cam(law, 2, 0.5);
  slide.motion.cam = sliding();
  slide.motion.cam.direction_W = Vector2d::UnitX();
  EXPECT_FALSE(smallest_for_pressure(slide, {0.5, 0.5}));
  EXPECT_FALSE(smallest_with_offset(slide, {0.5, 0.5}));
  EXPECT_FALSE(smallest_with_offset(swinging_cam(law, 1, 0.3), {0.5, 0.5}));
  // With a sliding cam the tangent of the pressure angle is s′.
  EXPECT_NEAR(std::tan(largest_center_pressure(slide)->value), 4 / kPi, 1e-12);
}

TEST(CamSizing, IsNoneWhereNoSizeKeepsTheLimit) {
  // An arm of 3 that swings by 0.9 rad while the cam turns by 0.9 rad.
  const MotionLaw law =
      testing::law_of({{LawType::kCycloidal, 0.9, 0.9}, {LawType::kCycloidal, 2 * kPi - 0.9, -0.9}}, true);
  EXPECT_FALSE(smallest_for_pressure(swinging_cam(law, 0.6, 0.3), {5 * kDeg, 5 * kDeg}));
}

}  // namespace
}  // namespace higherpair
