#include "higherpair/geometry/edges.hpp"

#include "higherpair/geometry/involute_span.hpp"
#include "higherpair/geometry/tolerances.hpp"

#include <gtest/gtest.h>

namespace higherpair {
namespace {

TEST(Edges, GoOnFromTheNormalsAtBothEndsAwayFromTheMaterial) {
  // Up along a wall with the material on its left, then along an arc to the left.
  const Boundary open = *Boundary::make(
      {face_span({0.03, -0.02}, {0.03, 0.01}), conic_span(*make_circle({0.023, 0.01}, 0.007), 0, 1.1)}, false,
      1e-12);
  const Boundary edged = with_edges(open);
  ASSERT_EQ(edged.spans().size(), 4U);
  EXPECT_FALSE(edged.is_closed());
  EXPECT_TRUE(edged.is_convex());
  EXPECT_TRUE(is_edge(edged, 0));
  EXPECT_FALSE(is_edge(edged, 1));
  EXPECT_FALSE(is_edge(edged, 2));
  EXPECT_TRUE(is_edge(edged, 3));
  const Bounds first = edged.spans()[0]->range();
  EXPECT_NEAR(first.low, -kEdgeTurn, 1e-15);
  EXPECT_NEAR(first.high, 0, 1e-15);
  const Bounds last = edged.spans()[3]->range();
  EXPECT_NEAR(last.low, 1.1, 1e-15);
  EXPECT_NEAR(last.high, 1.1 + kEdgeTurn, 1e-15);
  EXPECT_NEAR((edged.at({0, -1}).p_B - Vector2d(0.03, -0.02)).norm(), 0, 1e-17);
  EXPECT_NEAR((edged.at({3, 2}).p_B - open.at({1, 1.1}).p_B).norm(), 0, 1e-17);
  EXPECT_EQ(edged.joint_after(3), SpanJoint::kEnd);
  EXPECT_NEAR(edged.size(), open.size(), 1e-17);
  EXPECT_EQ(with_edges(edged).spans().size(), 4U) << "only once";
}

TEST(Edges, AreWhereACurveEndsAndNowhereElse) {
  const Boundary square = *Boundary::make(
      {face_span({0, 0}, {0.02, 0}), face_span({0.02, 0}, {0.02, 0.03}), face_span({0.02, 0.03}, {0, 0})},
      true, 1e-12);
  const Boundary same = with_edges(square);
  EXPECT_EQ(same.spans().size(), square.spans().size());
  for (int i = 0; i < static_cast<int>(same.spans().size()); ++i) {
    EXPECT_FALSE(is_edge(same, i)) << i;
  }
  EXPECT_FALSE(is_edge(boundary_of(*make_point({0.01, 0.02}), 1), 0));
}

TEST(Edges, AreNotWhereTheFlankOfAToothEnds) {
  const SpanPtr flank = involute_span({{0, 0}, 0.02, 0.1, Hand::kRight, {0.2, 0.6}});
  EXPECT_EQ(with_edges(*Boundary::make({flank}, false, 0)).spans().size(), 1U);
  // A straight foot, which has an end of its own, leads to the root of the flank.
  const SpanPoint root = flank->at(flank->range().low);
  const Vector2d t = perp(root.n_B);
  const Boundary tooth =
      with_edges(*Boundary::make({face_span(root.p_B - 0.002 * t, root.p_B), flank}, false, 1e-12));
  ASSERT_EQ(tooth.spans().size(), 3U);
  EXPECT_TRUE(is_edge(tooth, 0));
  EXPECT_FALSE(is_edge(tooth, 2));
}

// A boundary of several curves of one body.
TEST(Edges, AreThoseOfEveryPart) {
  const Boundary one = with_edges(*Boundary::make({face_span({0, 0}, {0.01, 0})}, false, 0));
  const Boundary two = with_edges(*Boundary::make({face_span({0.02, 0}, {0.03, 0})}, false, 0));
  const Boundary both = Boundary::of_parts({one, two, boundary_of(*make_circle({0.05, 0}, 0.01), 1)});
  std::vector<bool> edges;
  for (int i = 0; i < static_cast<int>(both.spans().size()); ++i) {
    edges.push_back(is_edge(both, i));
  }
  EXPECT_EQ(edges, (std::vector<bool>{true, false, true, true, false, true, false}));
}

}  // namespace
}  // namespace higherpair
