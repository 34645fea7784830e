#include "contact/subdivision/support_contacts.hpp"

#include "contact/support_curves.hpp"
#include "higherpair/geometry/curve.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::InvoluteBySupport;
using testing::LobedCurve;
using testing::Racetrack;

// A follower that slides along x; its frame is not turned.
OneFreedom slider(double offset) {
  OneFreedom motion;
  motion.turns = false;
  motion.p_WO = {0, offset};
  return motion;
}

OneFreedom upwards(double at) {
  OneFreedom motion = slider(0);
  motion.direction_W = {0, 1};
  motion.p_WO = {at, 0};
  return motion;
}

OneFreedom pivot_at(const Vector2d& p_W) {
  OneFreedom motion;
  motion.p_WO = p_W;
  return motion;
}

Curve circle(const Vector2d& center, double radius, Side side = Side::kInside) {
  return make_circle(center, radius, side).value();
}

std::vector<double> positions(const CurveContacts& found, bool opposed) {
  std::vector<double> q;
  for (const CurveContact& c : found.contacts) {
    if (c.opposed == opposed) q.push_back(c.q);
  }
  return q;
}

void expect_positions(std::vector<double> expected, const std::vector<double>& found, double tolerance) {
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], tolerance);
}

// The common normal of two involutes is a cross tangent of the base circles, at the angle φ with
// -L sin φ = r1 + r2, whatever u. Along it h1 + h2 = L cos φ, h1 = r1 (φ - u), h2 = r2 (φ + π - q).
TEST(ContactsOfInvolutes, AreOneWhichRunsAlongTheLineOfAction) {
  const double r1 = 0.31, r2 = 0.47, L = 1.1;
  const InvoluteBySupport driver(r1, {0.05, 3.0});
  const InvoluteBySupport follower(r2, {0.05, 1.9});
  const double phi = -std::asin((r1 + r2) / L);
  for (const double u : {-1.6, -1.4, -1.2}) {
    const CurveContacts found =
        list_support_contacts({make_curve(driver), {}, make_curve(follower), pivot_at({L, 0})}, u);
    EXPECT_EQ(found.status, ContactsStatus::kComplete);
    ASSERT_EQ(positions(found, true).size(), 1U) << "u = " << u;
    const auto at = std::find_if(found.contacts.begin(), found.contacts.end(),
                                 [](const CurveContact& c) { return c.opposed; });
    const double h1 = r1 * (phi - u);
    EXPECT_NEAR(at->q, phi + kPi - (L * std::cos(phi) - h1) / r2, 1e-14);
    EXPECT_LE((at->n_W - unit_vector(phi)).norm(), 1e-14);
    EXPECT_LE((at->p_W - (h1 * unit_vector(phi) + r1 * perp(unit_vector(phi)))).norm(), 1e-14);
  }
}

// Positions of the centre of a roller of radius r on the x axis through the cam's centre: it is at the
// distance r from the curve and at y = 0,
//     sin φ (a + r - 8 b cos³φ) = 0,   x = (a + r + b cos 3φ) cos φ + 3 b sin 3φ sin φ.
// r < 0: the roller is inside (normals not opposed).
std::vector<double> centers_on_axis(double a, double b, double r) {
  std::vector<double> x = {a + r + b, -(a + r - b)};
  const double cosine = std::cbrt((a + r) / (8 * b));
  if (std::abs(cosine) < 1) {
    for (int both = 0; both < 2; ++both) {
      const double cos3 = (4 * cosine * cosine - 3) * cosine;
      const double sin3_sin = (4 * cosine * cosine - 1) * (1 - cosine * cosine);
      x.push_back((a + r + b * cos3) * cosine + 3 * b * sin3_sin);
    }
  }
  return x;
}

TEST(ContactsOfALobedCam, AreWhereTheClosedFormHasARollerOnItsAxisOfSymmetry) {
  const double a = 1.37, r = 0.23;
  for (const double b : {0.05, 0.15, 0.17, -0.16}) {
    const LobedCurve cam(a, b);
    const CurveContacts found = list_support_contacts({make_curve(cam), {}, circle({0, 0}, r), slider(0)}, 0);
    EXPECT_EQ(found.status, ContactsStatus::kComplete);
    expect_positions(centers_on_axis(a, b, r), positions(found, true), 1e-13);
    expect_positions(centers_on_axis(a, b, -r), positions(found, false), 1e-13);
  }
}

// Turned inside out the cam is a ring of three bays with the roller in it; opposed and other contacts are
// exchanged.
TEST(ContactsOfALobedCam, AreThoseOfTheSameRollerInARing) {
  const double a = 1.37, b = 0.17, r = 0.23;
  const LobedCurve ring(a, -b, true);
  const CurveContacts found = list_support_contacts({make_curve(ring), {}, circle({0, 0}, r), slider(0)}, 0);
  EXPECT_EQ(found.status, ContactsStatus::kComplete);
  expect_positions(centers_on_axis(a, -b, -r), positions(found, true), 1e-13);
  expect_positions(centers_on_axis(a, -b, r), positions(found, false), 1e-13);
}

