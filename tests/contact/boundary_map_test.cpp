#include "contact/random_pair.hpp"
#include "geometry/geometry_testing.hpp"
#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/contact/contact_map.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::follower_difference;
using testing::mapped_pair;
using testing::RandomPair;

constexpr double kReach = 200;  // length of lines and open conics, beyond everything compared
constexpr double kLimit = 50;   // contacts farther from their curve's vertex are left out

MapRange range_of(const ContactPair& pair, double u) {
  MapRange range;
  range.start = pair.motion1.turns ? u : -3;
  range.end = 3;
  range.samples = 7;
  return range;
}

// The curves of a pair as boundaries.
struct Boundaries {
  explicit Boundaries(const ContactPair& pair, double reach = kReach)
      : first(boundary_of(pair.curve1, reach)),
        second(boundary_of(pair.curve2, reach)),
        both{&first, pair.motion1, &second, pair.motion2} {}
  Boundary first, second;
  BoundaryPair both;
};

bool is_far(const ContactPair& pair, const TangentPosition& at) {
  const Vector2d one = pose_at(pair.motion1, at.u) * pair.curve1.vertex_B;
  const Vector2d two = pose_at(pair.motion2, at.q) * pair.curve2.vertex_B;
  return (at.p_W - one).norm() > kLimit || (at.p_W - two).norm() > kLimit;
}

bool is_open(const Curve& curve) {
  return is_conic(curve) && curve.q <= 0;
}

void expect_all_contacts(const ContactPair& pair, const ContactMap& map, double u) {
  std::vector<MapContact> mapped = contacts_at(map, u);
  const auto far = [&](const MapContact& at) { return is_far(pair, at.point); };
  mapped.erase(std::remove_if(mapped.begin(), mapped.end(), far), mapped.end());
  std::size_t listed = 0;
  for (const CurveContact& contact : find_curve_contacts(pair, u).contacts) {
    if (is_far(pair, contact)) {
      continue;
    }
    ++listed;
    const auto same = std::count_if(mapped.begin(), mapped.end(), [&](const MapContact& at) {
      return map.branches[at.branch].opposed == contact.opposed &&
             follower_difference(pair, at.point.q, contact.q) <= 1e-10 &&
             (at.point.n_W - contact.n_W).norm() <= 1e-7;
    });
    EXPECT_EQ(same, 1) << "u = " << u << ", q = " << contact.q;
  }
  EXPECT_EQ(mapped.size(), listed) << "u = " << u;
}

TEST(BoundaryMap, OfConicsHoldsEveryContactThatTheAlgebraFinds) {
  int complete = 0;
  for (unsigned number = 0; number < 144; number += 7) {
    const RandomPair random = mapped_pair(number);
    SCOPED_TRACE(random.text);
    const Boundaries boundaries(random.pair);
    const ContactMap map = map_contacts(boundaries.both, range_of(random.pair, random.u), {true, true});
    ASSERT_EQ(map.status, MapStatus::kOk);
    // Far out on two open curves a branch may be missed; then the map reports that it is incomplete.
    if (!map.complete) {
      EXPECT_TRUE(is_open(random.pair.curve1) || is_open(random.pair.curve2));
      continue;
    }
    ++complete;
    std::mt19937 generator(number);
    expect_all_contacts(random.pair, map, std::uniform_real_distribution<double>(-3, 3)(generator));
  }
  EXPECT_GE(complete, 14);
}

TEST(BoundaryMap, OfConicsHasTheirFoldsAndConformingContacts) {
  int compared = 0;
  for (unsigned number = 0; number < 36; ++number) {
    const RandomPair random = mapped_pair(number);
    if (is_open(random.pair.curve1) || is_open(random.pair.curve2)) {
      continue;
    }
    SCOPED_TRACE(random.text);
    const MapRange range = range_of(random.pair, random.u);
    const ContactMap expected = map_contacts(random.pair, range);
    const Boundaries boundaries(random.pair);
    const ContactMap map = map_contacts(boundaries.both, range, {true, true});
    EXPECT_EQ(map.branches.size(), expected.branches.size());
    ASSERT_EQ(map.events.size(), expected.events.size());
    for (std::size_t i = 0; i < map.events.size(); ++i) {
      const CriticalPosition &at = map.events[i].at, &wanted = expected.events[i].at;
      EXPECT_EQ(at.type, wanted.type);
      EXPECT_EQ(at.opposed, wanted.opposed);
      EXPECT_NEAR(at.u, wanted.u, 1e-12 * (1 + std::abs(wanted.u)));
      EXPECT_LE(follower_difference(random.pair, at.q, wanted.q), 1e-7);
      EXPECT_EQ(map.events[i].branches.size(), expected.events[i].branches.size());
      ++compared;
    }
  }
  EXPECT_GE(compared, 20);
}

