#include "higherpair/contact/conic_contacts.hpp"

#include "contact/contact_scan.hpp"
#include "contact/oracle_case.hpp"
#include "contact/random_pair.hpp"
#include "geometry/geometry_testing.hpp"
#include "higherpair/contact/separation.hpp"
#include "higherpair/geometry/support.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::kDegree;
using testing::OracleCase;

TEST(ContactsOracle, FindsEveryListedContact) {
  for (const OracleCase& reference : testing::oracle_cases()) {
    SCOPED_TRACE(reference.id);
    const nlohmann::json& start = reference.data.at("start");
    const double u = reference.data.at("th1_start_deg").get<double>() * kDegree;
    const CurveContacts found = find_curve_contacts(reference.pair, u);
    ASSERT_EQ(found.status, ContactsStatus::kComplete);
    for (const nlohmann::json& listed : start.at("all_contacts_at_start")) {
      const double q = listed.at("q2");
      const Vector2d p = testing::vector_of(listed.at("P"));
      const auto same =
          std::find_if(found.contacts.begin(), found.contacts.end(), [&](const CurveContact& c) {
            return std::abs(c.q - q) <= 1e-9 * std::max(1.0, std::abs(q)) &&
                   (c.p_W - p).norm() <= 1e-8 * (1 + p.norm());
          });
      ASSERT_NE(same, found.contacts.end()) << q;
      EXPECT_TRUE(same->opposed);
      EXPECT_EQ(same->free, listed.at("separated_elsewhere").get<bool>());
    }
  }
}

// The properties of a contact, by the boundary points with given normals.
void expect_contact(const ContactPair& pair, double u, const CurveContact& c) {
  const Pose<double> X1 = pose_at(pair.motion1, u);
  const Pose<double> X2 = pose_at(pair.motion2, c.q);
  const auto check = [&](const Curve& curve, const Pose<double>& X, const Vector2d& n) {
    const PlacedCurve<double> placed = place(curve, X);
    if (curve.kind == CurveKind::kLine) {
      EXPECT_LE((n + placed.axis_W).norm(), 1e-9);
      EXPECT_LE(std::abs((c.p_W - placed.vertex_W).dot(n)), 1e-9 * (1 + c.p_W.norm()));
      return;
    }
    EXPECT_TRUE(has_point(placed, n));
    const SupportPoint<double> s = support_point(placed, n);
    EXPECT_LE((s.p_W - c.p_W).norm(), 1e-10 * (1 + c.p_W.norm() + std::abs(s.rho)));
  };
  const double sign = c.opposed ? -1 : 1;
  check(pair.curve1, X1, c.n_W);
  check(pair.curve2, X2, sign * c.n_W);
}

bool listed(const CurveContacts& found, const testing::ScannedContact& scanned, bool turns) {
  return std::any_of(found.contacts.begin(), found.contacts.end(), [&](const CurveContact& c) {
    return std::abs(std::remainder(c.q - scanned.q, turns ? 2 * kPi : 1e300)) <= 1e-6 * (1 + std::abs(c.q)) &&
           (c.p_W - scanned.p_W).norm() <= 1e-5 * (1 + c.p_W.norm()) && c.opposed == scanned.opposed;
  });
}

bool scanned_as_well(const std::vector<testing::ScannedContact>& scan, const CurveContact& c, bool turns) {
  CurveContacts one;
  one.contacts = {c};
  return std::any_of(scan.begin(), scan.end(), [&](const auto& s) { return listed(one, s, turns); });
}

TEST(RandomContacts, AreThoseThatAScanOfBothCurvesFinds) {
  for (unsigned number = 0; number < 120; ++number) {
    const testing::RandomPair random = testing::random_pair(number);
    SCOPED_TRACE(random.text);
    const CurveContacts found = find_curve_contacts(random.pair, random.u);
    ASSERT_EQ(found.status, ContactsStatus::kComplete);
    const auto scan = testing::ContactScan(random.pair, random.u).run();
    const bool turns = random.pair.motion2.turns;
    for (const testing::ScannedContact& s : scan) {
      EXPECT_TRUE(listed(found, s, turns)) << "not listed: q = " << s.q << " p = " << s.p_W.transpose();
    }
    for (const CurveContact& c : found.contacts) {
      expect_contact(random.pair, random.u, c);
      const bool in_reach = c.p_W.norm() < 100;
      EXPECT_TRUE(!in_reach || scanned_as_well(scan, c, turns)) << "not scanned: q = " << c.q;
    }
  }
}

