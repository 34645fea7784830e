#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/geometry/edges.hpp"
#include "random_boundaries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::RandomBoundaries;

Boundary rectangle(double width, double height) {
  const double x = width / 2;
  const double y = height / 2;
  return *Boundary::make({face_span({-x, -y}, {x, -y}), face_span({x, -y}, {x, y}),
                          face_span({x, y}, {-x, y}), face_span({-x, y}, {-x, -y})},
                         true, 1e-12);
}

Pose<double> placed(double angle, const Vector2d& p_WB) {
  return {Rotation<double>::from_angle(angle), p_WB};
}

// A boundary as a polygon in ground, much finer than its samples.
std::vector<Vector2d> fine_polygon(const Boundary& boundary, const Pose<double>& X_WB) {
  constexpr int kParts = 80;
  std::vector<Vector2d> points;
  for (const SpanPtr& span : boundary.spans()) {
    if (!span->is_corner()) {
      for (int k = 0; k < kParts; ++k) {
        points.push_back(X_WB * span->at(span->range().low + k * span->range().width() / kParts).p_B);
      }
    }
  }
  return points;
}

// Signed distance of a point to a polygon, > 0 inside, by its winding number.
double depth_in_polygon(const std::vector<Vector2d>& polygon, const Vector2d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  double turns = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d a = polygon[i] - p;
    const Vector2d b = polygon[(i + 1) % polygon.size()] - p;
    const Vector2d along = b - a;
    nearest =
        std::min(nearest, (a + std::clamp(-a.dot(along) / along.squaredNorm(), 0.0, 1.0) * along).norm());
    turns += std::atan2(cross(a, b), a.dot(b)) / (2 * kPi);
  }
  return std::abs(turns) > 0.5 ? nearest : -nearest;
}

double greatest_depth(const std::vector<Vector2d>& polygon1, const std::vector<Vector2d>& polygon2) {
  double depth = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon1.size(); i += 2) {
    depth = std::max(depth, depth_in_polygon(polygon2, polygon1[i]));
  }
  return depth;
}

TEST(Penetration, OfCirclesIsWhatTheirRadiiExceedTheirDistanceBy) {
  const Boundary one = boundary_of(*make_circle(Vector2d(0, 0), 0.03), 0.1);
  const Boundary two = boundary_of(*make_circle(Vector2d(0.01, 0), 0.02), 0.1);
  for (const double overlap : {-1e-3, -1e-9, 1e-9, 1e-6, 1e-3, 1e-2}) {
    const double far = 0.05 - overlap;
    const Pose<double> X_W2 = placed(1, far * unit_vector(0.7) - 0.01 * unit_vector(1));
    EXPECT_NEAR(deepest_penetration(one, {}, two, X_W2, 1e-10), std::max(overlap, 0.0), 1e-15) << overlap;
    EXPECT_EQ(bodies_overlap(one, {}, two, X_W2, 1e-10), overlap > 0) << overlap;
    EXPECT_EQ(bodies_overlap(two, X_W2, one, {}, 2 * std::abs(overlap)), false) << overlap;
  }
}

// The nearest place of a point within one of two discs that overlap may be on the other disc.
TEST(Penetration, InDiscsThatOverlapIsSeenInEachOfThem) {
  std::mt19937 random(29);
  std::uniform_real_distribution<double> radius(0.01, 0.03), place(-0.03, 0.03);
  int apart = 0;
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<Boundary> discs;
    const double r = radius(random) / 4;
    const Vector2d p_WD(2 * place(random), 2 * place(random));
    double expected = -1;
    for (int i = 0; i < 2 + trial % 3; ++i) {
      const Vector2d center(place(random), place(random));
      const double own = radius(random);
      discs.push_back(boundary_of(*make_circle(center, own), 1));
      expected = std::max(expected, own + r - (p_WD - center).norm());
    }
    const Boundary together = Boundary::of_parts(discs);
    const Boundary disc = boundary_of(*make_circle({0, 0}, r), 1);
    const double depth = deepest_penetration(together, {}, disc, placed(1, p_WD), 1e-9);
    EXPECT_EQ(depth > 0, expected > 0) << trial;
    EXPECT_LE(depth, std::max(expected, 0.0) + 1e-14) << trial;
    EXPECT_EQ(bodies_overlap(disc, placed(1, p_WD), together, {}, 1e-9), expected > 0) << trial;
    apart += expected < 0 ? 1 : 0;
  }
  EXPECT_GT(apart, 100);
}

TEST(Penetration, OfACornerIsItsDistanceToTheFace) {
  const Boundary square = rectangle(2, 2);
  EXPECT_NEAR(deepest_penetration(square, {}, square, placed(0, {1.7, 0.4}), 1e-9), 0.3, 1e-14);
  EXPECT_FALSE(bodies_overlap(square, {}, square, placed(0, {2 + 1e-8, 0.4}), 1e-9));
  EXPECT_TRUE(bodies_overlap(square, {}, square, placed(kPi / 4, {0, 1 + std::sqrt(2) - 1e-8}), 1e-9));
  EXPECT_FALSE(bodies_overlap(square, {}, square, placed(kPi / 4, {0, 1 + std::sqrt(2) + 1e-8}), 1e-9));
}

