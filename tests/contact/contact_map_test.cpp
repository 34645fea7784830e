#include "higherpair/contact/contact_map.hpp"

#include "contact/freedoms.hpp"
#include "higherpair/contact/tracker.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::pivot;
using testing::slide;

using ::testing::SizeIs;

// Discs on two cranks of lengths e and r, whose pivots are L apart.
struct Discs {
  double e = 0.05, r = 0.04, L = 0.08, rho1 = 0.02, rho2 = 0.015;

  [[nodiscard]] ContactPair pair() const {
    return {make_circle({e, 0}, rho1).value(), pivot(0, 0), make_circle({-r, 0}, rho2).value(), pivot(L, 0)};
  }
  // Driver angle in [0, π] at which the centre of the driver's disc is `d` from the follower's pivot.
  [[nodiscard]] double angle_at(double d) const { return std::acos((e * e + L * L - d * d) / (2 * e * L)); }
};

MapRange range(double start, std::int64_t samples = 121) {
  MapRange result;
  result.start = start;
  result.samples = samples;
  return result;
}

std::vector<double> positions(const ContactMap& map, bool opposed) {
  std::vector<double> found;
  for (const MapEvent& event : map.events) {
    if (event.at.opposed == opposed) {
      found.push_back(event.at.u);
    }
  }
  return found;
}

void expect_near(const std::vector<double>& found, std::vector<double> expected, double tolerance) {
  std::sort(expected.begin(), expected.end());
  ASSERT_THAT(found, SizeIs(expected.size()));
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], tolerance) << i;
  }
}

TEST(ContactMap, OfTwoDiscsFoldsWhereTheFourBarIsStretchedOrFolded) {
  const Discs discs;
  const ContactMap map = map_contacts(discs.pair(), range(0));
  ASSERT_EQ(map.status, MapStatus::kOk);
  EXPECT_TRUE(map.complete);
  // Opposed normals: the coupler is ρ1 + ρ2 long. r + ρ1 + ρ2 = 75 mm is reached, r - ρ1 - ρ2 = 5 mm never.
  const double opposed = discs.angle_at(0.075);
  expect_near(positions(map, true), {opposed, 2 * kPi - opposed}, 1e-14);
  // Normals not opposed: r ± (ρ1 - ρ2).
  const double low = discs.angle_at(0.035), high = discs.angle_at(0.045);
  expect_near(positions(map, false), {low, high, 2 * kPi - high, 2 * kPi - low}, 1e-14);
}

// A branch over the whole turn begins and ends at the same contact.
TEST(ContactMap, HasTheContactsAtItsStartOnce) {
  Discs discs;
  discs.e = 0.01;
  discs.r = 0.06;  // the crank turns fully: 60 + 35 mm reach 80 + 10 mm
  const ContactMap map = map_contacts(discs.pair(), range(0.2));
  ASSERT_EQ(map.branches.size(), 2U);
  for (const double u : {0.2, 0.2 + 2 * kPi, 1.0}) {
    EXPECT_EQ(contacts_at(map, u).size(), map.branches.size()) << u;
  }
}

TEST(ContactMap, JoinsTheTwoBranchesThatMergeAtAFold) {
  const ContactMap map = map_contacts(Discs().pair(), range(0));
  ASSERT_THAT(map.branches, SizeIs(6));
  for (std::size_t i = 0; i < map.branches.size(); ++i) {
    const MapBranch& branch = map.branches[i];
    for (const MapEnd& end : {branch.begin, branch.end}) {
      ASSERT_EQ(end.type, MapEndType::kFold);
      ASSERT_GE(end.other, 0);
      EXPECT_NE(end.other, static_cast<int>(i));
    }
    EXPECT_EQ(map.branches[branch.begin.other].begin.other, static_cast<int>(i));
    EXPECT_EQ(branch.points.front().u, branch.begin.u);
    EXPECT_EQ(branch.points.back().q, branch.end.q);
  }
}

TEST(ContactMap, CarriesABranchOverTheStartOfTheTurn) {
  const Discs discs;
  const double limit = discs.angle_at(0.075);
  const ContactMap map = map_contacts(discs.pair(), range(0));
  const auto holds_start =
      std::count_if(map.branches.begin(), map.branches.end(), [&](const MapBranch& branch) {
        return branch.opposed && std::abs(branch.begin.u + limit) < 1e-12 &&
               std::abs(branch.end.u - limit) < 1e-12;
      });
  EXPECT_EQ(holds_start, 2);
}

