#include "higherpair/geometry/support.hpp"

#include "geometry/geometry_testing.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

// Conics differ in condition: a hyperbola's w vanishes at the ends of its cone of normals. All comparisons
// use parameters up to ±2, where cosh is 4 and w is above 0.05.
struct Placed {
  NaturalConic conic;
  Curve curve;
  Pose<double> X_WB;
};

Placed random_placed(Random& random, int number) {
  const NaturalConic conic = random_conic(random, number);
  return {conic, conic.curve(), random.pose(1)};
}

TEST(SupportPoint, IsThePointOfTheTextbookCurveWithThatNormal) {
  Random random(61);
  Worst point, radius;
  for (int i = 0; i < 20000; ++i) {
    const Placed body = random_placed(random, i);
    const double t = random_parameter(random, body.conic);
    const Vector2d n_W = body.X_WB.R_WB * body.conic.normal(t);
    const auto found = support_point(place(body.curve, body.X_WB), n_W);
    const Vector2d expected_W = body.X_WB * body.conic.point(t);
    const double rho = body.conic.radius(t);
    EXPECT_TRUE(has_point(place(body.curve, body.X_WB), n_W));
    EXPECT_GT(found.w2, 0);
    // A rounding of the normal moves the point by rho times as much; a rounding of w near the end of the cone
    // changes rho by more.
    point.see((found.p_W - expected_W) / (1 + std::abs(rho)));
    radius.see(std::abs(found.rho - rho) / std::abs(rho) * found.w2);
    EXPECT_EQ(found.rho > 0, body.conic.side == Side::kInside);
  }
  EXPECT_AT_MOST(point.value(), 5e-15);
  EXPECT_AT_MOST(radius.value(), 2e-14);
}

TEST(SupportPoint, LiesOnTheCurveAndHasTheNormalByTheEquation) {
  Random random(62);
  Worst off, turned;
  for (int i = 0; i < 20000; ++i) {
    const Placed body = random_placed(random, i);
    const Vector2d n_W = unit_vector(random.angle());
    const auto placed = place(body.curve, body.X_WB);
    if (!has_point(placed, n_W)) continue;
    const auto found = support_point(placed, n_W);
    // Close to the end of its cone a point may be arbitrarily far away.
    if ((found.p_W - placed.vertex_W).norm() > 10) continue;
    const Vector2d p_B = body.X_WB.inverse_times(found.p_W);
    const std::array<double, 6> k = implicit_coefficients(body.curve);
    const Vector2d gradient_W = body.X_WB.R_WB * gradient_at(k, p_B);
    off.see(std::abs(value_at(k, p_B)) / gradient_W.norm());
    turned.see(gradient_W.normalized() - n_W);
  }
  EXPECT_AT_MOST(off.value(), 2e-13);
  EXPECT_AT_MOST(turned.value(), 2e-13);
}

TEST(SupportPoint, OfAConvexBodyIsTheFarthestInItsDirection) {
  Random random(63);
  for (int i = 0; i < 2000; ++i) {
    Placed body = random_placed(random, i % 4);
    const double t0 = random_parameter(random, body.conic);
    const Vector2d n_W = body.X_WB.R_WB * body.conic.normal(t0);
    const double farthest = support_point(place(body.curve, body.X_WB), n_W).p_W.dot(n_W);
    Worst beyond;
    for (int k = 0; k < 50; ++k) {
      const Vector2d p_W = body.X_WB * body.conic.point(1.5 * random_parameter(random, body.conic));
      beyond.see(p_W.dot(n_W) - farthest);
    }
    EXPECT_AT_MOST(beyond.value(), 5e-15);
  }
}

TEST(SupportPoint, OfARingIsTheNearestOfItsMaterialInItsDirection) {
  Random random(64);
  for (int i = 0; i < 2000; ++i) {
    Placed body = random_placed(random, 4 + i % 4);
    ASSERT_EQ(body.curve.side, Side::kOutside);
    const double t0 = random_parameter(random, body.conic);
    const Vector2d n_W = body.X_WB.R_WB * body.conic.normal(t0);
    const double nearest = support_point(place(body.curve, body.X_WB), n_W).p_W.dot(n_W);
    Worst beyond;
    for (int k = 0; k < 50; ++k) {
      const Vector2d p_W = body.X_WB * body.conic.point(1.5 * random_parameter(random, body.conic));
      beyond.see(nearest - p_W.dot(n_W));
    }
    EXPECT_AT_MOST(beyond.value(), 5e-15);
  }
}

TEST(SupportPoint, OfTheOtherSideIsThatOfTheOppositeNormalWithOppositeRadius) {
  Random random(65);
  for (int i = 0; i < 1000; ++i) {
    Placed body = random_placed(random, i);
    const Vector2d n_W = body.X_WB.R_WB * body.conic.normal(random_parameter(random, body.conic));
    const auto one = support_point(place(body.curve, body.X_WB), n_W);
    body.curve.side = body.curve.side == Side::kInside ? Side::kOutside : Side::kInside;
    const auto other = support_point(place(body.curve, body.X_WB), Vector2d(-n_W));
    EXPECT_EQ(one.p_W, other.p_W);
    EXPECT_EQ(one.rho, -other.rho);
  }
}

