#include "higherpair/contact/conic_intersections.hpp"

#include "contact/random_pair.hpp"
#include "higherpair/geometry/support.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

const Pose<double> kHere;

Pose<double> pose(double angle, double x, double y) {
  return {Rotation<double>::from_angle(angle), {x, y}};
}

std::vector<ConicIntersection> sorted(std::vector<ConicIntersection> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return std::make_pair(a.p_W.x(), a.p_W.y()) < std::make_pair(b.p_W.x(), b.p_W.y());
  });
  return points;
}

TEST(Intersections, OfTwoCirclesAreTwo) {
  const Curve a = make_circle({0, 0}, 1.5).value();
  const Curve b = make_circle({0.2, 0}, 1.1).value();
  const auto found = intersect_conics(a, kHere, b, pose(0, 1.8, 0));
  ASSERT_EQ(found.points.size(), 2U);
  const double x = (4.0 + 1.5 * 1.5 - 1.1 * 1.1) / 4;
  for (const ConicIntersection& each : found.points) {
    EXPECT_NEAR(each.p_W.x(), x, 1e-15 * 4);
    EXPECT_NEAR(std::abs(each.p_W.y()), std::sqrt(1.5 * 1.5 - x * x), 1e-15 * 4);
    EXPECT_EQ(each.multiplicity, 1);
  }
  EXPECT_LT(found.points[0].p_W.y() * found.points[1].p_W.y(), 0);
}

TEST(Intersections, OfCrossedEllipsesAreFour) {
  const Curve ellipse = make_ellipse({0, 0}, {2, 0.5}, 0).value();
  const auto found = intersect_conics(ellipse, kHere, ellipse, pose(kPi / 2, 0, 0));
  ASSERT_EQ(found.points.size(), 4U);
  // x² = y² and x²/4 + 4 x² = 1
  const double x = std::sqrt(1 / 4.25);
  for (const ConicIntersection& each : found.points) {
    EXPECT_NEAR(std::abs(each.p_W.x()), x, 1e-15);
    EXPECT_NEAR(std::abs(each.p_W.y()), x, 1e-15);
  }
}

TEST(Intersections, OfSeparateAndOfNestedConicsAreNone) {
  const Curve ellipse = make_ellipse({0, 0}, {2, 0.5}, 0.3).value();
  const Curve circle = make_circle({0, 0}, 0.2).value();
  EXPECT_TRUE(intersect_conics(ellipse, kHere, circle, kHere).points.empty());
  EXPECT_TRUE(intersect_conics(ellipse, kHere, circle, pose(0, 9, 3)).points.empty());
  EXPECT_EQ(intersect_conics(ellipse, kHere, circle, kHere).status, IntersectionStatus::kPoints);
}

