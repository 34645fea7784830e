#include "higherpair/geometry/boundary_points.hpp"

#include "geometry/span_testing.hpp"
#include "higherpair/geometry/arc_length.hpp"
#include "higherpair/geometry/contour.hpp"
#include "higherpair/geometry/involute_span.hpp"

namespace higherpair {
namespace {

Boundary rounded_square() {
  std::vector<ContourPiece> pieces;
  const std::vector<Vector2d> corners = {{0, 0}, {0.03, 0}, {0.03, 0.02}, {0, 0.02}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    pieces.push_back(LinePiece{corners[i], corners[(i + 1) % corners.size()]});
  }
  return testing::boundary(spans_of(with_fillets(pieces, true, 0.004)->pieces), true);
}

TEST(BoundaryPoints, LengthsAreThoseOfClosedForms) {
  // The length of an ellipse by Carlson's integrals, of an involute r φ²/2.
  const Curve ellipse = *make_ellipse({0.004, -0.001}, {0.031, 0.0127}, 0.3);
  EXPECT_NEAR(length_of(boundary_of(ellipse, 1)) / arc_length(ellipse, 2 * kPi), 1, 1e-11);
  const Involute involute = {{0.003, -0.002}, 0.0231, 0.7, Hand::kLeft, {0.05, 1.31}};
  EXPECT_NEAR(length_of(testing::boundary({involute_span(involute)}, false)),
              0.0231 * (1.31 * 1.31 - 0.05 * 0.05) / 2, 1e-15);
  EXPECT_NEAR(length_of(rounded_square()), 2 * (0.03 + 0.02) - 8 * 0.004 + 2 * kPi * 0.004, 1e-15);
}

TEST(BoundaryPoints, AtEqualArcsAreOneStepApart) {
  const double r = 0.0231;
  const Boundary circle = boundary_of(*make_circle({0.01, 0.02}, r), 1);
  const auto round = points_at_equal_arcs(circle, 7);
  ASSERT_EQ(round.size(), 7U);
  for (std::size_t i = 0; i < round.size(); ++i) {
    const std::size_t next = (i + 1) % round.size();
    EXPECT_NEAR((round[next].point.p_B - round[i].point.p_B).norm(), 2 * r * std::sin(kPi / 7), 1e-16);
    EXPECT_NEAR(round[i].arc, 2 * kPi * r * static_cast<double>(i) / 7, 1e-15);
  }
  // Roll angles φ at equal steps of r φ²/2, including both ends.
  const Involute involute = {{0, 0}, r, 0, Hand::kRight, {0.2, 1.4}};
  const auto along = points_at_equal_arcs(testing::boundary({involute_span(involute)}, false), 5);
  ASSERT_EQ(along.size(), 5U);
  for (std::size_t i = 0; i < along.size(); ++i) {
    const double squared = 0.2 * 0.2 + static_cast<double>(i) / 4 * (1.4 * 1.4 - 0.2 * 0.2);
    EXPECT_NEAR(1 / along[i].point.kappa, r * std::sqrt(squared), 1e-14);
  }
  EXPECT_EQ(points_at_equal_arcs(rounded_square(), 1000).size(), 1000U);
}

TEST(BoundaryPoints, WithinAToleranceHaveTheEndsOfAllSpans) {
  const double tolerance = 1e-6;
  const auto points = points_within(rounded_square(), tolerance);
  double arc = -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_GT(points[i].arc, arc);  // no point twice: all joints are smooth
    arc = points[i].arc;
    const SpanPoint& a = points[i].point;
    const SpanPoint& b = points[(i + 1) % points.size()].point;
    const double chord = (b.p_B - a.p_B).norm();
    if (a.kappa > 0 && b.kappa > 0) {
      EXPECT_LE(chord * chord / 8 * a.kappa, tolerance * 1.01);
    }
  }
  // Four sides with one point each, and four quarter rounds.
  EXPECT_GT(points.size(), 4U + 4U * 8U);
}

TEST(BoundaryPoints, CornersAndNotchesHaveBothNormals) {
  // An arrow head: convex corners and one notch, at (1, 0).
  const std::vector<Vector2d> corners = {{0.01, 0}, {0, -0.02}, {0.05, 0}, {0, 0.02}};
  std::vector<SpanPtr> spans;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    spans.push_back(face_span(corners[i], corners[(i + 1) % corners.size()]));
  }
  const auto points = points_within(testing::boundary(spans, true), 1e-6);
  ASSERT_EQ(points.size(), 8U);
  int rounds = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    rounds += points[i].corner ? 1 : 0;
    const auto same = [&](std::size_t k) {
      return (points[k].point.p_B - points[i].point.p_B).norm() < 1e-15;
    };
    EXPECT_TRUE(same((i + 1) % 8) || same((i + 7) % 8)) << i;
  }
  EXPECT_EQ(rounds, 6);  // the notch is not rounded
  // An open outline ends at its end points.
  spans.pop_back();
  const auto open = points_within(testing::boundary(spans, false), 1e-6);
  ASSERT_EQ(open.size(), 6U);
  EXPECT_EQ(open.front().point.p_B, corners.front());
  EXPECT_NEAR((open.back().point.p_B - corners.back()).norm(), 0, 1e-16);
}

}  // namespace
}  // namespace higherpair
