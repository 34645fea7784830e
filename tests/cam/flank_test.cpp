// Which laws have a flank, and where it would fail: closed forms and dense samples of the exact derivatives.
#include "higherpair/cam/flank.hpp"

#include "cam/law_testing.hpp"
#include "geometry/arc_testing.hpp"
#include "higherpair/geometry/arc_polyline.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

OneFreedom slide_at(double offset) {
  OneFreedom freedom;
  freedom.turns = false;
  freedom.p_WO = {offset, 0};
  freedom.direction_W = Vector2d::UnitY();
  return freedom;
}

// A flat face at this height: the flank's radius of curvature is height + s + s″.
CamMotion flat(double height, const MotionLaw& law) {
  return {OneFreedom(), 1, slide_at(0), 1, height, law};
}

const Curve kFace = *make_line({0, 0}, {0, -1});

// A wave of this order and amplitude.
MotionLaw wave(std::size_t order, double amplitude) {
  LawSegment segment{LawType::kHarmonics, 2 * kPi};
  segment.sines.resize(order);
  segment.sines.back() = amplitude;
  return testing::law_of({segment}, true);
}

// s = c sin kx: the radius d - c (k² - 1) sin kx vanishes first at sin kx = d / (c (k² - 1)).
TEST(Flank, OfAWaveIsUndercutFromTheFirstPlaceOnWhateverItsOrder) {
  constexpr double kHeight = 0.031;
  for (const std::size_t k : {2U, 7U, 32U, 48U, 64U, 65U, 96U}) {
    const double order = static_cast<double>(k);
    const double level = (order * order - 1) / kHeight;
    for (const double excess : {1.05, 1.0001}) {
      const auto spans = cam_flank(flat(kHeight, wave(k, excess / level)), kFace, false);
      ASSERT_FALSE(spans) << k;
      EXPECT_EQ(spans.error().kind, FlankFault::Kind::kUndercut);
      EXPECT_NEAR(spans.error().coordinate, std::asin(1 / excess) / order, 1e-10) << k;
    }
    EXPECT_TRUE(cam_flank(flat(kHeight, wave(k, 0.9999 / level)), kFace, false)) << k;
  }
}

TEST(Flank, OfOrdinaryLawsIsUndercutHoweverNarrowThePlace) {
  for (const LawType type : {LawType::kCycloidal, LawType::kModifiedSine, LawType::kModifiedTrapezoid,
                             LawType::kPolynomial345, LawType::kPolynomial4567}) {
    for (const double over : {1.09, 1.4, 2.37}) {
      const MotionLaw law = testing::law_of({{type, over, 0.019},
                                             {LawType::kDwell, kPi - over},
                                             {LawType::kCycloidal, 1.75, -0.006},
                                             {LawType::kCycloidal, kPi - 1.75, -0.013}},
                                            true);
      constexpr int kMany = 100000;
      const auto radius = [&](int i) {
        const double x = 2 * kPi * i / kMany;
        return law(x) + law.derivative(2, x);
      };
      double least = 0;
      for (int i = 0; i < kMany; ++i) least = std::min(least, radius(i));
      for (const double depth : {1e-3, 1e-7}) {
        const auto spans = cam_flank(flat(-least - depth * 0.019, law), kFace, false);
        ASSERT_FALSE(spans) << static_cast<int>(type) << " over " << over;
        int first = 0;
        while (radius(first) > least + depth * 0.019) ++first;
        EXPECT_NEAR(spans.error().coordinate, 2 * kPi * first / kMany, 2 * kPi / kMany);
      }
      EXPECT_TRUE(cam_flank(flat(-least + 1e-7, law), kFace, false));
    }
  }
}

// A knife edge that passes beside the cam's pivot, so that the normal of its path passes over the pivot: the
// flank is that path.
TEST(Flank, GoesOnWhereItsNormalPassesThePivot) {
  const MotionLaw law =
      testing::law_of({{LawType::kCycloidal, kPi, -0.012}, {LawType::kCycloidal, kPi, 0.012}}, true);
  const auto spans = cam_flank({OneFreedom(), 1, slide_at(0.003), 1, 0.005, law}, *make_point({0, 0}), false);
  ASSERT_TRUE(spans);
  double least = 0;  // height of the tangent above the pivot
  for (const SpanPtr& span : *spans) {
    const Bounds range = span->range();
    for (int k = 1; k < 200; ++k) {
      const double t = range.low + range.width() * k / 200;
      const double x = flank_coordinate(*span, t).value();
      const SpanPoint point = span->at(t);
      const Vector2d edge = Rotation<double>::from_angle(-x) * Vector2d(0.003, 0.005 + law(x));
      EXPECT_LE((point.p_B - edge).norm(), 1e-17);
      EXPECT_GT(point.speed, 0);
      // Along t, with the material on the left.
      const Vector2d step = span->at(t + 1e-6).p_B - span->at(t - 1e-6).p_B;
      EXPECT_NEAR(step.normalized().dot(perp(point.n_B)), 1, 1e-9);
      least = std::min(least, point.p_B.dot(point.n_B));
    }
  }
  EXPECT_LT(least, -0.001);
}

TEST(Flank, OfAWaveIsDrawnWithAllItsLobes) {
  const auto spans = cam_flank(flat(0.02, wave(32, 1e-5)), kFace, false);
  ASSERT_TRUE(spans);
  const Boundary flank = testing::boundary(*spans, true);
  EXPECT_LE(testing::worst_distance(flank, arc_polyline(flank, 2e-7)), 2e-7);
}

}  // namespace
}  // namespace higherpair
