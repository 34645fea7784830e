// Conics from their six coefficients, compared with the constructors by natural parameters.
#include "geometry/geometry_testing.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

// A point near the branch's vertex.
Vector2d near_the_branch(const NaturalConic& conic) {
  return conic.point(0.3);
}

// Difference of the two curves as point sets near the vertex, with lengths in units of `size`. An ellipse may
// be given by either vertex and a circle by any of its points, so that centre and axes are compared instead.
double difference(const Curve& curve, const NaturalConic& conic, double size) {
  Worst worst;
  if (conic.kind == CurveKind::kParabola) {
    worst.see((curve.vertex_B - conic.origin_B) / size);
    worst.see(curve.axis_B - unit_vector(conic.rotation));
    worst.see(std::abs(curve.semi_latus - 2 * conic.a) / size);
    worst.see(std::abs(curve.q));
    return worst.value();
  }
  const std::array<double, 2> axes = semi_axes(curve);
  const double major = conic.kind == CurveKind::kHyperbola ? conic.a : std::max(conic.a, conic.b);
  const double minor = conic.kind == CurveKind::kHyperbola ? conic.b : std::min(conic.a, conic.b);
  worst.see((center(curve) - conic.origin_B) / size);
  worst.see(std::abs(axes[0] - major) / size);
  worst.see(std::abs(axes[1] - minor) / size);
  if (conic.kind != CurveKind::kCircle) {
    const Vector2d axis = unit_vector(conic.rotation + (conic.a == major ? 0 : kPi / 2));
    const bool has_direction = conic.kind == CurveKind::kHyperbola;
    worst.see(has_direction ? (curve.axis_B - axis).norm() : std::abs(cross(curve.axis_B, axis)));
  }
  return worst.value();
}

TEST(Conic, ConstructorsMeanTheTextbookCurve) {
  Random random(31);
  Worst error;
  for (int i = 0; i < 4000; ++i) {
    const NaturalConic conic = random_conic(random, i);
    const Curve curve = conic.curve();
    EXPECT_EQ(curve.kind, conic.kind);
    EXPECT_EQ(curve.side, conic.side);
    error.see(difference(curve, conic, 1));
    // The curve is f = 0 with |∇f| = 1 at the vertex: f is the distance, up to the growth of the gradient.
    const std::array<double, 6> k = implicit_coefficients(curve);
    const Vector2d p = conic.point(random_parameter(random, conic));
    error.see(1e-2 * std::abs(value_at(k, p)) / (1 + gradient_at(k, p).norm()));
    EXPECT_NEAR(gradient_at(k, curve.vertex_B).norm(), 1, 1e-12);
  }
  EXPECT_AT_MOST(error.value(), 3e-15);
}

TEST(Conic, TheEquationIsNegativeInTheBody) {
  Random random(32);
  for (int i = 0; i < 4000; ++i) {
    const NaturalConic conic = random_conic(random, i);
    const double t = random_parameter(random, conic);
    const std::array<double, 6> k = implicit_coefficients(conic.curve());
    EXPECT_LT(value_at(k, conic.point(t) - 1e-3 * conic.normal(t)), 0);
    EXPECT_GT(value_at(k, conic.point(t) + 1e-3 * conic.normal(t)), 0);
  }
}

TEST(Conic, SixCoefficientsGiveTheSameCurveWhateverTheirFactorAndScale) {
  for (const double size : {1e-6, 1.0, 1e6}) {
    Random random(33);
    Worst error;
    for (int i = 0; i < 4000; ++i) {
      const NaturalConic conic = random_conic(random, i, size);
      std::array<double, 6> k = conic.coefficients();
      const double factor = random.sign() * std::pow(10, random.between(-12, 12));
      for (double& value : k) value *= factor;
      const auto curve = make_conic(k, conic.side, near_the_branch(conic));
      ASSERT_TRUE(curve) << describe(curve.error()) << " " << ::testing::PrintToString(conic);
      // A circle whose A and B are rounded differently is an ellipse with an axis ratio of 1 - 1e-16.
      if (conic.kind != CurveKind::kCircle || curve->q > 1 - 1e-14) {
        EXPECT_TRUE(curve->kind == conic.kind || conic.kind == CurveKind::kCircle);
      }
      EXPECT_EQ(curve->side, conic.side);
      // Effect of rounded coefficients: axes whose squares differ by a factor of 100 lose that factor in
      // accuracy, and nearly equal ones lose their direction; a parabola's axis loses the ratio of the
      // distance from the origin to the focal length.
      const double spread = std::abs(conic.a - conic.b) / size;
      if (conic.kind == CurveKind::kEllipse && spread < 0.05) continue;
      error.see(difference(*curve, conic, size));
    }
    EXPECT_AT_MOST(error.value(), 2e-13);
  }
}