TEST(ContactMap, LiesOnTheFourBarBetweenItsFolds) {
  const Discs discs;
  const ContactMap map = map_contacts(discs.pair(), range(0.2));
  ASSERT_FALSE(map.branches.empty());
  for (const MapBranch& branch : map.branches) {
    const double coupler = branch.opposed ? discs.rho1 + discs.rho2 : discs.rho1 - discs.rho2;
    for (const MapPoint& point : branch.points) {
      const Vector2d c1 = discs.e * unit_vector(point.u);
      const Vector2d c2 = Vector2d(discs.L, 0) - discs.r * unit_vector(point.q);
      EXPECT_NEAR((c2 - c1).norm(), coupler, 1e-15);
      EXPECT_NEAR((c1 + discs.rho1 * point.n_W - point.p_W).norm(), 0, 1e-15);
      EXPECT_EQ(point.free, branch.opposed);
    }
  }
}

TEST(ContactMap, SaysHowFarTheOtherBranchIs) {
  const Discs discs;
  const ContactMap map = map_contacts(discs.pair(), range(0));
  for (const double u : {0.0, 0.4, -1.1}) {
    // The two positions of the follower are mirror images about the line from O2 to the disc's centre.
    const double d = std::sqrt(discs.e * discs.e + discs.L * discs.L - 2 * discs.e * discs.L * std::cos(u));
    const double coupler = discs.rho1 + discs.rho2;
    const double half = std::acos((discs.r * discs.r + d * d - coupler * coupler) / (2 * discs.r * d));
    const auto contact = contacts_at(map, u);
    const auto own = std::find_if(contact.begin(), contact.end(),
                                  [&](const MapContact& c) { return map.branches[c.branch].opposed; });
    ASSERT_NE(own, contact.end());
    const auto near = neighbour_at(map, own->branch, u);
    ASSERT_TRUE(near);
    EXPECT_NEAR(near->distance, 2 * half, 1e-13) << u;
    EXPECT_EQ(nearest_neighbour(map, own->branch)->distance, 0);
  }
}

TEST(ContactMap, OfASlidingFollowerFoldsWhereTheCrankIsAtTheReachOfTheCoupler) {
  // Disc of radius ρ1 on a crank e, roller ρ2 that slides along the line y = h.
  const double e = 0.03, rho1 = 0.012, rho2 = 0.007, h = 0.02;
  const ContactPair pair{make_circle({e, 0}, rho1).value(), pivot(0, 0), make_circle({0, 0}, rho2).value(),
                         slide(0, h, 0)};
  const ContactMap map = map_contacts(pair, range(-1));
  std::vector<double> expected;
  for (const double coupler : {rho1 + rho2, -rho1 - rho2}) {
    const double sine = (h + coupler) / e;
    if (std::abs(sine) < 1) {
      expected.push_back(std::asin(sine));
      expected.push_back(kPi - std::asin(sine));
    }
  }
  expect_near(positions(map, true), expected, 1e-14);
  EXPECT_TRUE(map.complete);
}

TEST(ContactMap, OfASlidingDriverCoversItsRange) {
  // A disc slides along y = 0, and the follower's disc turns about the origin; their centres are ρ1 + ρ2
  // apart.
  const double r = 0.04, rho1 = 0.01, rho2 = 0.012;
  const ContactPair pair{make_circle({0, 0}, rho1).value(), slide(0, 0, 0), make_circle({r, 0}, rho2).value(),
                         pivot(0, 0)};
  MapRange wanted = range(-0.1);
  wanted.end = 0.1;
  const ContactMap map = map_contacts(pair, wanted);
  const double far = r + rho1 + rho2, near = r - rho1 - rho2;
  expect_near(positions(map, true), {-far, -near, near, far}, 1e-16);
  wanted.end = 0.03;  // between near and far
  const ContactMap cut = map_contacts(pair, wanted);
  EXPECT_EQ(std::count_if(cut.branches.begin(), cut.branches.end(),
                          [](const MapBranch& branch) { return branch.end.type == MapEndType::kRange; }),
            2);  // those that are not opposed exist between 38 and 42 mm
}

