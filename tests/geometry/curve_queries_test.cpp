#include "higherpair/geometry/curve_queries.hpp"

#include "contact/support_curves.hpp"
#include "higherpair/geometry/arc_length.hpp"
#include "higherpair/geometry/known_rotation.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

const Curve kOval = make_ellipse(Vector2d(0.003, -0.001), {0.05, 0.02}, 0.4).value();

TEST(RadiusBounds, OfAWholeCurveAreThoseOfItsSharpestAndFlattestPoints) {
  EXPECT_NEAR(radius_bounds(kOval).low, 0.02 * 0.02 / 0.05, 1e-17);
  EXPECT_NEAR(radius_bounds(kOval).high, 0.05 * 0.05 / 0.02, 1e-15);
  Curve ring = kOval;
  ring.side = Side::kOutside;
  EXPECT_EQ(radius_bounds(ring).low, -radius_bounds(kOval).high);
  EXPECT_EQ(radius_bounds(ring).high, -radius_bounds(kOval).low);
  const Curve parabola = make_parabola(Vector2d::Zero(), 0.03, 0).value();
  EXPECT_EQ(radius_bounds(parabola).low, 0.06);
  EXPECT_EQ(radius_bounds(parabola).high, kInfinity);
  EXPECT_EQ(radius_bounds(make_line(Vector2d::Zero(), Vector2d::UnitX()).value()).low, kInfinity);
  EXPECT_EQ(radius_bounds(make_point(Vector2d::Zero()).value()).high, 0);
}

TEST(RadiusBounds, OverAnArcOfNormalsHoldTheSamplesInIt) {
  const testing::EllipseBySupport twin(Vector2d(0.003, -0.001), 0.05, 0.02, 0.4);
  const testing::EllipseBySupport hole(Vector2d(0.003, -0.001), 0.05, 0.02, 0.4, true);
  Curve ring = kOval;
  ring.side = Side::kOutside;
  for (const Curve& curve : {kOval, ring, make_curve(twin), make_curve(hole)}) {
    const PlacedCurve<double> placed = place(curve, Pose<double>{Rotation<double>::from_angle(1.1), {1, 2}});
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.1 * i;
      const double half = 0.7 / (1 + i % 7);
      const Bounds rho = radius_bounds(placed, unit_vector(middle), Rotation<double>::from_angle(half));
      double low = kInfinity, high = -kInfinity;
      for (int k = -20; k <= 20; ++k) {
        const double sample = support_point(placed, unit_vector(middle + half * k / 20)).rho;
        low = std::min(low, sample);
        high = std::max(high, sample);
      }
      EXPECT_LE(rho.low, low + 1e-12);
      EXPECT_GE(rho.high, high - 1e-12);
      EXPECT_LE(rho.width(), 1.2 * (high - low) + 1e-3);
    }
  }
}

TEST(Reach, IsToTheFarthestPointAndNoneOfOpenCurves) {
  const Vector2d p(0.1, 0.07);
  double farthest = 0;
  for (int i = 0; i < 3600; ++i) {
    farthest = std::max(
        farthest, (support_point(place(kOval, Pose<double>{}), unit_vector(i * kPi / 1800)).p_W - p).norm());
  }
  const testing::EllipseBySupport twin(Vector2d(0.003, -0.001), 0.05, 0.02, 0.4);
  for (const Curve& curve : {kOval, make_curve(twin)}) {
    EXPECT_GE(*reach_from(curve, p), farthest);
    EXPECT_LE(*reach_from(curve, p), 1.3 * farthest);
  }
  EXPECT_EQ(reach_from(make_point(Vector2d(3, 4)).value(), Vector2d::Zero()), 5);
  EXPECT_FALSE(reach_from(make_parabola(Vector2d::Zero(), 0.03, 0).value(), p));
  EXPECT_FALSE(reach_from(make_line(Vector2d::Zero(), Vector2d::UnitX()).value(), p));
}

TEST(RoundCurves, HaveACentreAboutWhichTheyMayTurn) {
  const Curve disc = make_circle(Vector2d(0.1, 0.2), 0.03).value();
  EXPECT_LE((*round_center(disc) - Vector2d(0.1, 0.2)).norm(), 1e-17);
  EXPECT_TRUE(is_centered_at(disc, Vector2d(0.1, 0.2), 0.3));
  EXPECT_FALSE(is_centered_at(disc, Vector2d(0.1 + 1e-12, 0.2), 0.3));
  EXPECT_EQ(*round_center(make_point(Vector2d(0.1, 0.2)).value()), Vector2d(0.1, 0.2));
  EXPECT_FALSE(round_center(kOval));
  EXPECT_LE((*middle_of(kOval) - Vector2d(0.003, -0.001)).norm(), 1e-17);
  EXPECT_FALSE(middle_of(make_parabola(Vector2d::Zero(), 0.03, 0).value()));
  const Curve face = make_line(Vector2d::Zero(), Vector2d(0, 1)).value();
  EXPECT_TRUE(slides_along_itself(face, Rotation<double>::from_angle(0.3), unit_vector(0.3)));
  EXPECT_FALSE(slides_along_itself(face, Rotation<double>::from_angle(0.3), unit_vector(0.31)));
}