TEST(Conic, ACircleStaysACircle) {
  Random random(34);
  Worst error;
  for (int i = 0; i < 1000; ++i) {
    const Vector2d c = random.vector(1);
    const double r = random.between(0.1, 1);
    const double factor = random.sign() * std::pow(10, random.between(-12, 12));
    const auto circle = make_conic(
        {factor, factor, 0, -2 * factor * c.x(), -2 * factor * c.y(), factor * (c.squaredNorm() - r * r)});
    ASSERT_TRUE(circle);
    EXPECT_EQ(circle->kind, CurveKind::kCircle);
    EXPECT_EQ(circle->q, 1);
    error.see(center(*circle) - c);
    error.see(std::abs(circle->semi_latus - r));
  }
  EXPECT_AT_MOST(error.value(), 5e-15);
}

TEST(Conic, EquationOfACurveGivesTheCurveBack) {
  Random random(35);
  Worst error;
  for (int i = 0; i < 4000; ++i) {
    const NaturalConic conic = random_conic(random, i);
    const Curve curve = conic.curve();
    const auto back = make_conic(implicit_coefficients(curve), conic.side, near_the_branch(conic));
    ASSERT_TRUE(back) << describe(back.error()) << " " << ::testing::PrintToString(conic);
    if (conic.kind == CurveKind::kEllipse && std::abs(conic.a - conic.b) < 0.05) continue;
    if (conic.kind == CurveKind::kCircle) {
      error.see(center(*back) - conic.origin_B);
      continue;
    }
    error.see(std::abs(back->q - curve.q) / (1 + std::abs(curve.q)));
    error.see(std::abs(back->semi_latus - curve.semi_latus) / (1 + curve.semi_latus));
    const bool other_vertex = curve.q > 0 && back->axis_B.dot(curve.axis_B) < 0;
    const Vector2d vertex = other_vertex ? Vector2d(2 * center(*back) - back->vertex_B) : back->vertex_B;
    error.see(vertex - curve.vertex_B);
  }
  EXPECT_AT_MOST(error.value(), 2e-13);
}

TEST(Conic, NearlyAParabolaItKeepsItsVertexAndItsEccentricity) {
  Random random(36);
  Worst error;
  for (int i = 0; i < 2000; ++i) {
    const double below_one = random.sign() * std::pow(10, random.between(-15, -3));
    const double q = below_one * (2 - below_one);  // 1 - e², e = 1 - below_one
    const double l = random.between(0.1, 1);
    const Vector2d u = unit_vector(random.angle());
    const Vector2d v = u.dot(Vector2d(1, 0)) * Vector2d(0.1, 0.05);
    const Curve meant{q > 0   ? CurveKind::kEllipse
                      : q < 0 ? CurveKind::kHyperbola
                              : CurveKind::kParabola,
                      Side::kInside,
                      v,
                      u,
                      l,
                      q};
    const auto found = make_conic(implicit_coefficients(meant), Side::kInside, Vector2d(v + u));
    ASSERT_TRUE(found) << describe(found.error());
    EXPECT_TRUE(found->kind == meant.kind || std::abs(q) < 1e-14) << q;
    error.see(found->vertex_B - v);
    error.see(found->axis_B - u);
    error.see(std::abs(found->semi_latus - l));
    error.see(std::abs(found->q - q));
  }
  EXPECT_AT_MOST(error.value(), 5e-15);
}

TEST(Conic, WithinRoundingOfAParabolaItIsOne) {
  for (const double below : {0.0, 1e-16, -1e-16, 1e-15, -1e-15}) {
    const auto curve = make_conic({below, 1, 0, -2, 0, 0});
    ASSERT_TRUE(curve);
    EXPECT_EQ(curve->kind, CurveKind::kParabola);
    EXPECT_EQ(curve->semi_latus, 1);
  }
  EXPECT_EQ(make_conic({4e-15, 1, 0, -2, 0, 0})->kind, CurveKind::kEllipse);
  EXPECT_EQ(make_conic({-4e-15, 1, 0, -2, 0, 0}, Side::kInside, Vector2d(1, 0))->kind, CurveKind::kHyperbola);
}