SpanPtr arc(const Vector2d& center, double radius, double from, double to, Side side = Side::kInside) {
  return conic_span(make_circle(center, radius, side).value(), from * testing::kDegree,
                    to * testing::kDegree);
}

Boundary closed(const std::vector<SpanPtr>& spans) {
  return Boundary::make(spans, true, 1e-12).value();
}

OneFreedom sliding_up() {
  OneFreedom motion;
  motion.turns = false;
  motion.direction_W = Vector2d::UnitY();
  return motion;
}

Boundary face_downwards() {
  return boundary_of(make_line(Vector2d::Zero(), -Vector2d::UnitY()).value(), 1000);
}

// Base circle 20, two flanks of radius 38, nose of radius 8: the triangle of their centres has sides 18,
// 24, 30.
const double kNose = std::atan2(18, 24) / testing::kDegree;

Boundary four_arcs() {
  return closed({arc({24, 0}, 8, -kNose, kNose), arc({0, -18}, 38, kNose, 90), arc({0, 0}, 20, 90, 270),
                 arc({0, 18}, 38, 270, 360 - kNose)});
}

// The support of the arc whose normal is at `angle` degrees, in (-90, 270].
double four_arcs_support(double angle) {
  const double x = std::abs(angle > 180 ? angle - 360 : angle);
  const double c = std::cos(x * testing::kDegree), s = std::sin(x * testing::kDegree);
  return x <= kNose ? 24 * c + 8 : x <= 90 ? 38 - 18 * s : 20;
}

TEST(BoundaryMap, OfAFourArcCamUnderAFlatFaceIsTheSupportOfItsArcs) {
  const Boundary cam = four_arcs();
  const Boundary face = face_downwards();
  MapRange range;
  range.samples = 721;
  const ContactMap map = map_contacts({&cam, {}, &face, sliding_up()}, range, {false, true});
  ASSERT_EQ(map.status, MapStatus::kOk);
  EXPECT_TRUE(map.complete);
  const auto own = std::find_if(map.branches.begin(), map.branches.end(),
                                [](const MapBranch& one) { return one.opposed; });
  ASSERT_NE(own, map.branches.end());
  EXPECT_EQ(own->turns, 1);
  ASSERT_EQ(own->points.size(), 721U);
  for (const MapPoint& point : own->points) {
    EXPECT_NEAR(point.q, four_arcs_support(90 - point.u / testing::kDegree), 1e-13 * 38);
    EXPECT_TRUE(point.free);
  }
  // Highest with the nose at the top; it begins to rise again where the base circle ends.
  ASSERT_EQ(own->extremes.size(), 2U);
  EXPECT_NEAR(own->extremes[0].u, 0, 1e-12);
  EXPECT_NEAR(own->extremes[1].u, kPi / 2, 1e-13);
}

TEST(BoundaryMap, OfAFourArcCamUnderARollerIsThatOfCirclesWithinTheirAngles) {
  const Boundary cam = four_arcs();
  const double r = 7;
  const Boundary roller = boundary_of(make_circle(Vector2d::Zero(), r).value(), 1);
  MapRange range;
  range.samples = 97;
  const ContactMap map = map_contacts({&cam, {}, &roller, sliding_up()}, range);
  EXPECT_TRUE(map.complete);
  int checked = 0;
  for (const MapBranch& branch : map.branches) {
    for (const MapPoint& point : branch.points) {
      if (!branch.opposed || point.q < 0) {
        continue;
      }
      // The roller's centre is at the distance ρ + r from the centre of the arc that it touches.
      const Vector2d center = Rotation<double>::from_angle(-point.u) * Vector2d(0, point.q);
      const Vector2d n = Rotation<double>::from_angle(-point.u) * point.n_W;
      const double angle = std::abs(angle_of(n)) / testing::kDegree;
      const double side = n.y() > 0 ? -1 : 1;
      const Vector2d from = angle <= kNose ? Vector2d(24, 0)
                            : angle <= 90  ? Vector2d(0, 18 * side)
                                           : Vector2d(0, 0);
      const double rho = angle <= kNose ? 8 : angle <= 90 ? 38 : 20;
      EXPECT_NEAR((center - from).norm(), rho + r, 1e-12);
      EXPECT_TRUE(point.free);
      ++checked;
    }
  }
  EXPECT_EQ(checked, 97);
}