TEST(Normals, OfOpenCurvesAreACone) {
  EXPECT_FALSE(normals_of(place(kOval, Pose<double>{})));
  const Curve hyperbola = make_hyperbola(Vector2d::Zero(), {0.03, 0.04}, 0.2).value();
  const auto cone = normals_of(place(hyperbola, Pose<double>{}));
  ASSERT_TRUE(cone);
  EXPECT_NEAR(std::abs(nearest_turn(cone->middle - 0.2, kPi)), kPi, 1e-15);
  EXPECT_NEAR(cone->half, std::atan(0.03 / 0.04), 1e-15);
  const testing::InvoluteBySupport involute(0.02, {0.5, 2});
  const auto arc = normals_of(place(make_curve(involute), Pose<double>{}));
  ASSERT_TRUE(arc);
  EXPECT_EQ(arc->middle, 1.25);
  EXPECT_EQ(arc->half, 0.75);
}

TEST(ArcToNormal, IsThatOfTheSameCurveByItsSupport) {
  const testing::EllipseBySupport twin(Vector2d(0.003, -0.001), 0.05, 0.02, 0.4);
  const double start = arc_to_normal(kOval, 0);
  for (int i = -30; i <= 30; ++i) {
    EXPECT_NEAR(arc_to_normal(make_curve(twin), 0.37 * i), arc_to_normal(kOval, 0.37 * i) - start, 1e-14);
  }
  Curve ring = kOval;
  ring.side = Side::kOutside;
  // With reversed sense and normal.
  EXPECT_NEAR(arc_to_normal(ring, 1 + kPi), -arc_to_normal(kOval, 1), 1e-16);
  const testing::InvoluteBySupport involute(0.02, {0, 3});
  EXPECT_NEAR(arc_to_normal(make_curve(involute), 2), 0.02 * 2, 1e-17);
}

TEST(SizeOfACurve, ScalesWithIt) {
  const testing::EllipseBySupport small(Vector2d(0.003, -0.001), 0.05, 0.02, 0.4);
  const testing::EllipseBySupport large(Vector2d(3, -1), 50, 20, 0.4);
  EXPECT_GT(size_of(make_curve(small)), 0);
  EXPECT_NEAR(size_of(make_curve(large)) / size_of(make_curve(small)), 1000, 1e-9);
  EXPECT_EQ(size_of(kOval), kOval.semi_latus);
  EXPECT_EQ(size_of(make_point(Vector2d(1, 1)).value()), 0);
}

TEST(AngleBetween, IsThatOfTheArcTangentNearAndFar) {
  for (int i = -40; i <= 40; ++i) {
    const double angle = 3.1 * i * std::abs(i) / 1600;
    EXPECT_NEAR(angle_between(unit_vector(0.7), unit_vector(0.7 + angle)), angle, 1e-15);
  }
}

// y² = 2 ℓ x: s = (y √(1 + y²) + asinh y)/2 in units of ℓ; near the vertex also for points that rounding has
// moved off the curve.
TEST(ArcToPoint, OfAParabolaIsThatOfItsClosedForm) {
  constexpr double kSemiLatus = 0.06;
  const Curve parabola = make_parabola(Vector2d::Zero(), kSemiLatus / 2, 0).value();
  for (const double y : {0.0, 1e-17, -1e-12, 1e-8, -1e-3, 0.5, -1.4, 1.42, -3.0, 1e3, -1e6}) {
    const double arc = (y * std::sqrt(1 + y * y) + std::asinh(y)) / 2 * kSemiLatus;
    for (const double off : {0.0, -1e-17, 1e-17}) {
      const Vector2d p = kSemiLatus * Vector2d(y * y / 2, -y) + Vector2d(off, 0);
      EXPECT_NEAR(arc_to_point(parabola, p), arc, 4e-16 * (1 + std::abs(arc))) << y << ' ' << off;
    }
  }
}

TEST(ArcToPoint, OfAHyperbolaIsThatToItsNormal) {
  const Curve hyperbola = make_hyperbola(Vector2d::Zero(), {0.03, 0.02}, 0).value();
  for (const double y : {0.0, -1e-9, 1e-4, -0.01, 0.02, -0.5, 20.0}) {
    const Vector2d p(0.03 * std::sqrt(1 + y * y / 4e-4), -y);
    // The gradient of y²/b² - x²/a² points out of the body.
    const Vector2d n(-p.x() / 9e-4, p.y() / 4e-4);
    const double arc = arc_to_normal(hyperbola, nearest_turn(angle_of(n), kPi));
    EXPECT_NEAR(arc_to_point(hyperbola, p), arc, 1e-9 * y * y + 1e-15) << y;
  }
}

}  // namespace
}  // namespace higherpair
