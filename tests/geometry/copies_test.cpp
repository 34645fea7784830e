// A conic that is moved, rotated, mirrored or scaled has moved, rotated, mirrored or scaled answers.
#include "geometry/curvature.hpp"
#include "geometry/geometry_testing.hpp"
#include "higherpair/geometry/arc_length.hpp"
#include "higherpair/geometry/support.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

// x -> scale * R * M * x + shift, where M is the reflection in the x axis if `mirrored`.
struct Similarity {
  double scale = 1;
  bool mirrored = false;
  double angle = 0;
  Vector2d shift = Vector2d::Zero();

  [[nodiscard]] Vector2d direction(const Vector2d& v) const {
    return Rotation<double>::from_angle(angle) * Vector2d(v.x(), mirrored ? -v.y() : v.y());
  }
  [[nodiscard]] Vector2d point(const Vector2d& p) const { return scale * direction(p) + shift; }
  [[nodiscard]] double sense() const { return mirrored ? -1 : 1; }

  // The coefficients of f(image⁻¹(p)), up to a factor, with half as many digits again as a double.
  [[nodiscard]] std::array<double, 6> coefficients(const std::array<double, 6>& k) const {
    const double c = std::cos(angle) / scale;
    const double s = std::sin(angle) / scale;
    // x = c X + s Y + e, y = g (-s X + c Y) + f with (X, Y) the image
    const double g = sense();
    const double e = -(c * shift.x() + s * shift.y());
    const double f = g * (s * shift.x() - c * shift.y());
    const auto& [A, B, C, D, E, F] = k;
    return {A * c * c + B * s * s - g * C * c * s,
            A * s * s + B * c * c + g * C * c * s,
            2 * A * c * s - 2 * B * c * s + g * C * (c * c - s * s),
            2 * A * c * e - 2 * g * B * s * f + C * (c * f - g * s * e) + D * c - g * E * s,
            2 * A * s * e + 2 * g * B * c * f + C * (s * f + g * c * e) + D * s + g * E * c,
            A * e * e + B * f * f + C * e * f + D * e + E * f + F};
  }
};

Similarity random_similarity(Random& random, double scale) {
  return {scale, random.sign() > 0, random.angle(), random.vector(scale)};
}

// Compares two curves by their behaviour: the point of a normal, its radius, and the arc from there to
// another normal.
TEST(Copies, HaveTheImageOfEverySupportPointRadiusAndCenter) {
  for (const double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    SCOPED_TRACE(scale);
    Random random(91);
    Worst point, radius, center;
    for (int i = 0; i < 2000; ++i) {
      const NaturalConic conic = random_conic(random, i);
      if (conic.kind == CurveKind::kEllipse && std::abs(conic.a - conic.b) < 0.05) continue;
      const Similarity image = random_similarity(random, scale);
      const Curve original = conic.curve();
      const double t = 0.5 * random_parameter(random, conic);
      const auto copy =
          make_conic(image.coefficients(conic.coefficients()), conic.side, image.point(conic.point(t)));
      ASSERT_TRUE(copy) << describe(copy.error());

      const Vector2d n = conic.normal(t);
      const auto expected = support_point(place(original, Pose<double>{}), n);
      const auto found = support_point(place(*copy, Pose<double>{}), image.direction(n));
      point.see((found.p_W - image.point(expected.p_W)) / scale);
      radius.see(std::abs(found.rho / (scale * expected.rho) - 1));
      const auto shape = shape_by_slope(implicit_coefficients(*copy), found.p_W);
      center.see((shape.center - image.point(expected.p_W - expected.rho * n)) / scale /
                 (1 + std::abs(expected.rho)));
    }
    // Coefficients are rounded twice; the curves are up to 20 times longer than wide, and about their size
    // away.
    EXPECT_AT_MOST(point.value(), 3e-13);
    EXPECT_AT_MOST(radius.value(), 3e-13);
    EXPECT_AT_MOST(center.value(), 3e-13);
  }
}

TEST(Copies, HaveArcsOfTheSameLengthTimesTheScale) {
  for (const double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    SCOPED_TRACE(scale);
    Random random(92);
    Worst error;
    for (int i = 0; i < 2000; ++i) {
      const NaturalConic conic = random_conic(random, i);
      const Similarity image = random_similarity(random, scale);
      NaturalConic moved = conic;
      moved.origin_B = image.point(conic.origin_B);
      moved.a *= scale;
      moved.b *= scale;
      moved.rotation = image.angle + image.sense() * conic.rotation;
      const Curve original = conic.curve();
      const Curve copy = moved.curve();
      // The two may refer to different vertices, half a turn apart; arcs between two normals do not depend on
      // that.
      const auto arc = [](const Curve& curve, const Vector2d& from, const Vector2d& to) {
        const double start = std::remainder(angle_of(from) - vertex_normal_angle(curve), 2 * kPi);
        const double way = std::atan2(cross(from, to), from.dot(to));
        return arc_length(curve, start + way) - arc_length(curve, start);
      };
      const double t = 0.5 * random_parameter(random, conic);
      const Vector2d from = conic.sense() * conic.normal(t);
      const Vector2d to = conic.sense() * conic.normal(t + 0.4);
      const double expected = image.sense() * scale * arc(original, from, to);
      error.see(std::abs(arc(copy, image.direction(from), image.direction(to)) - expected) / scale);
    }
    EXPECT_AT_MOST(error.value(), 2e-13);  // radii up to 500 times the rounding of an angle
  }
}

TEST(Copies, OfABodyAreTheSameAsAMovedPose) {
  for (const double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    SCOPED_TRACE(scale);
    Random random(93);
    Worst error;
    for (int i = 0; i < 2000; ++i) {
      const NaturalConic conic = random_conic(random, i, scale);
      const Pose<double> X_WB = random.pose(scale);
      NaturalConic moved = conic;
      moved.origin_B = X_WB * conic.origin_B;
      moved.rotation += std::atan2(X_WB.R_WB.sin, X_WB.R_WB.cos);
      const double t = random_parameter(random, conic);
      const Vector2d n_W = X_WB.R_WB * conic.normal(t);
      const auto by_pose = support_point(place(conic.curve(), X_WB), n_W);
      const auto by_curve = support_point(place(moved.curve(), Pose<double>{}), n_W);
      error.see((by_pose.p_W - by_curve.p_W) / scale / (1 + std::abs(by_pose.rho) / scale));
    }
    EXPECT_AT_MOST(error.value(), 5e-15);
  }
}

}  // namespace
}  // namespace higherpair