TEST(RandomContacts, AreFreeWhereTheSignedDistanceOfTheBodiesIsZero) {
  for (unsigned number = 0; number < 120; ++number) {
    const testing::RandomPair random = testing::random_pair(number);
    SCOPED_TRACE(random.text);
    const ContactPair& pair = random.pair;
    for (const CurveContact& c : find_curve_contacts(pair, random.u).contacts) {
      EXPECT_TRUE(c.opposed || !c.free);
      const bool outside1 = pair.curve1.side == Side::kOutside;
      const bool outside2 = pair.curve2.side == Side::kOutside;
      const bool face = pair.curve1.kind == CurveKind::kLine || pair.curve2.kind == CurveKind::kLine;
      if ((outside1 && outside2) || (face && (outside1 || outside2))) {
        EXPECT_FALSE(c.free);
        continue;
      }
      if (!c.opposed) {
        continue;
      }
      const Separation apart = separation(pair.curve1, pose_at(pair.motion1, random.u), pair.curve2,
                                          pose_at(pair.motion2, c.q), 1e-11);
      EXPECT_EQ(c.free, apart.gap >= -1e-8) << "q = " << c.q << " gap = " << apart.gap;
    }
  }
}

TEST(RandomContacts, FollowAChangeOfScale) {
  for (unsigned number = 0; number < 120; ++number) {
    const testing::RandomPair random = testing::random_pair(number);
    SCOPED_TRACE(random.text);
    const CurveContacts plain = find_curve_contacts(random.pair, random.u);
    for (const double scale : {1e-6, 1e6}) {
      const CurveContacts scaled = find_curve_contacts(testing::scaled(random.pair, scale), random.u);
      ASSERT_EQ(scaled.contacts.size(), plain.contacts.size());
      for (std::size_t i = 0; i < plain.contacts.size(); ++i) {
        const CurveContact& a = plain.contacts[i];
        const CurveContact& b = scaled.contacts[i];
        const double q = b.q / (random.pair.motion2.turns ? 1 : scale);
        EXPECT_LE(std::abs(q - a.q), 1e-10 * (1 + std::abs(a.q)));
        EXPECT_LE((b.p_W / scale - a.p_W).norm(), 1e-8 * (1 + a.p_W.norm()));
        EXPECT_EQ(a.opposed, b.opposed);
        EXPECT_EQ(a.free, b.free);
      }
    }
  }
}

// Contacts of two circles, one of which turns about the origin: the distance of their centres is r1 + r2
// (opposed normals) or |r1 - r2|. With the follower's centre on an arm e and the driver's at the distance L
// from the pivot, cos(angle between) = (L² + e² - distance²)/(2 L e).
TEST(TwoCircles, TouchAtTheAnglesOfTheirTriangles) {
  for (const double lever : {1.3, 17.0, 1e3, 1e6}) {
    SCOPED_TRACE(lever);
    const double r1 = 0.731;
    const double r2 = 0.447;
    ContactPair pair;
    pair.curve1 = make_circle({0, 0}, r1).value();
    pair.curve2 = make_circle({lever, 0}, r2).value();
    const double L = lever + 0.6;
    pair.motion2.p_WO = {L, 0};
    const CurveContacts found = find_curve_contacts(pair, 0.3);
    ASSERT_EQ(found.contacts.size(), 2U);
    // The driver lies in direction π from the pivot. 1 - cos without cancellation: ((r1+r2)² - (L-e)²)/(2 L
    // e).
    const double sum = r1 + r2;
    const double one_minus_cos = (sum - 0.6) * (sum + 0.6) / (2 * L * lever);
    const double angle = 2 * std::asin(std::sqrt(one_minus_cos / 2));
    // L - lever is 0.6 up to the rounding of L; q is within rounding of π.
    const double tolerance = 4 * kPi * 2.3e-16 + 1e-15 / (lever * angle);
    EXPECT_NEAR(found.contacts[0].q, -(kPi - angle), tolerance);
    EXPECT_NEAR(found.contacts[1].q, kPi - angle, tolerance);
    EXPECT_TRUE(found.contacts[0].free && found.contacts[1].free);
    EXPECT_EQ(found.contacts[0].branch, 1);
    EXPECT_EQ(found.contacts[1].branch, -1);
  }
}