// A roller on an arm: counts the crossings by walking in small steps along the curve at the distance ±r; |x -
// pivot|² - arm² changes sign where the roller's centre is on it.
int crossings_on_a_walk(double a, double b, double u, double r, double arm, const Vector2d& pivot) {
  const auto excess = [&](int i) {
    const double phi = 2 * kPi * (i + 0.4711) / 60000;
    const Vector2d n = unit_vector(phi + u);
    const Vector2d x = (a + r + b * std::cos(3 * phi)) * n - 3 * b * std::sin(3 * phi) * perp(n);
    return (x - pivot).squaredNorm() - arm * arm;
  };
  int changes = 0;
  for (int i = 0; i < 60000; ++i) changes += (excess(i) > 0) != (excess(i + 1) > 0) ? 1 : 0;
  return changes;
}

TEST(ContactsOfALobedCam, AreAsManyForAnOscillatingRollerAsAWalkAlongTheCurveHas) {
  const double a = 1.37, r = 0.23, arm = 2.1;
  const Vector2d pivot(2.3, 0.4);
  for (const double b : {0.07, 0.15, -0.17}) {
    const LobedCurve cam(a, b);
    for (int i = 0; i < 12; ++i) {
      const double u = 0.37 + 0.51 * i;
      const CurveContacts found =
          list_support_contacts({make_curve(cam), {}, circle({arm, 0}, r), pivot_at(pivot)}, u);
      EXPECT_EQ(found.status, ContactsStatus::kComplete);
      EXPECT_EQ(static_cast<int>(positions(found, true).size()), crossings_on_a_walk(a, b, u, r, arm, pivot));
      EXPECT_EQ(static_cast<int>(positions(found, false).size()),
                crossings_on_a_walk(a, b, u, -r, arm, pivot));
      for (const CurveContact& c : found.contacts) {
        const Vector2d center = pivot + arm * unit_vector(c.q);
        EXPECT_NEAR((c.p_W - center).norm(), r, 1e-13);
        EXPECT_LE((c.p_W + (c.opposed ? r : -r) * c.n_W - center).norm(), 1e-13);
      }
    }
  }
}

// A contact at (u, q) with one body as the driver is a contact at (q, u) with the other.
TEST(ContactsOfALobedCam, AreTheSameWhenTheBodiesChangeRoles) {
  const LobedCurve cam(1.37, 0.17);
  const Curve ellipse = make_ellipse({0.2, -0.1}, {1.4, 0.5}, 0.3).value();
  OneFreedom motion2 = pivot_at({2.6, 0.3});
  motion2.p_BO = {0.5, 0.1};
  const double u = 0.83;
  const CurveContacts found = list_support_contacts({make_curve(cam), {}, ellipse, motion2}, u);
  EXPECT_EQ(found.status, ContactsStatus::kComplete);
  ASSERT_GE(found.contacts.size(), 2U);
  for (const CurveContact& c : found.contacts) {
    const CurveContacts back = list_support_contacts({ellipse, motion2, make_curve(cam), {}}, c.q);
    EXPECT_EQ(back.status, ContactsStatus::kComplete);
    const bool same = std::any_of(back.contacts.begin(), back.contacts.end(), [&](const CurveContact& d) {
      return std::abs(d.q - u) <= 1e-12 && (d.p_W - c.p_W).norm() <= 1e-12 && d.opposed == c.opposed;
    });
    EXPECT_TRUE(same) << "q = " << c.q;
  }
}

// 8 b > a: the radius of curvature changes sign at six cusps.
TEST(ContactsOfALobedCam, AreNotDecidedWhereItHasCusps) {
  const LobedCurve cam(1.37, 0.21);
  const CurveContacts found =
      list_support_contacts({make_curve(cam), {}, circle({0, 0}, 0.23), slider(0)}, 0);
  EXPECT_EQ(found.status, ContactsStatus::kUndecided);
  EXPECT_TRUE(found.contacts.empty());
}

