#include "higherpair/geometry/arc_polyline.hpp"

#include "geometry/arc_testing.hpp"
#include "geometry/span_testing.hpp"
#include "higherpair/geometry/contour.hpp"
#include "higherpair/geometry/involute_span.hpp"
#include "higherpair/geometry/spline_span.hpp"

#include <cmath>

namespace higherpair {
namespace {

using testing::Worst;
using testing::worst_distance;

// The largest angle between the arcs that meet at a vertex.
double worst_corner(const ArcPolyline& line) {
  Worst worst;
  const std::size_t count = line.vertices.size();
  for (std::size_t i = line.closed ? 0 : 1; i + (line.closed ? 0 : 1) < count; ++i) {
    const ArcVertex& before = line.vertices[(i + count - 1) % count];
    const ArcVertex& here = line.vertices[i];
    const Vector2d in = here.p_B - before.p_B;
    const Vector2d out = line.vertices[(i + 1) % count].p_B - here.p_B;
    const double turn =
        std::atan2(cross(in, out), in.dot(out)) - 2 * std::atan(before.bulge) - 2 * std::atan(here.bulge);
    worst.see(std::abs(turn));
  }
  return worst.value();
}

Boundary ellipse() {
  return boundary_of(*make_ellipse({0.004, -0.001}, {0.031, 0.0127}, 0.3), 1);
}

TEST(ArcPolyline, StaysWithinItsToleranceOfAnyCurve) {
  Involute involute = {{0.003, -0.002}, 0.0231, 0.7, Hand::kLeft, {0.05, 1.31}};
  std::vector<Vector2d> points;
  for (int i = 0; i < 60; ++i) {
    const double angle = 2 * kPi * i / 60;
    points.push_back((0.03 + 0.009 * std::cos(3 * angle)) * unit_vector(angle));  // with inflections
  }
  SplineOptions closed;
  closed.closed = true;
  const std::vector<Boundary> curves = {
      ellipse(),
      boundary_of(*make_ellipse({0, 0}, {0.031, 0.0127}, 0.3, Side::kOutside), 1),
      boundary_of(*make_parabola({0.001, 0.002}, 0.0127, 0.4), 0.08),
      boundary_of(*make_hyperbola({0.001, 0.002}, {0.031, 0.0127}, 0.4), 0.11),
      testing::boundary({involute_span(involute)}, false),
      testing::boundary({*spline_span(points, closed)}, true)};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
      const ArcPolyline line = arc_polyline(curves[i], tolerance);
      EXPECT_AT_MOST(worst_distance(curves[i], line), tolerance) << i;
      EXPECT_AT_MOST(worst_corner(line), 1e-7) << i << " " << tolerance;
      EXPECT_EQ(line.closed, curves[i].is_closed());
    }
  }
}

// A disc of 30 mm with a smooth bump of 0.3 mm over 3 degrees, through a point every half degree: wherever it
// is, its points are on the polyline.
TEST(ArcPolyline, KeepsWhatIsNarrowAgainstTheWholeSpan) {
  for (const double at : {17.0, 100.5, 299.7}) {
    std::vector<Vector2d> points;
    for (int i = 0; i < 720; ++i) {
      const double off = std::abs(i / 2.0 - at) / 1.5;
      const double bump = off < 1 ? 0.3e-3 * std::pow(std::cos(off * kPi / 2), 4) : 0;
      points.push_back((0.03 + bump) * unit_vector(i / 2.0 * kPi / 180));
    }
    SplineOptions closed;
    closed.closed = true;
    const Boundary curve = testing::boundary({*spline_span(points, closed)}, true);
    const ArcPolyline line = arc_polyline(curve, 4e-7);
    EXPECT_AT_MOST(worst_distance(points, line), 4e-7) << at;
    EXPECT_LT(line.vertices.size(), 100U);
    EXPECT_AT_MOST(
        worst_distance(curve, arc_polyline(testing::boundary({reversed_span(curve.spans()[0])}, true), 4e-7)),
        4e-7);
  }
}

TEST(ArcPolyline, TakesTenTimesAsManyArcsForAThousandthOfTheTolerance) {
  const auto count = [](double tolerance) {
    return static_cast<double>(arc_polyline(ellipse(), tolerance).vertices.size());
  };
  EXPECT_LT(count(1e-5), 50);
  EXPECT_LT(count(1e-8) / count(1e-5), 16);
  EXPECT_GT(count(1e-8) / count(1e-5), 5);
}

TEST(ArcPolyline, LeavesLinesAndArcsWhatTheyAre) {
  // A slot of two half discs and two straight sides, traversed counter-clockwise.
  const double r = 0.0127;
  const double l = 0.031;
  const Boundary slot =
      testing::boundary({span_of(ArcPiece{{l, 0}, r, -kPi / 2, kPi}), span_of(LinePiece{{l, r}, {-l, r}}),
                         span_of(ArcPiece{{-l, 0}, r, kPi / 2, kPi}), span_of(LinePiece{{-l, -r}, {l, -r}})},
                        true);
  const ArcPolyline line = arc_polyline(slot, 1e-3);
  ASSERT_EQ(line.vertices.size(), 6U);  // each half disc in two quarters
  EXPECT_EQ(line.vertices[2].bulge, 0);
  EXPECT_EQ(line.vertices[5].bulge, 0);
  for (const std::size_t quarter : {0U, 1U, 3U, 4U}) {
    EXPECT_NEAR(line.vertices[quarter].bulge, std::tan(kPi / 8), 1e-14);
  }
  EXPECT_AT_MOST(worst_distance(slot, line), 1e-16);
  // A concave arc bends clockwise.
  const ArcPolyline hollow =
      arc_polyline(testing::boundary({span_of(ArcPiece{{l, 0}, r, 1.1, -0.9})}, false), 1e-3);
  ASSERT_EQ(hollow.vertices.size(), 2U);
  EXPECT_NEAR(hollow.vertices[0].bulge, -std::tan(0.9 / 4), 1e-14);
}

TEST(ArcPolyline, KeepsCorners) {
  const std::vector<Vector2d> square = {{0, 0}, {0.03, 0}, {0.03, 0.02}, {0, 0.02}};
  std::vector<SpanPtr> spans;
  for (std::size_t i = 0; i < square.size(); ++i) {
    spans.push_back(face_span(square[i], square[(i + 1) % square.size()]));
  }
  const ArcPolyline line = arc_polyline(testing::boundary(spans, true), 1e-6);
  ASSERT_EQ(line.vertices.size(), 4U);
  for (std::size_t i = 0; i < square.size(); ++i) {
    EXPECT_EQ(line.vertices[i].p_B, square[i]);
    EXPECT_EQ(line.vertices[i].bulge, 0);
  }
}

}  // namespace
}  // namespace higherpair