TEST(Contacts, OfACircleInARingAreOpposedInsideAndNotOutside) {
  ContactPair pair;
  pair.curve1 = make_circle({0, 0}, 3.0, Side::kOutside).value();
  pair.curve2 = make_circle({0, 0}, 0.7).value();
  pair.motion2.turns = false;
  pair.motion2.p_WO = {0, 0.4};
  const CurveContacts found = find_curve_contacts(pair, 0);
  const double inner = std::sqrt(2.3 * 2.3 - 0.4 * 0.4);
  const double outer = std::sqrt(3.7 * 3.7 - 0.4 * 0.4);
  const std::vector<double> expected = {-outer, -inner, inner, outer};
  ASSERT_EQ(found.contacts.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(found.contacts[i].q, expected[i], 1e-15 * 8);
    EXPECT_EQ(found.contacts[i].opposed, i == 1 || i == 2);
    EXPECT_EQ(found.contacts[i].free, i == 1 || i == 2);
  }
}

TEST(Contacts, OfAFaceTurningOverACircleAreItsTangentsThroughThePivot) {
  ContactPair pair;
  pair.curve1 = make_circle({0, 0}, 1.7).value();
  pair.curve2 = make_line({0, 0}, {0, 1}).value();
  pair.motion2.p_WO = {5, 0};
  const CurveContacts found = find_curve_contacts(pair, 0);
  const double angle = std::asin(1.7 / 5);
  ASSERT_EQ(found.contacts.size(), 4U);
  const std::vector<double> expected = {-(kPi - angle), -angle, angle, kPi - angle};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(found.contacts[i].q, expected[i], 1e-15);
  }
  // The normals are opposed where the face's normal points to the disc.
  for (const CurveContact& c : found.contacts) {
    const Vector2d n_face(-std::sin(c.q), std::cos(c.q));
    const double centre_from_face = -Vector2d(5, 0).dot(n_face);
    EXPECT_EQ(c.opposed, centre_from_face > 0);
    EXPECT_EQ(c.free, c.opposed);
  }
}

TEST(Contacts, OfAFaceThroughItsPivotAreFourAlsoWhereTwoShareAPoint) {
  // The face lies along the tangent at (1, 0) or (3, -2), and its normal points to the disc or away from it:
  // positions half a turn apart share a contact point.
  ContactPair pair;
  pair.curve1 = make_circle({1, -2}, 2).value();
  pair.curve2 = make_line({0, 0}, {0, 1}).value();
  pair.motion2.p_WO = {3, 0};
  const CurveContacts found = find_curve_contacts(pair, 0);
  ASSERT_EQ(found.contacts.size(), 4U);
  const std::vector<double> expected = {-kPi / 2, 0, kPi / 2, kPi};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(found.contacts[i].q, expected[i], 1e-15);
    EXPECT_FALSE(found.contacts[i].at_limit);
  }
}

TEST(Contacts, OfAPointSlidingThroughAParabolaAreWhereItCrosses) {
  ContactPair pair;
  pair.curve1 = make_parabola({0, 0}, 0.25, 0).value();  // y² = x
  pair.curve2 = make_point({0, 0}).value();
  pair.motion2.turns = false;
  pair.motion2.p_WO = {2.25, 0};
  pair.motion2.direction_W = {0, 1};
  const CurveContacts found = find_curve_contacts(pair, 0);
  ASSERT_EQ(found.contacts.size(), 2U);
  EXPECT_NEAR(found.contacts[0].q, -1.5, 1e-15);
  EXPECT_NEAR(found.contacts[1].q, 1.5, 1e-15);
  EXPECT_TRUE(found.contacts[0].free && found.contacts[0].opposed);
}

TEST(Contacts, HalfATurnFromTheFrameAreFoundLikeAnyOther) {
  ContactPair pair;
  pair.curve1 = make_ellipse({0, 0}, {2, 1}, 0).value();
  pair.curve2 = make_point({3, 0}).value();
  pair.motion2.p_WO = {5, 0};
  // The point reaches the ellipse's vertex (2, 0) exactly at q = π.
  const CurveContacts found = find_curve_contacts(pair, 0);
  ASSERT_EQ(found.contacts.size(), 1U);
  EXPECT_EQ(found.contacts[0].q, kPi);
  EXPECT_TRUE(found.contacts[0].at_limit);
  EXPECT_NEAR(found.contacts[0].p_W.x(), 2, 1e-15);
}