// The roller's centre is at the distance r + R from the segment between the centres of the racetrack's arcs.
TEST(ContactsOfARacetrack, AreOnItsArcsAndOnItsFlats) {
  const double half = 0.8, r = 0.3, R = 0.17;
  const Racetrack track(half, r);
  for (const double y : {0.0, 0.1, 0.3, 0.45}) {
    const CurveContacts found =
        list_support_contacts({make_curve(track), {}, circle({0, 0}, R), slider(y)}, 0);
    EXPECT_EQ(found.status, ContactsStatus::kComplete);
    const double x = half + std::sqrt((r + R) * (r + R) - y * y);
    expect_positions({-x, x}, positions(found, true), 1e-14);
  }
  const CurveContacts on_flats =
      list_support_contacts({make_curve(track), {}, circle({0, 0}, R), upwards(0.31)}, 0);
  EXPECT_EQ(on_flats.status, ContactsStatus::kComplete);
  expect_positions({-(r + R), r + R}, positions(on_flats, true), 1e-14);
  expect_positions({-(r - R), r - R}, positions(on_flats, false), 1e-14);
  for (const CurveContact& c : on_flats.contacts) {
    EXPECT_NEAR(c.p_W.x(), 0.31, 1e-14);
  }
}

TEST(ContactsOfARacetrack, AreWhereTheArmOfAnOscillatingRollerReaches) {
  const double half = 0.8, r = 0.3, R = 0.17, arm = 1.3;
  const Racetrack track(half, r);
  const Vector2d pivot(0.5, 1.6);
  const CurveContacts found =
      list_support_contacts({make_curve(track), {}, circle({arm, 0}, R), pivot_at(pivot)}, 0);
  EXPECT_EQ(found.status, ContactsStatus::kComplete);
  // On the flat the roller's centre is at the height r + R.
  const double down = std::asin((1.6 - r - R) / arm);
  const double x = 0.5 - arm * std::cos(down);
  ASSERT_LT(std::abs(x), half);
  const std::vector<double> q = positions(found, true);
  EXPECT_TRUE(
      std::any_of(q.begin(), q.end(), [&](double at) { return std::abs(at + kPi - down) <= 1e-14 * 4; }));
  for (const CurveContact& c : found.contacts) {
    const Vector2d center = pivot + arm * unit_vector(c.q);
    const Vector2d nearest(std::clamp(center.x(), -half, half), 0);
    EXPECT_NEAR((center - nearest).norm(), c.opposed ? r + R : r - R, 1e-13);
  }
}

TEST(ContactsOfARacetrack, AreCountedOnceAtASeamOfArcAndFlat) {
  const double half = 0.75, r = 0.3, R = 0.17;
  const Racetrack track(half, r);
  const CurveContacts found =
      list_support_contacts({make_curve(track), {}, circle({0, 0}, R), upwards(half)}, 0);
  EXPECT_EQ(found.status, ContactsStatus::kComplete);
  expect_positions({-(r + R), r + R}, positions(found, true), 1e-14);
}

TEST(ContactsOfARacetrack, AreNotDecidedWhereTwoFlatsMeet) {
  const Racetrack track(0.8, 0.3);
  const Curve face = make_line({0, 0}, {0, -1}).value();
  const CurveContacts found = list_support_contacts({make_curve(track), {}, face, upwards(0)}, 0);
  EXPECT_EQ(found.status, ContactsStatus::kUndecided);
  EXPECT_TRUE(positions(found, true).empty());
  const CurveContacts turned = list_support_contacts({make_curve(track), {}, face, upwards(0)}, 0.2);
  EXPECT_EQ(turned.status, ContactsStatus::kComplete);
  expect_positions({0.3 + 0.8 * std::sin(0.2)}, positions(turned, true), 1e-12);
}

// Inside the cam cos³δ = (a - r)/(8 b): three contacts within δ of the normal φ = 0.
TEST(ContactsAtALimit, AreToldApartWhereThreeAreClose) {
  const double b = 0.21, r = 0.23;
  for (const double delta : {1e-2, 1e-3, 3e-4}) {
    const LobedCurve cam(8 * b * std::pow(std::cos(delta), 3) + r, b);
    const CurveContacts found = list_support_contacts({make_curve(cam), {}, circle({0, 0}, r), slider(0)}, 0);
    EXPECT_EQ(found.status, ContactsStatus::kComplete);
    EXPECT_EQ(positions(found, true).size(), 2U);
    int near = 0;
    for (const CurveContact& c : found.contacts) {
      const double phi = std::abs(angle_of(c.n_W));
      if (c.opposed || phi > 0.1) continue;
      ++near;
      // A root of 8 b (φ² - δ²) φ: rounding moves it by 1e-16/δ² relative to the lengths.
      EXPECT_TRUE(phi <= 2e-15 / (delta * delta) || std::abs(phi - delta) <= 2e-15 / (delta * delta)) << phi;
    }
    EXPECT_EQ(near, 3) << "delta = " << delta;
  }
}

TEST(ContactsAtALimit, AreToldApartWhereTwoPositionsAreABillionthApart) {
  const double radius = 0.5e-9;
  const CurveContacts found =
      list_support_contacts({circle({0.7, 0.2}, radius), {}, make_point({0, 0}).value(), slider(0.2)}, 0);
  EXPECT_EQ(found.status, ContactsStatus::kComplete);
  expect_positions({0.7 - radius, 0.7 + radius}, positions(found, true), 4e-16);
}