// The lever's roller reaches the disc only near the position in which the disc's centre is nearest to the
// lever's pivot: up to the angle at which the three centres are in line. So close to where a branch vanishes,
// the map may leave it undecided whether there is another branch.
TEST(BoundaryMap, HasTheSmallestBranches) {
  std::mt19937 random(3);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE(trial);
    const double e = uniform(5, 20), d = uniform(60, 120), r1 = uniform(20, 30), r2 = uniform(3, 10);
    const double reach = d - e + d * std::pow(10, uniform(-7, -2));
    const double a = uniform(0, 360), b = uniform(0, 360);
    const Boundary disc = closed({arc({e, 0}, r1, a, a + 170), arc({e, 0}, r1, a + 170, a + 360)});
    const Vector2d middle(reach - r1 - r2, 0);
    const Boundary roller = closed({arc(middle, r2, b, b + 200), arc(middle, r2, b + 200, b + 360)});
    OneFreedom lever;
    lever.p_WO = {d, 0};
    MapRange range;
    range.start = 1;
    range.samples = 7;
    const ContactMap map = map_contacts({&disc, {}, &roller, lever}, range);
    const double limit = std::acos((e * e + d * d - reach * reach) / (2 * e * d));
    EXPECT_EQ(std::count_if(map.branches.begin(), map.branches.end(),
                            [&](const MapBranch& branch) {
                              return branch.opposed && branch.begin.type == MapEndType::kFold &&
                                     branch.end.type == MapEndType::kFold &&
                                     std::abs(branch.begin.u - (2 * kPi - limit)) < 1e-8 &&
                                     std::abs(branch.end.u - (2 * kPi + limit)) < 1e-8;
                            }),
              2);
  }
}

TEST(BoundaryMap, EndsWhereACurveEnds) {
  // Normals from 50° to 110° only: a flat face touches it while the cam has turned by -20° to 40°.
  const Boundary cam = Boundary::make({arc({3, -4}, 20, 50, 110)}, false, 0).value();
  const Boundary face = face_downwards();
  MapRange range;
  range.start = -1;
  range.samples = 361;
  const ContactMap map = map_contacts({&cam, {}, &face, sliding_up()}, range, {false, true});
  EXPECT_TRUE(map.complete);
  const auto own = std::find_if(map.branches.begin(), map.branches.end(),
                                [](const MapBranch& one) { return one.opposed; });
  ASSERT_NE(own, map.branches.end());
  EXPECT_EQ(own->begin.type, MapEndType::kEnd);
  EXPECT_EQ(own->end.type, MapEndType::kEnd);
  EXPECT_NEAR(own->begin.u, -20 * testing::kDegree, 1e-14);
  EXPECT_NEAR(own->end.u, 40 * testing::kDegree, 1e-14);
  for (const MapPoint& point : own->points) {
    EXPECT_NEAR(point.q, 20 + 3 * std::sin(point.u) - 4 * std::cos(point.u), 1e-13);
  }
}