// A long face has samples at its ends only, which are corners.
TEST(Penetration, OfADiscOverTheMiddleOfALongFaceIsWhatItIsInIt) {
  const Boundary block =
      *Boundary::make({face_span({0.04, 0}, {-0.04, 0}), face_span({-0.04, 0}, {-0.04, -0.05}),
                       face_span({-0.04, -0.05}, {0.04, -0.05}), face_span({0.04, -0.05}, {0.04, 0})},
                      true, 0);
  const Boundary face = with_edges(*Boundary::make({face_span({0.04, 0}, {-0.04, 0})}, false, 0));
  for (const Boundary* boundary : {&block, &face}) {
    for (const double depth : {-0.001, 0.0, 0.0003}) {
      const Boundary disc = boundary_of(*make_circle({0, 0.01 - depth}, 0.01), 1);
      for (const double turned : {0.0, kPi / 2, 0.3}) {
        const Pose<double> X_WD{
            Rotation<double>::from_angle(turned),
            Vector2d(0, 0.01 - depth) - Rotation<double>::from_angle(turned) * Vector2d(0, 0.01 - depth)};
        EXPECT_NEAR(deepest_penetration(disc, X_WD, *boundary, {}, 1e-12), std::max(depth, 0.0), 1e-15)
            << turned;
        EXPECT_NEAR(deepest_penetration(*boundary, {}, disc, X_WD, 1e-12), std::max(depth, 0.0), 1e-15)
            << turned;
      }
    }
  }
}

// Any face or corner may be the nearest. On a body with hollows samples farther along may be nearer, and a
// disc beyond a thin part is behind the face on the far side.
TEST(Penetration, OfADiscInAHollowPolygonIsNoneWhereItIsAsFarFromItAsItsRadius) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> radius(0.015, 0.06), shift(-0.3, 0.3), place(-0.09, 0.09);
  for (int trial = 0; trial < 300; ++trial) {
    const int corners = 4 + trial % 7;
    std::vector<Vector2d> points;
    std::vector<SpanPtr> spans;
    for (int i = 0; i < corners; ++i) {
      points.push_back(radius(random) * unit_vector(2 * kPi * (i + shift(random)) / corners));
    }
    const Vector2d center(place(random), place(random));
    double distance = std::numeric_limits<double>::infinity();
    int crossings = 0;  // of the boundary by a ray from the centre
    for (int i = 0; i < corners; ++i) {
      const Vector2d& a = points[i];
      const Vector2d& b = points[(i + 1) % corners];
      spans.push_back(face_span(a, b));
      const double share = std::clamp((center - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      distance = std::min(distance, (center - a - share * (b - a)).norm());
      if ((a.y() > center.y()) != (b.y() > center.y())) {
        crossings += center.x() < a.x() + (center.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) ? 1 : 0;
      }
    }
    if (crossings % 2 == 1) {
      continue;
    }
    const Boundary polygon = *Boundary::make(spans, true, 1e-12);
    for (const double more : {-1e-12, -1e-4, 1e-4}) {
      const Boundary disc = boundary_of(*make_circle(center, distance + more), 1);
      const double depth = deepest_penetration(polygon, {}, disc, {}, 1e-10);
      EXPECT_EQ(depth > 0, more > 0) << trial << ' ' << more << ' ' << depth;
      EXPECT_LE(depth, std::max(more, 0.0) + 1e-12) << trial;
    }
  }
}

// The sides of a polygon as a boundary, counter-clockwise.
Boundary polygon_of(const std::vector<Vector2d>& corners) {
  std::vector<SpanPtr> spans;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    spans.push_back(face_span(corners[i], corners[(i + 1) % corners.size()]));
  }
  return *Boundary::make(spans, true, 1e-12);
}

// Area that two convex polygons share: that of the first after clipping along every side of the other (I. E.
// Sutherland and G. W. Hodgman, Reentrant Polygon Clipping, CACM 17, 1974).
double shared_area(std::vector<Vector2d> left, const std::vector<Vector2d>& other) {
  for (std::size_t i = 0; i < other.size(); ++i) {
    const Vector2d& a = other[i];
    const Vector2d along = other[(i + 1) % other.size()] - a;
    std::vector<Vector2d> cut;
    for (std::size_t k = 0; k < left.size(); ++k) {
      const Vector2d &p = left[k], &q = left[(k + 1) % left.size()];
      const double at_p = cross(along, Vector2d(p - a)), at_q = cross(along, Vector2d(q - a));
      if (at_p >= 0) {
        cut.push_back(p);
      }
      if (at_p * at_q < 0) {
        cut.push_back(p + at_p / (at_p - at_q) * (q - p));
      }
    }
    left = cut;
  }
  double twice = 0;
  for (std::size_t k = 0; k < left.size(); ++k) {
    twice += cross(left[k], left[(k + 1) % left.size()]);
  }
  return twice / 2;
}

