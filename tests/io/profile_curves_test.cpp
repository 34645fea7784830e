#include "higherpair/io/profile_reader.hpp"
#include "io/profile_testing.hpp"

#include <cmath>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

// Reads a curve from its inline table, in the crank's frame.
Curve curve(const std::string& table, const std::string& above = "") {
  const Profile profile = testing::read(testing::crank_profile("[bodies.crank.curves]\nc = " + table, above));
  return profile.mechanism.bodies[1].curves[0].curve;
}

// f(p) of the curve's equation, scaled so that it is the distance near a vertex.
double equation(const Curve& curve, const Vector2d& p) {
  const auto k = implicit_coefficients(curve);
  return k[0] * p.x() * p.x() + k[1] * p.y() * p.y() + k[2] * p.x() * p.y() + k[3] * p.x() + k[4] * p.y() +
         k[5];
}

TEST(ProfileCurves, CirclesAreBodiesOrRings) {
  const Curve disc = curve("{ type = \"circle\", center = [3, -4], radius = 11 }");
  EXPECT_EQ(disc.kind, CurveKind::kCircle);
  EXPECT_EQ(disc.side, Side::kInside);
  EXPECT_EQ(disc.semi_latus, 0.011);
  EXPECT_TRUE(center(disc).isApprox(Vector2d(0.003, -0.004), 1e-15));
  EXPECT_EQ(curve("{ type = \"circle\", center = [3, -4], radius = 11, side = \"outside\" }").side,
            Side::kOutside);
  EXPECT_EQ(curve("{ type = \"circle\", center = [3, -4], radius = 11, side = \"inside\" }").side,
            Side::kInside);
}

TEST(ProfileCurves, EllipsesHaveSemiAxesAndARotation) {
  const Curve level = curve("{ type = \"ellipse\", center = [3, -4], semi_axes = [13, 5] }");
  EXPECT_EQ(level.kind, CurveKind::kEllipse);
  EXPECT_NEAR(semi_axes(level)[0], 0.013, 1e-17);
  EXPECT_NEAR(semi_axes(level)[1], 0.005, 1e-17);
  EXPECT_NEAR(equation(level, {0.016, -0.004}), 0, 1e-17);
  const Curve turned = curve("{ type = \"ellipse\", center = [3, -4], semi_axes = [13, 5], rotation = 90 }");
  EXPECT_NEAR(equation(turned, {0.003, 0.009}), 0, 1e-17);
}

TEST(ProfileCurves, ParabolasHaveAVertexAndAFocus) {
  const Curve parabola = curve("{ type = \"parabola\", vertex = [3, -4], focal_length = 2, rotation = 90 }");
  EXPECT_EQ(parabola.kind, CurveKind::kParabola);
  EXPECT_EQ(parabola.vertex_B, Vector2d(0.003, -0.004));
  EXPECT_EQ(parabola.semi_latus, 0.004);
  EXPECT_TRUE(parabola.axis_B.isApprox(Vector2d(0, 1), 1e-15));
  EXPECT_NEAR(equation(parabola, {0.003 + 0.004, -0.002}), 0, 1e-17);  // beside the focus, 2f away
}

TEST(ProfileCurves, HyperbolasOpenTowardsTheirRotation) {
  const Curve hyperbola =
      curve("{ type = \"hyperbola\", center = [0, 0], semi_axes = [3, 4], rotation = 180 }");
  EXPECT_EQ(hyperbola.kind, CurveKind::kHyperbola);
  EXPECT_TRUE(hyperbola.vertex_B.isApprox(Vector2d(-0.003, 0), 1e-15));
  EXPECT_NEAR(semi_axes(hyperbola)[1], 0.004, 1e-17);
}

TEST(ProfileCurves, LinesHaveAnOutwardNormal) {
  const Curve face = curve("{ type = \"line\", point = [3, -4], normal = [0, 5] }");
  EXPECT_EQ(face.kind, CurveKind::kLine);
  EXPECT_EQ(face.vertex_B, Vector2d(0.003, -0.004));
  EXPECT_EQ(face.axis_B, Vector2d(0, -1));  // into the material
  EXPECT_EQ(curve("{ type = \"line\", point = [3, -4], normal = 180 }").axis_B, Vector2d(1, 0));
  EXPECT_EQ(curve("{ type = \"line\", point = [3, -4], normal = \"0.25 rev\" }").axis_B, Vector2d(0, -1));
}

TEST(ProfileCurves, PointsAreKnifeEdges) {
  const Curve edge = curve("{ type = \"point\", at = [3, \"-4 mm\"] }");
  EXPECT_EQ(edge.kind, CurveKind::kPoint);
  EXPECT_EQ(edge.vertex_B, Vector2d(0.003, -0.004));
}

TEST(ProfileCurves, ConicCoefficientsAreInTheLengthOfTheProfile) {
  // x²/169 + y²/25 = 1 in millimetres, times 4225 and -1.
  const Curve ellipse = curve("{ type = \"conic\", coefficients = [-25, -169, 0, 0, 0, 4225] }");
  EXPECT_EQ(ellipse.kind, CurveKind::kEllipse);
  EXPECT_NEAR(semi_axes(ellipse)[0], 0.013, 1e-16);
  EXPECT_NEAR(semi_axes(ellipse)[1], 0.005, 1e-16);
  // (x - 3)² = 8 (y + 4): vertex (3, -4), focal length 2, upwards.
  const Curve parabola = curve("{ type = \"conic\", coefficients = [1, 0, 0, -6, -8, -23] }");
  EXPECT_EQ(parabola.kind, CurveKind::kParabola);
  EXPECT_TRUE(parabola.vertex_B.isApprox(Vector2d(0.003, -0.004), 1e-14));
  EXPECT_NEAR(parabola.semi_latus, 0.004, 1e-17);
  const Curve hyperbola = curve(
      "{ type = \"conic\", coefficients = [16, -9, 0, 0, 0, -144], near = [-4, 0], side = \"outside\" }");
  EXPECT_EQ(hyperbola.kind, CurveKind::kHyperbola);
  EXPECT_EQ(hyperbola.side, Side::kOutside);
  EXPECT_TRUE(hyperbola.vertex_B.isApprox(Vector2d(-0.003, 0), 1e-14));
}

TEST(ProfileCurves, AConicIsTheSameInEveryUnitAndAtEveryScaleOfItsCoefficients) {
  for (const char* unit : {"um", "mm", "cm", "m", "km", "in", "ft"}) {
    const std::string above = fmt::format("[units]\nlength = \"{}\"\n", unit);
    Units units;
    units.length = *find_unit(unit);
    const double metres = to_si(dimension::kLength, units).apply(1);
    for (const double scale : {1.0, -1e-300, 1e300, 3e-7}) {
      const Curve conic = curve(fmt::format("{{ type = \"conic\", coefficients = [{}, {}, 0, {}, 0, {}] }}",
                                            0.1 * scale, 0.4 * scale, -0.2 * scale, -0.3 * scale),
                                above);
      // (x - 1)² + 4 y² = 4
      ASSERT_EQ(conic.kind, CurveKind::kEllipse) << unit << scale;
      EXPECT_NEAR(semi_axes(conic)[0] / metres, 2, 1e-14) << unit << scale;
      EXPECT_NEAR(semi_axes(conic)[1] / metres, 1, 1e-14) << unit << scale;
      EXPECT_NEAR(center(conic).x() / metres, 1, 1e-14) << unit << scale;
    }
  }
}

}  // namespace
}  // namespace higherpair