TEST(Conic, AHugeCircleKeepsItsPlaceNearTheOrigin) {
  Random random(37);
  Worst error;
  for (int i = 0; i < 1000; ++i) {
    NaturalConic conic;
    conic.a = conic.b = 1e6 * random.between(0.1, 1);
    const Vector2d axis = unit_vector(random.angle());
    const double offset = random.between(-1, 1);
    conic.origin_B = (conic.a + offset) * axis;
    const auto circle = make_conic(conic.coefficients());
    ASSERT_TRUE(circle);
    // The centre is rounded by 1e-10, and so is the vertex; from coefficients the vertex is as accurate as
    // from the centre.
    error.see(circle->vertex_B - offset * axis);
    error.see(conic.curve().vertex_B - offset * axis);
    EXPECT_NEAR(circle->semi_latus / conic.a, 1, 1e-14);
  }
  EXPECT_AT_MOST(error.value(), 5e-10);

  // Where the coefficients are exact, so is the vertex, whatever the radius: (x - r)² + y² = r².
  for (const double r : {1e3, 1e6, 1e9, 1e12}) {
    const auto circle = make_conic({1, 1, 0, -2 * r, 0, 0});
    ASSERT_TRUE(circle);
    EXPECT_EQ(circle->vertex_B, Vector2d::Zero());
    EXPECT_EQ(circle->semi_latus, r);
    const auto shifted =
        make_conic({1, 1, 0, -2 * r, 0, 0.25 * r});  // x = r - √(r² - r/4) = 1/8 + 1/(128 r) …
    ASSERT_TRUE(shifted);
    EXPECT_NEAR(shifted->vertex_B.x(), 0.125 + 1 / (128 * r) + 1 / (1024 * r * r),
                2e-4 / (r * r * r) + 4e-16);
  }
}

TEST(Conic, AThinEllipseKeepsItsTips) {
  Worst length, width, place;
  Random random(38);
  for (const double ratio : {1e-2, 1e-4, 1e-6}) {
    for (int i = 0; i < 300; ++i) {
      NaturalConic conic{CurveKind::kEllipse, random.vector(0.1), 1, ratio, random.angle(), Side::kInside};
      const Curve made = conic.curve();
      const auto found = make_conic(conic.coefficients());
      ASSERT_TRUE(found) << ratio << " " << describe(found.error());
      EXPECT_EQ(found->kind, CurveKind::kEllipse);
      // The coefficients hold the squared ratio only to 1e-16, which limits the accuracy of the length.
      const double rounding = 1e-15 / (ratio * ratio);
      length.see(std::abs(semi_axes(*found)[0] - 1) / rounding);
      width.see(std::abs(semi_axes(*found)[1] - ratio) / (ratio * rounding));
      place.see((center(*found) - conic.origin_B) / rounding);
      EXPECT_NEAR(semi_axes(made)[0], 1, 1e-15);
      EXPECT_NEAR(semi_axes(made)[1], ratio, 1e-15 * ratio);
    }
  }
  EXPECT_AT_MOST(length.value(), 0.3);
  EXPECT_AT_MOST(width.value(), 0.3);
  EXPECT_AT_MOST(place.value(), 0.3);
}

TEST(Conic, NearPicksTheBranchOfAHyperbola) {
  Random random(39);
  for (int i = 0; i < 1000; ++i) {
    NaturalConic conic = random_conic(random, 3);
    const auto k = conic.coefficients();
    const Vector2d axis = unit_vector(conic.rotation);
    for (const double sense : {1.0, -1.0}) {
      // Any point on that side of the centre: far away, or only just off it.
      for (const double distance : {1e-6, 0.3, 1e3}) {
        const Vector2d near = conic.origin_B + sense * distance * axis + random.between(-5, 5) * perp(axis);
        const auto branch = make_conic(k, Side::kInside, near);
        ASSERT_TRUE(branch);
        EXPECT_AT_MOST((branch->axis_B - sense * axis).norm(), 1e-12);
        EXPECT_AT_MOST((branch->vertex_B - conic.origin_B - sense * conic.a * axis).norm(), 1e-12);
      }
    }
  }
}

TEST(Conic, AHyperbolaAlongItsAsymptotesTurnsWithTheSignOfItsFactor) {
  // x y = 1/2 and x y = -1/2, each with either sign; A and B are zeros of either sign.
  for (const double sign : {1.0, -1.0}) {
    for (const double zero : {0.0, -0.0}) {
      for (const double factor : {1.0, -1.0}) {
        const auto branch = make_conic({zero, zero, factor, 0, 0, -0.5 * sign * factor}, Side::kInside,
                                       Vector2d(1, 0.9 * sign));
        ASSERT_TRUE(branch);
        EXPECT_AT_MOST((branch->vertex_B - std::sqrt(0.5) * Vector2d(1, sign)).norm(), 4e-16);
        EXPECT_AT_MOST((branch->axis_B - std::sqrt(0.5) * Vector2d(1, sign)).norm(), 4e-16);
        EXPECT_NEAR(branch->semi_latus, 1, 4e-16);
        EXPECT_NEAR(branch->q, -1, 4e-16);
      }
    }
  }
}

TEST(Conic, NearMeansNothingForOtherKinds) {
  Random random(40);
  for (int i = 0; i < 300; ++i) {
    const NaturalConic conic = random_conic(random, i % 3);
    const Curve plain = make_conic(conic.coefficients()).value();
    const Curve with = make_conic(conic.coefficients(), Side::kInside, random.vector(5)).value();
    EXPECT_EQ(plain.vertex_B, with.vertex_B);
    EXPECT_EQ(plain.axis_B, with.axis_B);
  }
}

}  // namespace
}  // namespace higherpair