TEST(Intersections, AreThreeWhereOneIsATangency) {
  // y = x² - 1 touches the unit circle at (0, -1) and cuts it at (±1, 0).
  const Curve parabola = make_parabola({0, -1}, 0.25, kPi / 2).value();
  const Curve circle = make_circle({0, 0}, 1).value();
  const auto points = sorted(intersect_conics(parabola, kHere, circle, kHere).points);
  ASSERT_EQ(points.size(), 3U);
  EXPECT_NEAR((points[0].p_W - Vector2d(-1, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((points[1].p_W - Vector2d(0, -1)).norm(), 0, 1e-7);
  EXPECT_NEAR((points[2].p_W - Vector2d(1, 0)).norm(), 0, 1e-15);
  EXPECT_EQ(points[0].multiplicity, 1);
  EXPECT_EQ(points[1].multiplicity, 2);
}

TEST(Intersections, WithTheCircleOfCurvatureCountFourAtAVertexAndThreeElsewhere) {
  const Curve ellipse = make_ellipse({0, 0}, {2, 1}, 0).value();
  const auto at_vertex = intersect_conics(ellipse, kHere, make_circle({1.5, 0}, 0.5).value(), kHere);
  ASSERT_EQ(at_vertex.points.size(), 1U);
  EXPECT_EQ(at_vertex.points[0].multiplicity, 4);
  EXPECT_NEAR((at_vertex.points[0].p_W - Vector2d(2, 0)).norm(), 0, 1e-3);
  const SupportPoint<double> s = support_point(place(ellipse, kHere), unit_vector(0.7));
  const Vector2d center = s.p_W - s.rho * unit_vector(0.7);
  const auto elsewhere = intersect_conics(ellipse, kHere, make_circle(center, s.rho).value(), kHere);
  ASSERT_EQ(elsewhere.points.size(), 2U);
  EXPECT_EQ(elsewhere.points[0].multiplicity + elsewhere.points[1].multiplicity, 4);
  EXPECT_EQ(std::max(elsewhere.points[0].multiplicity, elsewhere.points[1].multiplicity), 3);
}

TEST(Intersections, OfAConicWithItselfAreNotPoints) {
  const Curve ellipse = make_ellipse({0.3, 0.1}, {2, 1}, 0.4).value();
  const Curve turned = make_ellipse({0.3, 0.1}, {2, 1}, 0.4 - kPi).value();
  const auto found = intersect_conics(ellipse, pose(0.3, 1, 2), turned, pose(0.3, 1, 2));
  EXPECT_EQ(found.status, IntersectionStatus::kCoincident);
}

TEST(Intersections, OnABranchThatDoesNotExistAreLeftOut) {
  const Curve hyperbola = make_hyperbola({0, 0}, {1, 1}, 0).value();
  const Curve circle = make_circle({0, 0}, 2).value();
  const auto points = sorted(intersect_conics(hyperbola, kHere, circle, kHere).points);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[0].p_W.x(), std::sqrt(2.5), 1e-15 * 4);
  EXPECT_EQ(intersect_conics(circle, kHere, hyperbola, kHere).points.size(), 2U);
}

TEST(Intersections, WithALineAreRefused) {
  const Curve line = make_line({0, 0}, {0, 1}).value();
  const Curve circle = make_circle({0, 0}, 2).value();
  EXPECT_EQ(intersect_conics(circle, kHere, line, kHere).status, IntersectionStatus::kNotConics);
}

// Sign changes of the second conic's equation along the first, by its natural parameter.
int crossings(const Curve& first, const Pose<double>& X1, const Curve& second, const Pose<double>& X2) {
  const std::array<double, 6> k = implicit_coefficients(second);
  int changes = 0;
  double last = 0;
  constexpr int kSteps = 40000;
  for (int i = 0; i <= kSteps; ++i) {
    const double s = 2.0 * i / kSteps - 1;
    Vector2d local;
    if (first.q > 0) {
      const auto [a, b] = semi_axes(first);
      local = {a * (1 - std::cos(kPi * s)), b * std::sin(kPi * s)};
    } else if (first.q == 0) {
      const double y = first.semi_latus * std::sinh(9 * s);
      local = {y * y / (2 * first.semi_latus), y};
    } else {
      const auto [a, b] = semi_axes(first);
      local = {a * (std::cosh(9 * s) - 1), b * std::sinh(9 * s)};
    }
    const Vector2d p =
        X2.inverse_times(X1 * (first.vertex_B + local.x() * first.axis_B + local.y() * perp(first.axis_B)));
    const bool other_branch = second.q < 0 && (p - center(second)).dot(second.axis_B) < 0;
    const double f = (k[0] * p.x() + k[2] * p.y() + k[3]) * p.x() + (k[1] * p.y() + k[4]) * p.y() + k[5];
    // The far branch of a hyperbola is not there: outside it all is outside.
    const double sign = other_branch ? std::copysign(1.0, second.side == Side::kInside ? 1 : -1) : f;
    changes += i > 0 && sign * last < 0;
    last = sign;
  }
  return changes;
}

TEST(Intersections, OfRandomConicsAreAsManyAsAWalkAlongTheFirstCrosses) {
  std::array<int, 5> seen = {};
  for (unsigned number = 0; number < 480; ++number) {
    std::mt19937 random(7000 + number);
    const Curve a = testing::random_curve(static_cast<int>(number % 4), random);
    const Curve b = testing::random_curve(static_cast<int>(number / 4 % 4), random);
    const Pose<double> X1 = pose(0.1 * number, 0.3, -0.2);
    const Pose<double> X2 = pose(-0.37 * number, 0.1, 0.4);
    const auto found = intersect_conics(a, X1, b, X2);
    ASSERT_EQ(found.status, IntersectionStatus::kPoints);
    for (const ConicIntersection& each : found.points) {
      for (const auto& [curve, X] : {std::pair(a, X1), std::pair(b, X2)}) {
        const std::array<double, 6> k = implicit_coefficients(curve);
        const Vector2d p = X.inverse_times(each.p_W);
        const double f = (k[0] * p.x() + k[2] * p.y() + k[3]) * p.x() + (k[1] * p.y() + k[4]) * p.y() + k[5];
        EXPECT_LE(std::abs(f), 1e-13 * (1 + p.squaredNorm()) * (1 + 1 / curve.semi_latus)) << number;
      }
    }
    EXPECT_EQ(static_cast<int>(found.points.size()), crossings(a, X1, b, X2)) << number;
    ++seen.at(found.points.size());
  }
  EXPECT_GT(seen[0], 5);
  EXPECT_GT(seen[2], 5);
  EXPECT_GT(seen[4], 5);
}

}  // namespace
}  // namespace higherpair