// On an arm the plane curves are circles as large as the arm, and as close to each other as the pin is small.
TEST(ContactsAtALimit, AreToldApartForATinyPinOnAnArm) {
  const double radius = 0.5e-5;
  const CurveContacts found = list_support_contacts(
      {circle({0.7, 0.2}, radius), {}, make_point({1, 0}).value(), pivot_at({0.7, 1.2})}, 0);
  EXPECT_EQ(found.status, ContactsStatus::kComplete);
  const double angle = 2 * std::asin(radius / 2);
  expect_positions({-kPi / 2 - angle, -kPi / 2 + angle}, positions(found, true), 1e-15);
}

// A roller of radius r2 at the end of a lever e, against a disc at the distance L from its pivot: cos(angle
// between) = 1 - ((r1 + r2)² - (L - e)²)/(2 L e).
TEST(ContactsAtALimit, AreToldApartForALongLever) {
  const double r1 = 0.731, r2 = 0.447;
  for (const double lever : {17.0, 1e3, 1e6}) {
    const double L = lever + 0.6;
    const CurveContacts found =
        list_support_contacts({circle({0, 0}, r1), {}, circle({lever, 0}, r2), pivot_at({L, 0})}, 0.3);
    EXPECT_EQ(found.status, ContactsStatus::kComplete);
    const double one_minus_cos = (r1 + r2 - 0.6) * (r1 + r2 + 0.6) / (2 * L * lever);
    const double angle = 2 * std::asin(std::sqrt(one_minus_cos / 2));
    expect_positions({-(kPi - angle), kPi - angle}, positions(found, true), 4e-15);
  }
}

// Two circles whose centres pass each other at the distance r1 + r2: a limit, at q = 0.
TEST(ContactsAtALimit, AreNotDecidedWhereTwoMerge) {
  const CurveContacts found =
      list_support_contacts({circle({0, 0}, 0.75), {}, circle({0, 0}, 0.5), slider(1.25)}, 0.3);
  EXPECT_EQ(found.status, ContactsStatus::kUndecided);
  EXPECT_TRUE(positions(found, true).empty());
}

TEST(SupportContacts, AreNoneWhereTheCurvesDoNotReachEachOther) {
  const LobedCurve cam(1.37, 0.17);
  const CurveContacts found =
      list_support_contacts({make_curve(cam), {}, circle({0.5, 0}, 0.2), pivot_at({2.4, 0})}, 1.1);
  EXPECT_EQ(found.status, ContactsStatus::kComplete);
  EXPECT_TRUE(found.contacts.empty());
}

// A circle slides into a hole of its own size: at q = 0 they touch all round.
TEST(SupportContacts, AreNotDecidedWhereCurvesTouchAllRound) {
  const CurveContacts found =
      list_support_contacts({circle({0, 0}, 0.75, Side::kOutside), {}, circle({0, 0}, 0.75), slider(0)}, 0);
  EXPECT_EQ(found.status, ContactsStatus::kUndecided);
  EXPECT_TRUE(positions(found, true).empty());
}

// The roller's centre is its pivot: the distance does not depend on q.
TEST(SupportContacts, AreNotDecidedIfTheFollowerDoesNotMoveThem) {
  const Curve disc = circle({0, 0}, 0.5);
  const Curve roller = circle({0, 0}, 0.25);
  const CurveContacts touching = list_support_contacts({disc, {}, roller, pivot_at({0.75, 0})}, 0);
  EXPECT_EQ(touching.status, ContactsStatus::kUndecided);
  EXPECT_TRUE(touching.contacts.empty());
  const CurveContacts apart = list_support_contacts({disc, {}, roller, pivot_at({0.8, 0})}, 0);
  EXPECT_EQ(apart.status, ContactsStatus::kComplete);
  EXPECT_TRUE(apart.contacts.empty());
}

TEST(SupportContacts, FollowAChangeOfScale) {
  const auto of = [](double scale) {
    const LobedCurve cam(1.37 * scale, 0.17 * scale);
    return list_support_contacts(
        {make_curve(cam), {}, circle({2.1 * scale, 0}, 0.23 * scale), pivot_at({2.3 * scale, 0.4 * scale})},
        0.37);
  };
  const CurveContacts plain = of(1);
  for (const double scale : {1e-6, 1e6}) {
    const CurveContacts found = of(scale);
    EXPECT_EQ(found.status, ContactsStatus::kComplete);
    expect_positions(positions(plain, true), positions(found, true), 1e-12);
    expect_positions(positions(plain, false), positions(found, false), 1e-12);
  }
}

}  // namespace
}  // namespace higherpair