TEST(ContactMap, OfAnEllipseUnderAFlatFaceIsItsSupport) {
  const double a = 0.03, b = 0.02;
  const ContactPair pair{make_ellipse({0.004, 0}, {a, b}, 0).value(), pivot(0, 0),
                         make_line({0, 0}, {0, -1}).value(), slide(0, 0, kPi / 2)};
  const ContactMap map = map_contacts(pair, range(0.3));
  ASSERT_THAT(map.branches, SizeIs(2));
  EXPECT_THAT(map.events, SizeIs(0));
  for (const MapBranch& branch : map.branches) {
    EXPECT_EQ(branch.begin.type, MapEndType::kClosed);
    EXPECT_EQ(branch.turns, 1);
    EXPECT_THAT(branch.points, SizeIs(121));
    for (const MapPoint& point : branch.points) {
      const double support = std::hypot(a * std::sin(point.u), b * std::cos(point.u));
      EXPECT_NEAR(point.q, 0.004 * std::sin(point.u) + (branch.opposed ? support : -support), 1e-16);
    }
    // The follower's highest and lowest positions are where its rate changes sign.
    EXPECT_GE(branch.extremes.size(), 2U);
  }
}

TEST(ContactMap, FindsAnIslandBetweenTwoSamples) {
  Discs discs{0.05, 0.045, 0.13, 0.02, 0.015};  // at u = 0 the discs' centres can be 80 mm apart
  discs.rho2 += 4e-10;
  const double u = 2 * std::asin(std::sqrt(((0.08 + 4e-10) * (0.08 + 4e-10) - 0.0064) / (4 * 0.05 * 0.13)));
  ASSERT_LT(u, 2e-4);
  const ContactMap map = map_contacts(discs.pair(), range(1, 37));
  ASSERT_EQ(positions(map, true).size(), 2U);
  // The rounding of the lengths, about 1e-17, divided by the slope e u.
  EXPECT_NEAR(nearest_turn(positions(map, true)[0], 0), -u, 1e-11);
  EXPECT_NEAR(nearest_turn(positions(map, true)[1], 0), u, 1e-11);
  const auto islands = std::count_if(map.branches.begin(), map.branches.end(),
                                     [](const MapBranch& branch) { return branch.opposed; });
  EXPECT_EQ(islands, 2);
  for (const MapBranch& branch : map.branches) {
    EXPECT_GE(branch.points.size(), 8U);
  }
}

TEST(ContactMap, LetsContactsRunOffToInfinityWhereAnAsymptoteIsParallelToTheSlide) {
  // A knife edge that slides along y on one branch of a hyperbola that turns; asymptotes at ±atan(b/a).
  const double a = 0.02, b = 0.01;
  const ContactPair pair{make_hyperbola({0.003, 0}, {a, b}, 0).value(), pivot(0, 0),
                         make_point({0, 0}).value(), slide(0.005, 0, kPi / 2)};
  const ContactMap map = map_contacts(pair, range(0.1));
  EXPECT_TRUE(map.complete);
  const double asymptote = std::atan(b / a);
  int ends = 0;
  for (const MapBranch& branch : map.branches) {
    for (const MapEnd& end : {branch.begin, branch.end}) {
      if (end.type != MapEndType::kInfinity) {
        continue;
      }
      ++ends;
      const double off = std::min(std::abs(std::sin(kPi / 2 - asymptote - end.u)),
                                  std::abs(std::sin(kPi / 2 + asymptote - end.u)));
      EXPECT_NEAR(off, 0, 1e-14);
    }
  }
  EXPECT_GT(ends, 0);
}