TEST(Contacts, AtALimitAreOneEntryWhateverRoundingMakesOfTheDoubleRoot) {
  // Outstretched: arm, radii and eccentricity in line, along a direction that doubles cannot represent
  // exactly.
  for (int i = 0; i < 24; ++i) {
    const double direction = 0.1 + i * 0.2601;
    ContactPair pair;
    pair.curve1 = make_circle({0, 0}, 0.7).value();
    pair.curve2 = make_circle({1.9, 0}, 0.4).value();
    pair.motion2.p_WO = 3.0 * unit_vector(direction);
    const CurveContacts found = find_curve_contacts(pair, 0);
    ASSERT_EQ(found.contacts.size(), 1U) << direction;
    EXPECT_TRUE(found.contacts[0].at_limit);
    EXPECT_EQ(found.contacts[0].branch, 0);
    // A double root is accurate to the square root of the data's rounding.
    EXPECT_NEAR(std::remainder(found.contacts[0].q - direction - kPi, 2 * kPi), 0, 1e-7);
  }
}

TEST(Contacts, TwoAtOnePositionAreTwo) {
  // A disc is lowered into the middle of a parabola and touches both its arms.
  ContactPair pair;
  pair.curve1 = make_parabola({0, 0}, 0.25, kPi / 2, Side::kOutside).value();
  pair.curve2 = make_circle({0, 0}, 1.3).value();
  pair.motion2.turns = false;
  pair.motion2.direction_W = {0, 1};
  const CurveContacts found = find_curve_contacts(pair, 0);
  // Distance of (0, h) from y = x²: sqrt(h - 1/4) = r, at one point on each arm.
  const double h = 1.3 * 1.3 + 0.25;
  std::vector<CurveContact> free;
  for (const CurveContact& c : found.contacts) {
    if (c.free) {
      free.push_back(c);
    }
  }
  ASSERT_EQ(free.size(), 2U);
  for (const CurveContact& c : free) {
    EXPECT_NEAR(c.q, h, 1e-14);
    EXPECT_NEAR(std::abs(c.p_W.x()), std::sqrt(h - 0.5), 1e-14);
    EXPECT_FALSE(c.at_limit);
  }
  EXPECT_LT(free[0].p_W.x() * free[1].p_W.x(), 0);
}

TEST(Contacts, OfAConformingDiscInAParabolaAreMarked) {
  // The disc is as large as the circle of curvature at the vertex.
  ContactPair pair;
  pair.curve1 = make_parabola({0, 0}, 0.35, kPi / 2, Side::kOutside).value();
  pair.curve2 = make_circle({0, 0}, 0.7).value();
  pair.motion2.turns = false;
  pair.motion2.direction_W = {0, 1};
  const CurveContacts found = find_curve_contacts(pair, 0);
  const auto lower = std::find_if(found.contacts.begin(), found.contacts.end(),
                                  [](const CurveContact& c) { return std::abs(c.q - 0.7) < 1e-6; });
  ASSERT_NE(lower, found.contacts.end());
  EXPECT_TRUE(lower->conforming);
  EXPECT_TRUE(lower->opposed);
  EXPECT_FALSE(lower->coincident);
}

TEST(Contacts, OfADiscAsLargeAsItsRingCoincide) {
  ContactPair pair;
  pair.curve1 = make_circle({0, 0}, 0.7, Side::kOutside).value();
  pair.curve2 = make_circle({0, 0}, 0.7).value();
  pair.motion2.turns = false;
  const CurveContacts found = find_curve_contacts(pair, 0);
  ASSERT_EQ(found.contacts.size(), 3U);
  EXPECT_NEAR(found.contacts[1].q, 0, 1e-15);
  EXPECT_TRUE(found.contacts[1].coincident);
  EXPECT_TRUE(found.contacts[1].free);
  EXPECT_FALSE(found.contacts[0].coincident);
}

