#include "geometry/span_testing.hpp"
#include "higherpair/geometry/involute_span.hpp"
#include "higherpair/geometry/spline_span.hpp"

#include <utility>

namespace higherpair {
namespace {

using testing::expect_bounds;

std::vector<Vector2d> uneven_points() {
  std::vector<Vector2d> points;
  for (int i = 0; i < 37; ++i) {
    const double a = 2 * kPi * (i + 0.3 * std::sin(2.1 * i)) / 37;
    points.push_back((25 + 5 * std::cos(a) + 2 * std::sin(3 * a)) * unit_vector(a));
  }
  return points;
}

TEST(SpanBounds, OfConicsHoldOnBothSides) {
  unsigned seed = 0;
  for (const Side side : {Side::kInside, Side::kOutside}) {
    expect_bounds(*conic_span(*make_circle({3, 1}, 2.7, side), -2, 4), ++seed);
    expect_bounds(*conic_span(*make_ellipse({3, 1}, {2.7, 1.1}, 0.4, side), -2.2, 4), ++seed);
    expect_bounds(*conic_span(*make_ellipse({3, 1}, {0.7, 5.1}, 2.4, side), 0.2, 1.3), ++seed);
    expect_bounds(*conic_span(*make_parabola({3, 1}, 0.8, 0.3, side), kPi - 0.9, kPi + 1.2), ++seed);
    expect_bounds(*conic_span(*make_hyperbola({3, 1}, {2.1, 1.7}, 0.3, side), kPi - 0.2, kPi + 0.7), ++seed);
  }
}

TEST(SpanBounds, OfFacesAndCornersAreTheirValues) {
  expect_bounds(*face_span({1, 2}, {-3, 7}), 21);
  expect_bounds(*corner_span({1, 2}, -3, 1), 22);
}

TEST(SpanBounds, OfInvolutesHoldOnBothHands) {
  for (const Hand hand : {Hand::kLeft, Hand::kRight}) {
    expect_bounds(*involute_span({{0.003, -0.002}, 0.0231, 0.7, hand, {0.05, 1.31}}), 31);
  }
}

TEST(SpanBounds, OfSplinesHoldOverAnyNumberOfTheirPoints) {
  unsigned seed = 40;
  for (const int degree : {3, 5}) {
    for (const bool closed : {false, true}) {
      SplineOptions options;
      options.degree = degree;
      options.closed = closed;
      expect_bounds(**spline_span(uneven_points(), options), ++seed);
    }
  }
}

TEST(SpanBounds, OfRationalSplinesHold) {
  NurbsCurve curve;
  curve.degree = 4;
  curve.control = {{0, 0}, {2, -1}, {4, 0.5}, {5, 3}, {3, 4.5}, {0, 4}, {-2, 5}};
  curve.weights = {1, 0.7, 1.9, 1.2, 0.6, 1.4, 1};
  curve.knots = {0, 0, 0, 0, 0, 0.3, 0.7, 1, 1, 1, 1, 1};
  unsigned seed = 50;
  for (const bool rational : {true, false}) {
    curve.weights = rational ? curve.weights : std::vector<double>{};
    for (const SpanPtr& span : nurbs_spans(curve)) {
      expect_bounds(*span, ++seed);
      expect_bounds(*offset_span(span, 0.05), ++seed);
    }
  }
}

TEST(SpanBounds, OfOffsetAndReversedSpansHold) {
  const SpanPtr ellipse = conic_span(*make_ellipse({3, 1}, {2.7, 1.1}, 0.4), -2.2, 4);
  const SpanPtr spline = *spline_span(uneven_points());
  unsigned seed = 60;
  for (const SpanPtr& span : {ellipse, spline}) {
    expect_bounds(*offset_span(span, 0.3), ++seed);
    expect_bounds(*offset_span(span, -0.3), ++seed);
    expect_bounds(*reversed_span(span), ++seed);
    expect_bounds(*reversed_span(offset_span(span, 0.3)), ++seed);
  }
}

// A kind of span that defines no bounds has none.
TEST(SpanBounds, AreNotGivenByAKindThatHasNone) {
  class Plain final : public Span {
    [[nodiscard]] SpanPoint at(double t) const override { return {{t, 0}, {0, -1}, 0, 0, 1}; }
    [[nodiscard]] Bounds range() const override { return {0, 1}; }
  };
  EXPECT_FALSE(Plain().bounds({0, 1}));
  EXPECT_FALSE(reversed_span(std::make_shared<Plain>())->bounds({-1, 0}));
  EXPECT_FALSE(offset_span(std::make_shared<Plain>(), 1)->bounds({0, 1}));
}

}  // namespace
}  // namespace higherpair