TEST(ContactMap, EndsWhereTheCurvaturesOfAnOvalAndItsRingAreEqual) {
  const double a = 0.03, b = 0.012, radius = 0.034;
  const ContactPair pair{make_ellipse({0.003, 0.001}, {a, b}, 0).value(), pivot(0, 0),
                         make_circle({0.01, 0.08}, radius, Side::kOutside).value(), pivot(-0.01, -0.08)};
  const ContactMap map = map_contacts(pair, range(0));
  EXPECT_TRUE(map.complete);
  int cusps = 0;
  for (const MapEvent& event : map.events) {
    if (event.at.type != CriticalType::kConforming) {
      continue;
    }
    ++cusps;
    // The ring's centre lies on the oval's evolute, at the parameter t of the contact point.
    const Pose<double> X_W1 = pose_at(pair.motion1, event.at.u);
    const Vector2d p = X_W1.inverse_times(event.at.p_W) - Vector2d(0.003, 0.001);
    const double c = p.x() / a, s = p.y() / b;
    const double k = a * a - b * b;
    const Vector2d evolute = Vector2d(k / a * c * c * c, -k / b * s * s * s) + Vector2d(0.003, 0.001);
    const Vector2d ring = pose_at(pair.motion2, event.at.q) * Vector2d(0.01, 0.08);
    EXPECT_NEAR((X_W1 * evolute - ring).norm(), 0, 1e-14);
    EXPECT_NEAR((ring - event.at.p_W).norm(), radius, 1e-14);
    EXPECT_THAT(event.branches, SizeIs(2));
  }
  EXPECT_EQ(cusps, 8);
}

TEST(ContactMap, MarksSecondContactsWhereTwoBranchesHoldAtOnce) {
  const ContactPair pair{make_ellipse({0.003, 0.001}, {0.03, 0.012}, 0).value(), pivot(0, 0),
                         make_circle({0.01, 0.08}, 0.034, Side::kOutside).value(), pivot(-0.01, -0.08)};
  const ContactMap map = map_contacts(pair, range(0));
  std::vector<double> marks;
  for (std::size_t i = 0; i < map.branches.size(); ++i) {
    for (const MapPoint& mark : map.branches[i].free_changes) {
      const auto near = neighbour_at(map, static_cast<int>(i), mark.u);
      ASSERT_TRUE(near);
      EXPECT_LE(near->distance, 1e-13);
      marks.push_back(mark.u);
    }
  }
  EXPECT_THAT(marks, SizeIs(8));  // four places, each seen from both branches
}

TEST(ContactMap, GoesStraightOnWhereBranchesCross) {
  // A parallelogram: equal cranks, the coupler as long as the frame. q = u on one branch; the other crosses
  // it where all pivots are in line.
  const double e = 0.03;
  const ContactPair pair{make_circle({e, 0}, 0.05).value(), pivot(0, 0), make_circle({e, 0}, 0.04).value(),
                         pivot(0.09, 0)};
  const ContactMap map = map_contacts(pair, range(0.3));
  EXPECT_TRUE(map.complete);
  const auto parallel = branch_of(map, 0.3, 0.3, Vector2d(1, 0));
  ASSERT_TRUE(parallel);
  const MapBranch& branch = map.branches[*parallel];
  EXPECT_EQ(branch.turns, 1);
  for (const MapPoint& point : branch.points) {
    EXPECT_NEAR(point.q, point.u, 1e-12);
  }
  int crossings = 0;
  for (const MapEvent& event : map.events) {
    crossings += event.at.type == CriticalType::kCrossing && event.at.opposed ? 1 : 0;
  }
  EXPECT_GE(crossings, 2);
}

TEST(ContactMap, SaysWhyThereIsNone) {
  const Curve disc = make_circle({0.01, 0}, 0.02).value();
  const Curve face = make_line({0, 0}, {1, 0}).value();
  const Curve about_pivot = make_circle({0, 0}, 0.01).value();
  EXPECT_EQ(map_contacts({face, pivot(0, 0), face, pivot(1, 0)}, range(0)).status, MapStatus::kNoPair);
  EXPECT_EQ(map_contacts({disc, pivot(0, 0), about_pivot, pivot(0.5, 0)}, range(0)).status,
            MapStatus::kTouchesNowhere);
  // A disc about its own pivot holds the follower at a limit position permanently: 20 mm + 10 mm + 30 mm.
  const Curve still = make_circle({0, 0}, 0.02).value();
  const Curve roller = make_circle({0.03, 0}, 0.01).value();
  EXPECT_EQ(map_contacts({still, pivot(0, 0), roller, pivot(0.06, 0)}, range(0)).status,
            MapStatus::kLimitEverywhere);
  for (const MapStatus status :
       {MapStatus::kNoPair, MapStatus::kTouchesNowhere, MapStatus::kTouchesEverywhere,
        MapStatus::kTangentAtInfinity, MapStatus::kLimitEverywhere}) {
    EXPECT_GT(describe(status).size(), 20U);
  }
}

}  // namespace
}  // namespace higherpair