// Two arcs of radius 10, whose centres are 15 apart, joined by a hollow of radius 5, whose centre is 15 from
// both.
TEST(BoundaryMap, IsConformingWhereTheSumOfCurvaturesJumpsOverZero) {
  const double half = 60;  // the arcs meet at 60° from the line of centres: cos = 7.5/15
  const Vector2d left(-7.5, 0), right(7.5, 0), hollow(0, 15 * std::sin(half * testing::kDegree));
  const Boundary body = Boundary::make({arc(right, 10, 0, 180 - half),
                                        arc(hollow, 5, 60, 120, Side::kOutside), arc(left, 10, half, 180)},
                                       false, 1e-9)
                            .value();
  OneFreedom across;
  across.turns = false;
  MapRange range;
  range.start = -12;
  range.end = 12;
  range.samples = 25;
  for (const double r : {4.0, 8.0}) {
    const Boundary roller = boundary_of(make_circle(Vector2d::Zero(), r).value(), 1);
    const ContactMap map = map_contacts({&body, across, &roller, sliding_up()}, range);
    EXPECT_TRUE(map.complete);
    std::vector<MapEvent> conforming;
    std::copy_if(
        map.events.begin(), map.events.end(), std::back_inserter(conforming),
        [](const MapEvent& event) { return event.at.opposed && event.at.type == CriticalType::kConforming; });
    // A roller of radius 4 passes through the hollow; one of 8 rides over both joints at the offset of 10 +
    // 8.
    ASSERT_EQ(conforming.size(), r < 5 ? 0U : 2U);
    if (r < 5) {
      continue;
    }
    const Vector2d centre = right + 18 * unit_vector((180 - half) * testing::kDegree);
    EXPECT_NEAR(conforming[0].at.u, -std::abs(centre.x()), 1e-12);
    EXPECT_NEAR(conforming[1].at.u, std::abs(centre.x()), 1e-12);
    EXPECT_NEAR(conforming[0].at.q, centre.y(), 1e-12);
    EXPECT_EQ(conforming[0].branches.size(), 2U);
    // Where both flanks are touched at once the roller is above the middle.
    const bool meets = std::any_of(map.branches.begin(), map.branches.end(), [](const MapBranch& branch) {
      return std::any_of(branch.free_changes.begin(), branch.free_changes.end(),
                         [](const MapPoint& at) { return std::abs(at.u) < 1e-9; });
    });
    EXPECT_TRUE(meets);
  }
}

TEST(BoundaryMap, GoesOnOverCornersAndFaces) {
  // A square with half sides 10 under a flat face: the position is the support of its corners.
  const Boundary square = closed({face_span({10, -10}, {10, 10}), face_span({10, 10}, {-10, 10}),
                                  face_span({-10, 10}, {-10, -10}), face_span({-10, -10}, {10, -10})});
  const Boundary face = face_downwards();
  MapRange range;
  range.start = 0.1;
  range.samples = 91;
  const ContactMap map = map_contacts({&square, {}, &face, sliding_up()}, range, {false, true});
  EXPECT_TRUE(map.complete);
  std::size_t points = 0;
  for (const MapBranch& branch : map.branches) {
    for (const MapPoint& point : branch.points) {
      if (branch.opposed && point.free) {
        EXPECT_NEAR(point.q, 10 * (std::abs(std::cos(point.u)) + std::abs(std::sin(point.u))), 1e-12);
        ++points;
      }
    }
  }
  EXPECT_GE(points, 91U);
}

TEST(BoundaryMap, DoesNotDependOnTheUnitOfLength) {
  for (unsigned number : {6U, 7U, 13U, 20U, 24U}) {
    const RandomPair random = testing::random_pair(number);
    const MapRange range = range_of(random.pair, random.u);
    const Boundaries boundaries(random.pair);
    const ContactMap map = map_contacts(boundaries.both, range);
    for (const double scale : {1e-6, 1e6}) {
      SCOPED_TRACE(random.text + ", scale " + std::to_string(scale));
      const Boundaries copies(testing::scaled(random.pair, scale), kReach * scale);
      const ContactMap copy = map_contacts(copies.both, range);
      EXPECT_EQ(map.complete, copy.complete);
      EXPECT_EQ(map.branches.size(), copy.branches.size());
      ASSERT_EQ(map.events.size(), copy.events.size());
      for (std::size_t i = 0; i < map.events.size(); ++i) {
        EXPECT_NEAR(copy.events[i].at.u, map.events[i].at.u, 1e-12);
      }
    }
  }
}

TEST(BoundaryMap, OfBodiesOnOnePivotIsRefused) {
  const Boundary one = four_arcs();
  const Boundary two = boundary_of(make_circle({40, 0}, 5).value(), 1);
  const ContactMap map = map_contacts({&one, {}, &two, {}}, {});
  EXPECT_EQ(map.status, MapStatus::kOnlyRelative);
  EXPECT_EQ(
      describe(map.status),
      "both bodies turn about one pivot, or slide in one direction: only their relative position counts");
}

}  // namespace
}  // namespace higherpair