TEST(Contacts, OfEqualParabolasSlidingBesideEachOtherFollowFromTheirOwnEquation) {
  // y = x² and, upside down, y = -2 (x - a)² + q: a² k1 k2/(k1 + k2) = q with k = 1, 2.
  ContactPair pair;
  pair.curve1 = make_parabola({0, 0}, 0.25, kPi / 2).value();
  pair.curve2 = make_parabola({0.9, 0}, 0.125, -kPi / 2).value();
  pair.curve1.axis_B = {0, 1};
  pair.curve2.axis_B = {0, -1};
  pair.motion2.turns = false;
  pair.motion2.direction_W = {0, 1};
  const CurveContacts found = find_curve_contacts(pair, 0);
  ASSERT_EQ(found.status, ContactsStatus::kComplete);
  ASSERT_EQ(found.contacts.size(), 1U);
  EXPECT_NEAR(found.contacts[0].q, 0.9 * 0.9 * 2 / 3, 1e-15);
  EXPECT_NEAR(found.contacts[0].p_W.x(), 0.6, 1e-15);
  EXPECT_TRUE(found.contacts[0].opposed);
}

TEST(Contacts, OfTheWrongBranchOfAHyperbolaAreLeftOut) {
  // A disc slides across both branches of x² - y² = 1; only the right one is part of the curve.
  ContactPair pair;
  pair.curve1 = make_hyperbola({0, 0}, {1, 1}, 0).value();
  pair.curve2 = make_circle({0, 0}, 0.25).value();
  pair.motion2.turns = false;
  const CurveContacts found = find_curve_contacts(pair, 0);
  ASSERT_EQ(found.contacts.size(), 2U);
  EXPECT_NEAR(found.contacts[0].q, 0.75, 1e-15);
  EXPECT_TRUE(found.contacts[0].free);
  EXPECT_NEAR(found.contacts[1].q, 1.25, 1e-15);
  EXPECT_FALSE(found.contacts[1].opposed);
}

TEST(Contacts, ThatDoNotDependOnTheFollowerAreSaidToBeEverywhereOrNowhere) {
  ContactPair pair;
  pair.curve1 = make_ellipse({0, 0}, {2, 1}, 0).value();
  pair.curve2 = make_circle({0.3, 0.1}, 1.0).value();
  pair.motion2.p_BO = {0.3, 0.1};
  pair.motion2.p_WO = {3.0, 0};
  EXPECT_EQ(find_curve_contacts(pair, 0).status, ContactsStatus::kTouchesEverywhere);
  pair.motion2.p_WO = {3.1, 0};
  EXPECT_EQ(find_curve_contacts(pair, 0).status, ContactsStatus::kTouchesNowhere);
  pair.curve2 = make_line({0, 0}, {0, 1}).value();
  pair.motion2.turns = false;
  EXPECT_EQ(find_curve_contacts(pair, 0).status, ContactsStatus::kTouchesNowhere);
  pair.motion2.p_BO = {0, 0};
  pair.motion2.p_WO = {0, -1};
  EXPECT_EQ(find_curve_contacts(pair, 0).status, ContactsStatus::kTouchesEverywhere);
}

TEST(Contacts, OfTwoLinesOrTwoPointsAreRefused) {
  ContactPair pair;
  pair.curve1 = make_line({0, 0}, {0, 1}).value();
  pair.curve2 = make_line({1, 0}, {0, 1}).value();
  EXPECT_EQ(find_curve_contacts(pair, 0).status, ContactsStatus::kNoPair);
  pair.curve1 = make_point({0, 0}).value();
  pair.curve2 = make_point({1, 0}).value();
  EXPECT_EQ(find_curve_contacts(pair, 0).status, ContactsStatus::kNoPair);
}

TEST(Contacts, OfHyperbolasThatSlideAlongACommonAsymptoteAreNotListed) {
  ContactPair pair;
  pair.curve1 = make_hyperbola({0, 0}, {1, 1}, 0).value();
  pair.curve2 = make_hyperbola({0, 0}, {2, 2}, 0).value();
  pair.curve1.axis_B = pair.curve2.axis_B = {1, 0};
  pair.motion2.turns = false;
  pair.motion2.direction_W = {1, 1};
  EXPECT_EQ(find_curve_contacts(pair, 0).status, ContactsStatus::kTangentAtInfinity);
}

}  // namespace
}  // namespace higherpair