TEST(SupportPoint, MovesByTheRadiusAsTheNormalTurns) {
  Random random(66);
  Worst error;
  for (int i = 0; i < 2000; ++i) {
    const Placed body = random_placed(random, i);
    const auto placed = place(body.curve, body.X_WB);
    const double phi =
        angle_of(body.X_WB.R_WB * body.conic.normal(0.5 * random_parameter(random, body.conic)));
    const auto at = [&](double angle) -> Vector2d { return support_point(placed, unit_vector(angle)).p_W; };
    const auto [first, second] = differentiate(at, phi, 1e-3);
    const auto found = support_point(placed, unit_vector(phi));
    error.see((first - found.rho * perp(unit_vector(phi))) / (1 + std::abs(found.rho)));
  }
  EXPECT_AT_MOST(error.value(), 1e-8);
}

TEST(SupportPoint, OfACircleAndAKnifeEdge) {
  const Pose<double> X_WB{Rotation<double>::from_angle(0.7), {0.3, -0.2}};
  const Curve disc = make_circle({0.031, 0.0127}, 0.25).value();
  const Curve edge = make_point({0.031, 0.0127}).value();
  for (double phi = -kPi; phi < kPi; phi += 0.1) {
    const Vector2d n = unit_vector(phi);
    const Vector2d c_W = X_WB * Vector2d(0.031, 0.0127);
    const auto on_disc = support_point(place(disc, X_WB), n);
    EXPECT_AT_MOST((on_disc.p_W - c_W - 0.25 * n).norm(), 2e-16);
    EXPECT_NEAR(on_disc.rho, 0.25, 2e-16);
    const auto on_edge = support_point(place(edge, X_WB), n);
    EXPECT_EQ(on_edge.p_W, c_W);
    EXPECT_EQ(on_edge.rho, 0);
  }
}

TEST(HasPoint, OfAParabolaIsTheHalfTurnAboutItsVertex) {
  for (const Side side : {Side::kInside, Side::kOutside}) {
    const Curve parabola = make_parabola({0.1, 0.2}, 0.3, 0.4, side).value();
    const auto placed = place(parabola, Pose<double>{});
    const double vertex = 0.4 + (side == Side::kInside ? kPi : 0);
    for (const double angle : {0.0, 1.0, -1.0, kPi / 2 - 1e-9, -kPi / 2 + 1e-9}) {
      EXPECT_TRUE(has_point(placed, unit_vector(vertex + angle))) << angle;
    }
    for (const double angle : {kPi / 2 + 1e-9, -kPi / 2 - 1e-9, 2.0, -2.0, kPi}) {
      EXPECT_FALSE(has_point(placed, unit_vector(vertex + angle))) << angle;
    }
  }
}

TEST(HasPoint, OfAHyperbolaIsTheConeOfNormalsOfItsAsymptotes) {
  for (const Side side : {Side::kInside, Side::kOutside}) {
    const double a = 0.3;
    const double b = 0.5;
    const Curve hyperbola = make_hyperbola({0.1, 0.2}, {a, b}, 0.4, side).value();
    const auto placed = place(hyperbola, Pose<double>{});
    const double vertex = 0.4 + (side == Side::kInside ? kPi : 0);
    const double cone = std::atan2(a, b);  // an asymptote rises b per a, and its normal leans as much
    for (const double angle : {0.0, 0.9 * cone, -0.9 * cone, cone - 1e-9, 1e-9 - cone}) {
      EXPECT_TRUE(has_point(placed, unit_vector(vertex + angle))) << angle;
      EXPECT_TRUE(support_point(placed, unit_vector(vertex + angle)).p_W.allFinite());
    }
    for (const double angle : {cone + 1e-9, -cone - 1e-9, kPi / 2, kPi, kPi - 0.5 * cone}) {
      EXPECT_FALSE(has_point(placed, unit_vector(vertex + angle))) << angle;
    }
  }
}

TEST(HasPoint, OfABoundedCurveIsAlways) {
  Random random(67);
  for (int i = 0; i < 1000; ++i) {
    const Placed body = random_placed(random, i % 2);
    EXPECT_TRUE(has_point(place(body.curve, body.X_WB), unit_vector(random.angle())));
  }
  EXPECT_TRUE(has_point(place(make_point({1, 2}).value(), Pose<double>{}), Vector2d(0, 1)));
}

TEST(SupportPoint, PassesThroughTheParabolaWithoutAJump) {
  const Curve parabola = make_parabola({0.1, 0.2}, 0.15, 0.4).value();
  for (const double q : {1e-3, -1e-3, 1e-6, -1e-6, 1e-9, -1e-9, 1e-12, -1e-12, 1e-15, -1e-15}) {
    Curve nearly = parabola;
    nearly.kind = q > 0 ? CurveKind::kEllipse : CurveKind::kHyperbola;
    nearly.q = q;
    for (double angle = -1.3; angle <= 1.3; angle += 0.05) {
      const Vector2d n = unit_vector(0.4 + kPi + angle);
      const auto limit = support_point(place(parabola, Pose<double>{}), n);
      const auto near = support_point(place(nearly, Pose<double>{}), n);
      // d/dq of ℓ N_y/w is ℓ N_y³/(2 w³), the other derivatives are similar: below 3 ℓ/|N_x|⁵ = 640 for
      // |angle| <= 1.3.
      EXPECT_AT_MOST((near.p_W - limit.p_W).norm(), 700 * std::abs(q) + 2e-14);
      EXPECT_AT_MOST(std::abs(near.rho / limit.rho - 1), 30 * std::abs(q) + 2e-14);
    }
  }
}

}  // namespace
}  // namespace higherpair
