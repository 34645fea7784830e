#include "geometry/curvature.hpp"

#include "geometry/geometry_testing.hpp"
#include "higherpair/geometry/support.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

// Curvature of a conic at a parameter, by each of three methods.
struct ThreeWays {
  CurvePointShape slope;
  CurvePointShape gradient;
  SupportPoint<double> support;
};

ThreeWays three_ways(const NaturalConic& conic, double t) {
  const Curve curve = conic.curve();
  const std::array<double, 6> k = implicit_coefficients(curve);
  return {shape_by_slope(k, conic.point(t)), shape_by_gradient(k, conic.point(t)),
          support_point(place(curve, Pose<double>{}), conic.normal(t))};
}

TEST(Curvature, ThreeWaysAgreeWithTheTextbookCurve) {
  Random random(71);
  Worst normal, kappa, center, support;
  int steep = 0;
  for (int i = 0; i < 20000; ++i) {
    const NaturalConic conic = random_conic(random, i);
    const double t = random_parameter(random, conic);
    const ThreeWays ways = three_ways(conic, t);
    const double rho = conic.radius(t);
    const Vector2d n = conic.normal(t);
    const Vector2d c = conic.point(t) - rho * n;
    for (const CurvePointShape& shape : {ways.slope, ways.gradient}) {
      normal.see(shape.n - n);
      kappa.see(std::abs(shape.kappa * rho - 1));
      center.see((shape.center - c) / (1 + std::abs(rho)));
    }
    support.see(std::abs(ways.support.rho / rho - 1) * ways.support.w2);
    steep += std::abs(n.x()) > std::abs(n.y()) ? 1 : 0;
  }
  EXPECT_GT(steep, 8000);
  EXPECT_LT(steep, 12000);
  // Rounded points on flat stretches far from the vertex: 1e-16 times coefficients up to 100.
  EXPECT_AT_MOST(normal.value(), 2e-13);
  EXPECT_AT_MOST(kappa.value(), 1e-12);
  EXPECT_AT_MOST(center.value(), 1e-12);
  EXPECT_AT_MOST(support.value(), 2e-14);
}

TEST(Curvature, VerticalAndHorizontalTangentsAreNothingSpecial) {
  for (const Side side : {Side::kInside, Side::kOutside}) {
    for (const CurveKind kind :
         {CurveKind::kCircle, CurveKind::kEllipse, CurveKind::kParabola, CurveKind::kHyperbola}) {
      const double b = kind == CurveKind::kCircle ? 0.7 : 0.3;
      for (int quarter = 0; quarter < 4; ++quarter) {
        const NaturalConic conic{kind, {0, 0}, 0.7, b, quarter * kPi / 2, side};
        // The vertices, and the neighbourhood of a slope of exactly 45°.
        for (const double t :
             {0.0, kPi / 2, kPi, 1e-200, 1e-9, std::atan(0.3 / 0.7), std::atan(0.3 / 0.7) + 1e-12}) {
          if (t > 3 && conic.kind != CurveKind::kCircle && conic.kind != CurveKind::kEllipse) continue;
          const ThreeWays ways = three_ways(conic, t);
          EXPECT_NEAR(ways.slope.kappa * conic.radius(t), 1, 1e-13);
          EXPECT_NEAR(ways.gradient.kappa * conic.radius(t), 1, 1e-13);
          EXPECT_NEAR(ways.support.rho / conic.radius(t), 1, 1e-13);
        }
      }
    }
  }
}

TEST(Curvature, OfVerticesIsKnown) {
  const double a = 0.05;
  const double b = 0.031;
  const NaturalConic ellipse{CurveKind::kEllipse, {0.01, 0.02}, a, b, 0.6, Side::kInside};
  const NaturalConic parabola{CurveKind::kParabola, {0.01, 0.02}, a, 1, 0.6, Side::kInside};
  const NaturalConic hyperbola{CurveKind::kHyperbola, {0.01, 0.02}, a, b, 0.6, Side::kInside};
  const auto expect = [](const NaturalConic& conic, double t, double rho) {
    const ThreeWays ways = three_ways(conic, t);
    EXPECT_NEAR(1 / ways.slope.kappa, rho, 1e-15);
    EXPECT_NEAR(1 / ways.gradient.kappa, rho, 1e-15);
    EXPECT_NEAR(ways.support.rho, rho, 1e-15);
  };
  expect(ellipse, 0, b * b / a);
  expect(ellipse, kPi / 2, a * a / b);
  expect(ellipse, kPi, b * b / a);
  expect(parabola, 0, 2 * a);
  expect(hyperbola, 0, b * b / a);
}

TEST(Curvature, ByThePaperOfTheStandingParabola) {
  // y = x²/2: y' = x, y'' = 1, ρ = (1 + x²)^{3/2}.
  const std::array<double, 6> k{1, 0, 0, 0, -2, 0};
  for (const double x : {0.0, 0.5, 1.0, -1.0, 3.0, -20.0}) {
    const Vector2d p(x, x * x / 2);
    const double rho = std::pow(1 + x * x, 1.5);
    for (const CurvePointShape& shape : {shape_by_slope(k, p), shape_by_gradient(k, p)}) {
      EXPECT_NEAR(shape.kappa * rho, 1, 1e-14);
      EXPECT_AT_MOST((shape.center - Vector2d(-x * x * x, 1 + 1.5 * x * x)).norm(), 1e-14 * rho);
    }
  }
}

TEST(Curvature, ChangesItsSignWithTheSideAndNothingElseWithTheFactor) {
  Random random(72);
  for (int i = 0; i < 1000; ++i) {
    const NaturalConic conic = random_conic(random, i);
    std::array<double, 6> k = conic.coefficients();
    const Vector2d p = conic.point(random_parameter(random, conic));
    const auto slope = shape_by_slope(k, p);
    const auto gradient = shape_by_gradient(k, p);
    for (double& value : k) value = std::ldexp(value, 30);
    EXPECT_EQ(shape_by_slope(k, p).kappa, slope.kappa);
    EXPECT_EQ(shape_by_gradient(k, p).kappa, gradient.kappa);
    for (double& value : k) value = -value;
    EXPECT_EQ(shape_by_slope(k, p).kappa, -slope.kappa);
    EXPECT_EQ(shape_by_gradient(k, p).kappa, -gradient.kappa);
    EXPECT_EQ(shape_by_slope(k, p).n, -slope.n);
    EXPECT_EQ(shape_by_slope(k, p).center, slope.center);
  }
}

TEST(Curvature, OfALineIsZeroAndItsCenterIsThePoint) {
  const Curve face = make_line({0.3, 0.1}, {1, 2}).value();
  const std::array<double, 6> k = implicit_coefficients(face);
  const Vector2d p(0.5, 0);
  EXPECT_AT_MOST(std::abs(value_at(k, p)), 1e-16);
  for (const CurvePointShape& shape : {shape_by_slope(k, p), shape_by_gradient(k, p)}) {
    EXPECT_EQ(shape.kappa, 0);
    EXPECT_EQ(shape.center, p);
    EXPECT_AT_MOST((shape.n - Vector2d(1, 2).normalized()).norm(), 2e-16);
  }
}

}  // namespace
}  // namespace higherpair