TEST(Penetration, OfTwoBarsThatCrossIsHalfTheWidthOfTheThinnerOne) {
  const auto bar = [](double length, double width) {
    return std::vector<Vector2d>{
        {-length, -width / 2}, {length, -width / 2}, {length, width / 2}, {-length, width / 2}};
  };
  const Boundary one = polygon_of(bar(0.07, 0.004));
  const Boundary two = polygon_of(bar(0.05, 0.0026));
  for (const double angle : {0.31, 1.1, kPi / 2, 2.3}) {
    for (const double along : {-0.04, 0.0, 0.0123}) {
      const Pose<double> X_W2{Rotation<double>::from_angle(angle), Vector2d(along, 0.003)};
      const double depth = deepest_penetration(one, {}, two, X_W2, 1e-9);
      EXPECT_GE(depth, 0.0013 - 1e-15) << angle << ' ' << along;
      EXPECT_LE(depth, 0.002 + 1e-15) << angle << ' ' << along;
    }
  }
}

TEST(Penetration, OfConvexPolygonsIsSeenWhereverTheyShareAnArea) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> shape(0.02, 0.06), slender(0.03, 1), place(-0.06, 0.06),
      turn(-kPi, kPi);
  int across = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::array<std::vector<Vector2d>, 2> corners_W;
    std::array<std::vector<Vector2d>, 2> corners;
    std::array<Pose<double>, 2> X_WB;
    for (std::size_t body = 0; body < 2; ++body) {
      const int count = 3 + (trial + static_cast<int>(body)) % 5;
      const double length = shape(random), width = length * slender(random);
      for (int i = 0; i < count; ++i) {
        const Vector2d at = unit_vector(2 * kPi * (i + 0.3 * slender(random)) / count);
        corners[body].emplace_back(length * at.x(), width * at.y());
      }
      X_WB[body] = {Rotation<double>::from_angle(turn(random)), Vector2d(place(random), place(random))};
      for (const Vector2d& corner : corners[body]) {
        corners_W[body].push_back(X_WB[body] * corner);
      }
    }
    const double area = shared_area(corners_W[0], corners_W[1]);
    const double depth =
        deepest_penetration(polygon_of(corners[0]), X_WB[0], polygon_of(corners[1]), X_WB[1], 1e-9);
    // A shared sliver that is thinner than the tolerance does not count.
    EXPECT_EQ(depth > 0, area > 1e-10) << trial << ' ' << area << ' ' << depth;
    const auto is_in = [&](std::size_t body, const Vector2d& p) {
      for (std::size_t i = 0; i < corners_W[body].size(); ++i) {
        const Vector2d& a = corners_W[body][i];
        if (cross(Vector2d(corners_W[body][(i + 1) % corners_W[body].size()] - a), Vector2d(p - a)) < 0) {
          return false;
        }
      }
      return true;
    };
    const bool no_corner =
        std::none_of(corners_W[0].begin(), corners_W[0].end(), [&](auto& p) { return is_in(1, p); }) &&
        std::none_of(corners_W[1].begin(), corners_W[1].end(), [&](auto& p) { return is_in(0, p); });
    across += area > 1e-10 && no_corner ? 1 : 0;
  }
  EXPECT_GT(across, 20);
}

TEST(Penetration, OfRandomBodiesAgreesWithPolygons) {
  int apart = 0;
  int overlapping = 0;
  RandomBoundaries random(20, 0.05);
  for (int i = 0; i < 150; ++i) {
    const Boundary one = random.boundary();
    const Boundary two = random.boundary();
    const Pose<double> X_W1 = placed(random.between(-3, 3), random.place(1));
    const Pose<double> X_W2 = placed(random.between(-3, 3), random.place(1));
    const double tolerance = 1e-9;
    const double depth = deepest_penetration(one, X_W1, two, X_W2, tolerance);
    EXPECT_EQ(bodies_overlap(one, X_W1, two, X_W2, tolerance), depth > 0) << i;
    EXPECT_EQ(bodies_overlap(two, X_W2, one, X_W1, tolerance), depth > 0) << i;
    const std::vector<Vector2d> polygon1 = fine_polygon(one, X_W1);
    const std::vector<Vector2d> polygon2 = fine_polygon(two, X_W2);
    const double wanted = std::max(greatest_depth(polygon1, polygon2), greatest_depth(polygon2, polygon1));
    // Half the longest distance of two probes; the polygons deviate less from the curves.
    const double error = 3e-3;
    if (wanted > error) {
      ++overlapping;
      EXPECT_GT(depth, 0) << i;
    } else if (wanted < -error) {
      ++apart;
      EXPECT_EQ(depth, 0) << i;
    }
  }
  EXPECT_GT(apart, 30);
  EXPECT_GT(overlapping, 50);
}

}  // namespace
}  // namespace higherpair
