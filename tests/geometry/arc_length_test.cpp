#include "higherpair/geometry/arc_length.hpp"

#include "geometry/geometry_testing.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

namespace higherpair {
namespace {

using namespace higherpair::testing;

// ∫ |dp/dt| dt of the textbook parametrisation by adaptive quadrature; with 61 nodes and an estimated error
// of 1e-10 it is accurate to rounding.
double quadrature(const NaturalConic& conic, double from, double to) {
  const auto speed = [&](double t) { return conic.first(t).norm(); };
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(speed, from, to, 6, 1e-10);
}

// The parameter of the vertex to which the curve refers.
double vertex_parameter(const NaturalConic& conic, const Curve& curve) {
  if (conic.kind == CurveKind::kParabola || conic.kind == CurveKind::kHyperbola) return 0;
  const Vector2d r =
      Rotation<double>::from_angle(-conic.rotation) * Vector2d(curve.vertex_B - conic.origin_B);
  return std::atan2(r.y() / conic.b, r.x() / conic.a);
}

// Angle of the convex side's normal from that at the vertex, |t - t_vertex| <= π.
double psi_at(const NaturalConic& conic, const Curve& curve, double t) {
  const Vector2d n = conic.sense() * conic.normal(t);
  return std::remainder(angle_of(n) - vertex_normal_angle(curve), 2 * kPi);
}

TEST(ArcLength, IsTheIntegralOverTheTextbookCurve) {
  Random random(81);
  Worst error;
  for (int i = 0; i < 4000; ++i) {
    const NaturalConic conic = random_conic(random, i);
    const Curve curve = conic.curve();
    const double t0 = vertex_parameter(conic, curve);
    const double t = t0 + (curve.q > 0 ? random.between(-3.1, 3.1) : random.between(-2, 2));
    const double expected = quadrature(conic, t0, t);
    const double psi = psi_at(conic, curve, t);
    // A rounding of ψ changes the length by ρ times as much.
    error.see(std::abs(arc_length(curve, psi) - expected) / (1 + std::abs(conic.radius(t))));
    EXPECT_EQ(expected > 0, psi > 0);
  }
  EXPECT_AT_MOST(error.value(), 5e-15);
}

TEST(ArcLength, OfAWholeEllipseIsItsCircumference) {
  Random random(82);
  for (int i = 0; i < 200; ++i) {
    const double a = random.between(0.1, 1);
    const double b = i < 9 ? a * std::pow(10, -i) : random.between(0.1, 1);
    const Curve ellipse = make_ellipse(random.vector(1), {a, b}, random.angle()).value();
    const double major = std::max(a, b);
    const double minor = std::min(a, b);
    const double k = std::sqrt((major - minor) * (major + minor)) / major;
    const double expected = 4 * major * boost::math::ellint_2(k);
    EXPECT_NEAR(arc_length(ellipse, 2 * kPi) / expected, 1, 4e-15);
    EXPECT_NEAR(arc_length(ellipse, -2 * kPi) / expected, -1, 4e-15);
    EXPECT_NEAR(arc_length(ellipse, 6 * kPi) / expected, 3, 1.2e-14);
    // A quarter ends where the radius is a²/b: the double nearest to π/2 is 6e-17 short of a quarter turn.
    const double missing = 6.1e-17 * major * major / minor;
    EXPECT_NEAR((arc_length(ellipse, kPi / 2) + missing) / expected, 0.25, 1e-15 + 0.01 * missing / expected);
  }
}

TEST(ArcLength, OfTheEllipseOfSemiAxesTwoAndOneIsThePublishedNumber) {
  // 8 E(m = 3/4), from tables of elliptic integrals: E = 1.211056027568459524803562.
  const Curve ellipse = make_ellipse({0.3, 0.1}, {2, 1}, 0.4).value();
  EXPECT_NEAR(arc_length(ellipse, 2 * kPi), 8 * 1.211056027568459524803562, 4e-15);
}

TEST(ArcLength, OfACircleIsTheAngleTimesTheRadius) {
  const Curve circle = make_circle({0.3, 0.1}, 0.031).value();
  for (const double psi : {-20.0, -1.0, 0.0, 1e-9, 3.0, 7.0, 100.0}) {
    EXPECT_EQ(arc_length(circle, psi), 0.031 * psi);
    Curve by_integral = circle;
    by_integral.kind = CurveKind::kEllipse;
    EXPECT_NEAR(arc_length(by_integral, psi), 0.031 * psi, 4e-16 * (1 + std::abs(psi)));
  }
}

TEST(ArcLength, OfAParabolaIsTheClosedForm) {
  // At y = 2 f t: s = f (t √(1 + t²) + asinh t), and the normal is rotated by atan t.
  const double f = 0.31;
  const Curve parabola = make_parabola({0.3, 0.1}, f, 0.7).value();
  for (const double t : {-50.0, -3.0, -1.0, -1e-8, 0.0, 1e-8, 0.5, 1.0, 10.0, 1000.0}) {
    const double expected = f * (t * std::hypot(1, t) + std::asinh(t));
    // ds = ρ dψ with ρ = 2f (1 + t²)^{3/2}: the effect of the angle's rounding.
    const double bound = 4e-16 * f * (1 + std::pow(1 + t * t, 1.5));
    EXPECT_NEAR(arc_length(parabola, std::atan(t)), expected, bound) << t;
  }
}

TEST(ArcLength, OfWideAndNarrowHyperbolasIsTheIntegral) {
  for (const double ratio : {1e-4, 1e-2, 1.0, 1e2, 1e4}) {
    const NaturalConic conic{CurveKind::kHyperbola, {0.3, 0.1}, 0.5, 0.5 * ratio, 0.4, Side::kInside};
    const Curve curve = conic.curve();
    for (const double t : {1e-3, 0.1, 1.0, 4.0}) {
      const double expected = quadrature(conic, 0, t);
      // ds = ρ dψ: the effect of the rounding of ψ = atan of a slope.
      const double bound = 5e-15 * expected + 4e-16 * conic.radius(t);
      EXPECT_NEAR(arc_length(curve, psi_at(conic, curve, t)), expected, bound) << ratio << " " << t;
    }
  }
}

TEST(ArcLength, GrowsByTheRadiusOfCurvature) {
  Random random(83);
  Worst error;
  for (int i = 0; i < 2000; ++i) {
    const NaturalConic conic = random_conic(random, i);
    const Curve curve = conic.curve();
    const double t = 0.5 * random_parameter(random, conic);
    const double psi = psi_at(conic, curve, t);
    const auto at = [&](double angle) { return arc_length(curve, angle); };
    const auto [first, second] = differentiate(at, psi, 3e-4);
    error.see(std::abs(first / (conic.sense() * conic.radius(t)) - 1));
  }
  EXPECT_AT_MOST(error.value(), 1e-10);  // rounding / h is 1e-13; the rest is truncation where ρ grows fast
}

TEST(ArcLength, AddsUpOverAnyNumberOfTurns) {
  Random random(84);
  Worst error;
  for (int i = 0; i < 1000; ++i) {
    const NaturalConic conic = random_conic(random, 1);
    const Curve curve = conic.curve();
    const double whole = arc_length(curve, 2 * kPi);
    const double psi = random.between(-30, 30);
    error.see(std::abs(arc_length(curve, psi + 2 * kPi) - arc_length(curve, psi) - whole) / whole);
    error.see(std::abs(arc_length(curve, psi + kPi) - arc_length(curve, psi) - whole / 2) / whole);
    error.see(std::abs(arc_length(curve, psi) + arc_length(curve, -psi)) / whole);
  }
  EXPECT_AT_MOST(error.value(), 3e-14);  // ten turns and angles up to 36 rounded by 4e-15
}

TEST(ArcLength, HasNoJumpAtTheQuarterTurnsWhereHalvesArePutTogether) {
  const Curve ellipse = make_ellipse({0.3, 0.1}, {0.7, 0.2}, 0.4).value();
  for (int quarter = -9; quarter <= 9; ++quarter) {
    const double psi = quarter * kPi / 2;
    const double before = arc_length(ellipse, psi - 1e-12);
    const double after = arc_length(ellipse, psi + 1e-12);
    const double rho = quarter % 2 == 0 ? 0.2 * 0.2 / 0.7 : 0.7 * 0.7 / 0.2;
    EXPECT_NEAR(after - before, 2e-12 * rho, 3e-14);
  }
}

TEST(ArcLength, PassesThroughTheParabolaWithoutAJump) {
  const Curve parabola = make_parabola({0, 0}, 0.15, 0.4).value();
  for (const double q : {1e-4, -1e-4, 1e-8, -1e-8, 1e-12, -1e-12}) {
    Curve nearly = parabola;
    nearly.kind = q > 0 ? CurveKind::kEllipse : CurveKind::kHyperbola;
    nearly.q = q;
    for (const double psi : {-1.2, -0.4, 0.1, 0.9}) {
      // d/dq of the integrand is below 1.5/cos⁵ = 240 at 1.2.
      EXPECT_NEAR(arc_length(nearly, psi), arc_length(parabola, psi), 100 * std::abs(q) + 1e-15);
    }
  }
}

TEST(ArcLength, OfLinesAndPointsIsZero) {
  EXPECT_EQ(arc_length(make_line({1, 2}, {0, 1}).value(), 0.7), 0);
  EXPECT_EQ(arc_length(make_point({1, 2}).value(), 0.7), 0);
}

TEST(VertexNormalAngle, IsThatOfTheOutwardNormalOfTheConvexSide) {
  Random random(85);
  for (int i = 0; i < 1000; ++i) {
    const NaturalConic conic = random_conic(random, i);
    const Curve curve = conic.curve();
    const Vector2d n = conic.sense() * conic.normal(vertex_parameter(conic, curve));
    EXPECT_AT_MOST((unit_vector(vertex_normal_angle(curve)) - n).norm(), 2e-14);
  }
}

}  // namespace
}  // namespace higherpair
