#include "higherpair/contact/subdivision.hpp"

#include "contact/support_curves.hpp"
#include "higherpair/geometry/curve.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
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

std::unique_ptr<SupportCurve> circle(const Vector2d& center, double radius, Side side = Side::kInside) {
  return make_support_curve(make_circle(center, radius, side).value(), 1);
}

std::vector<double> positions(const SubdivisionContacts& found, bool opposed) {
  std::vector<double> q;
  for (const CertifiedContact& c : found.contacts) {
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
TEST(SubdivisionOfInvolutes, HasOneContactWhichRunsAlongTheLineOfAction) {
  const double r1 = 0.31, r2 = 0.47, L = 1.1;
  const InvoluteBySupport driver(r1, {0.05, 3.0});
  const InvoluteBySupport follower(r2, {0.05, 1.9});
  OneFreedom motion2;
  motion2.p_WO = {L, 0};
  const double phi = -std::asin((r1 + r2) / L);
  for (const double u : {-1.6, -1.4, -1.2}) {
    const SubdivisionContacts found = find_contacts_by_subdivision({driver, {}, follower, motion2}, u);
    EXPECT_EQ(found.status, SubdivisionStatus::kComplete);
    ASSERT_EQ(positions(found, true).size(), 1U) << "u = " << u;
    const auto at = std::find_if(found.contacts.begin(), found.contacts.end(),
                                 [](const CertifiedContact& c) { return c.opposed; });
    const double h1 = r1 * (phi - u);
    const double q = phi + kPi - (L * std::cos(phi) - h1) / r2;
    EXPECT_NEAR(at->q, q, 1e-14);
    EXPECT_TRUE(at->q_bounds.contains(q));
    EXPECT_LE((at->n_W - unit_vector(phi)).norm(), 1e-14);
    EXPECT_LE((at->p_W - (h1 * unit_vector(phi) + r1 * perp(unit_vector(phi)))).norm(), 1e-14);
    EXPECT_NEAR(at->rho1, h1, 1e-14);
  }
}

// A roller of radius r, its centre on the x axis through the cam's: y = 0 on the curve at the distance r,
//     sin φ (a + r - 8 b cos³φ) = 0,   x = (a + r + b cos 3φ) cos φ + 3 b sin 3φ sin φ.
// r < 0: the roller is inside (normals not opposed). A point x of that curve is the roller's centre.
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

TEST(SubdivisionOfALobedCam, FindsARollerOnItsAxisOfSymmetryWhereTheClosedFormDoes) {
  const double a = 1.37, r = 0.23;
  const auto roller = circle({0, 0}, r);
  for (const double b : {0.05, 0.15, 0.21, 0.6, -0.4}) {
    const LobedCurve cam(a, b);
    const SubdivisionContacts found = find_contacts_by_subdivision({cam, {}, *roller, slider(0)}, 0);
    EXPECT_EQ(found.status, SubdivisionStatus::kComplete);
    expect_positions(centers_on_axis(a, b, r), positions(found, true), 1e-13);
    expect_positions(centers_on_axis(a, b, -r), positions(found, false), 1e-13);
  }
}

// Turned inside out, the roller is in a ring of three bays: what was opposed is not, and the other way round.
TEST(SubdivisionOfALobedCam, FindsTheSameRollerInARing) {
  const double a = 1.37, b = 0.21, r = 0.23;
  const LobedCurve ring(a, -b, true);
  const auto roller = circle({0, 0}, r);
  const SubdivisionContacts found = find_contacts_by_subdivision({ring, {}, *roller, slider(0)}, 0);
  EXPECT_EQ(found.status, SubdivisionStatus::kComplete);
  expect_positions(centers_on_axis(a, -b, -r), positions(found, true), 1e-13);
  expect_positions(centers_on_axis(a, -b, r), positions(found, false), 1e-13);
  for (const CertifiedContact& c : found.contacts) EXPECT_LT(c.rho1, -(a - 8 * b) + 16 * b);
}

// A roller on an arm: its centre meets the curve at the distance ±r, walked in small steps; |x - pivot|² -
// arm² changes its sign there.
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

TEST(SubdivisionOfALobedCam, FindsAsManyContactsOfAnOscillatingRollerAsAWalkAlongTheCurve) {
  const double a = 1.37, r = 0.23, arm = 2.1;
  const Vector2d pivot(2.3, 0.4);
  const auto roller = circle({arm, 0}, r);
  OneFreedom motion2;
  motion2.p_WO = pivot;
  for (const double b : {0.07, 0.18, 0.45}) {
    const LobedCurve cam(a, b);
    for (int i = 0; i < 12; ++i) {
      const double u = 0.37 + 0.51 * i;
      const SubdivisionContacts found = find_contacts_by_subdivision({cam, {}, *roller, motion2}, u);
      EXPECT_EQ(found.status, SubdivisionStatus::kComplete);
      EXPECT_EQ(static_cast<int>(positions(found, true).size()), crossings_on_a_walk(a, b, u, r, arm, pivot));
      EXPECT_EQ(static_cast<int>(positions(found, false).size()),
                crossings_on_a_walk(a, b, u, -r, arm, pivot));
      for (const CertifiedContact& c : found.contacts) {
        const Vector2d center = pivot + arm * unit_vector(c.q);
        EXPECT_NEAR((c.p_W - center).norm(), r, 1e-13);
        EXPECT_LE((c.p_W + (c.opposed ? r : -r) * c.n_W - center).norm(), 1e-13);
      }
    }
  }
}

// What touches at (u, q) with one body as driver touches at (q, u) with the other.
TEST(SubdivisionOfALobedCam, FindsTheSameContactsWhenTheBodiesChangeRoles) {
  const LobedCurve cam(1.37, 0.25);
  const auto ellipse = make_support_curve(make_ellipse({0.2, -0.1}, {1.4, 0.5}, 0.3).value(), 1);
  OneFreedom motion2;
  motion2.p_WO = {2.6, 0.3};
  motion2.p_BO = {0.5, 0.1};
  const double u = 0.83;
  const SubdivisionContacts found = find_contacts_by_subdivision({cam, {}, *ellipse, motion2}, u);
  EXPECT_EQ(found.status, SubdivisionStatus::kComplete);
  ASSERT_GE(found.contacts.size(), 2U);
  for (const CertifiedContact& c : found.contacts) {
    const SubdivisionContacts back = find_contacts_by_subdivision({*ellipse, motion2, cam, {}}, c.q);
    EXPECT_EQ(back.status, SubdivisionStatus::kComplete);
    const bool same = std::any_of(back.contacts.begin(), back.contacts.end(), [&](const CertifiedContact& d) {
      return std::abs(d.q - u) <= 1e-12 && (d.p_W - c.p_W).norm() <= 1e-12 && d.opposed == c.opposed;
    });
    EXPECT_TRUE(same) << "q = " << c.q;
  }
}

// The roller's centre is at the distance r + R from the segment between the track's centres.
TEST(SubdivisionOfARacetrack, FindsARollerOnItsArcsAndOnItsFlats) {
  const double half = 0.8, r = 0.3, R = 0.17;
  const Racetrack track(half, r);
  const auto roller = circle({0, 0}, R);
  for (const double y : {0.0, 0.1, 0.3, 0.45}) {
    const SubdivisionContacts found = find_contacts_by_subdivision({track, {}, *roller, slider(y)}, 0);
    EXPECT_EQ(found.status, SubdivisionStatus::kComplete);
    const double x = half + std::sqrt((r + R) * (r + R) - y * y);
    expect_positions({-x, x}, positions(found, true), 1e-14);
  }
  OneFreedom upwards = slider(0);
  upwards.direction_W = {0, 1};
  upwards.p_WO = {0.31, 0};
  const SubdivisionContacts on_flats = find_contacts_by_subdivision({track, {}, *roller, upwards}, 0);
  EXPECT_EQ(on_flats.status, SubdivisionStatus::kComplete);
  expect_positions({-(r + R), r + R}, positions(on_flats, true), 1e-14);
  expect_positions({-(r - R), r - R}, positions(on_flats, false), 1e-14);
  for (const CertifiedContact& c : on_flats.contacts) {
    EXPECT_EQ(c.piece1, c.n_W.y() > 0 ? 1U : 3U);
    EXPECT_NEAR(c.p_W.x(), 0.31, 1e-14);
  }
}

TEST(SubdivisionOfARacetrack, FindsAnOscillatingRollerWhereItsArmReaches) {
  const double half = 0.8, r = 0.3, R = 0.17, arm = 1.3;
  const Racetrack track(half, r);
  const auto roller = circle({arm, 0}, R);
  OneFreedom motion2;
  motion2.p_WO = {0.5, 1.6};
  const SubdivisionContacts found = find_contacts_by_subdivision({track, {}, *roller, motion2}, 0);
  EXPECT_EQ(found.status, SubdivisionStatus::kComplete);
  // On the flat the centre is at the height r + R.
  const double down = std::asin((1.6 - r - R) / arm);
  const double x = 0.5 - arm * std::cos(down);
  ASSERT_LT(std::abs(x), half);
  const std::vector<double> q = positions(found, true);
  EXPECT_TRUE(
      std::any_of(q.begin(), q.end(), [&](double at) { return std::abs(at + kPi - down) <= 1e-14 * 4; }));
  for (const CertifiedContact& c : found.contacts) {
    const Vector2d center = motion2.p_WO + arm * unit_vector(c.q);
    const Vector2d nearest(std::clamp(center.x(), -half, half), 0);
    EXPECT_NEAR((center - nearest).norm(), c.opposed ? r + R : r - R, 1e-13);
  }
}

TEST(SubdivisionOfARacetrack, LeavesAContactAtASeamUndecidedAsOnePlace) {
  const double half = 0.75, r = 0.3, R = 0.17;
  const Racetrack track(half, r);
  const auto roller = circle({0, 0}, R);
  OneFreedom upwards = slider(0);
  upwards.direction_W = {0, 1};
  upwards.p_WO = {half, 0};
  SubdivisionOptions options;
  options.range = {0.4, 10};
  const SubdivisionContacts found = find_contacts_by_subdivision({track, {}, *roller, upwards}, 0, options);
  EXPECT_EQ(found.status, SubdivisionStatus::kUndecided);
  EXPECT_TRUE(found.contacts.empty());
  ASSERT_EQ(found.possible.size(), 1U);
  EXPECT_TRUE(found.possible[0].q.contains(r + R));
  EXPECT_LE(found.possible[0].q.width(), 1e-5);
}

TEST(SubdivisionOfARacetrack, SaysPossibleWhereTwoFlatsMeet) {
  const Racetrack track(0.8, 0.3);
  const auto face = make_support_curve(make_line({0, 0}, {0, -1}).value(), 1);
  OneFreedom upwards = slider(0);
  upwards.direction_W = {0, 1};
  const SubdivisionContacts found = find_contacts_by_subdivision({track, {}, *face, upwards}, 0);
  EXPECT_EQ(found.status, SubdivisionStatus::kUndecided);
  EXPECT_TRUE(std::any_of(found.possible.begin(), found.possible.end(), [](const PossibleContact& p) {
    return p.opposed && p.q.contains(0.3) && p.q.width() < 1e-5;
  }));
}

// cos³δ = (a + r)/(8 b): three contacts within δ of the normal φ = 0.
TEST(SubdivisionAtALimit, TellsThreeCloseContactsApartIfTheToleranceAsksForIt) {
  const double b = 0.21, r = 0.23;
  for (const double delta : {1e-2, 1e-3, 3e-4}) {
    const double a = 8 * b * std::pow(std::cos(delta), 3) - r;
    const LobedCurve cam(a, b);
    const auto roller = circle({0, 0}, r);
    SubdivisionOptions options;
    options.range = {0, 10};
    options.tolerance = 10 * delta;
    const SubdivisionContacts coarse =
        find_contacts_by_subdivision({cam, {}, *roller, slider(0)}, 0, options);
    EXPECT_EQ(coarse.status, SubdivisionStatus::kUndecided);
    EXPECT_TRUE(positions(coarse, true).empty());
    std::vector<PossibleContact> opposed = coarse.possible;
    std::erase_if(opposed, [](const PossibleContact& p) { return !p.opposed; });
    ASSERT_EQ(opposed.size(), 1U);
    EXPECT_TRUE(opposed[0].q.contains(a + r + b));
    EXPECT_TRUE(opposed[0].phi.contains(-delta) && opposed[0].phi.contains(0) &&
                opposed[0].phi.contains(delta));
    options.tolerance = delta / 100;
    const SubdivisionContacts fine = find_contacts_by_subdivision({cam, {}, *roller, slider(0)}, 0, options);
    EXPECT_EQ(fine.status, SubdivisionStatus::kComplete);
    ASSERT_EQ(positions(fine, true).size(), 3U) << "delta = " << delta;
    for (const CertifiedContact& c : fine.contacts) {
      const double phi = angle_of(c.n_W);
      // A root of 8 b (φ² - δ²) φ: rounding moves it by 1e-16/δ² relative to the lengths.
      EXPECT_TRUE(!c.opposed || std::abs(phi) <= 2e-15 / (delta * delta) ||
                  std::abs(std::abs(phi) - delta) <= 2e-15 / (delta * delta))
          << phi;
    }
  }
}

TEST(SubdivisionAtALimit, TellsTwoPositionsABillionthApart) {
  const double radius = 0.5e-9;
  const auto pin = circle({0.7, 0.2}, radius);
  const auto edge = make_support_curve(make_point({0, 0}).value(), 1);
  const SubdivisionContacts found = find_contacts_by_subdivision({*pin, {}, *edge, slider(0.2)}, 0);
  EXPECT_EQ(found.status, SubdivisionStatus::kComplete);
  expect_positions({0.7 - radius, 0.7 + radius}, positions(found, true), 4e-16);
  OneFreedom motion2;
  motion2.p_WO = {0.7, 1.2};
  const auto swinging = make_support_curve(make_point({1, 0}).value(), 1);
  const SubdivisionContacts swung = find_contacts_by_subdivision({*pin, {}, *swinging, motion2}, 0);
  EXPECT_EQ(swung.status, SubdivisionStatus::kComplete);
  expect_positions({-kPi / 2 - radius, -kPi / 2 + radius}, positions(swung, true), 1e-15);
}

// A roller of radius r2 at the end of a lever, against a disc at the lever's end: cos between = 1 - ((r1 +
// r2)² - (L - e)²)/(2 L e).
TEST(SubdivisionAtALimit, TellsContactsOfALongLeverApart) {
  const double r1 = 0.731, r2 = 0.447;
  for (const double lever : {17.0, 1e3, 1e6}) {
    const auto disc = circle({0, 0}, r1);
    const auto roller = circle({lever, 0}, r2);
    const double L = lever + 0.6;
    OneFreedom motion2;
    motion2.p_WO = {L, 0};
    const SubdivisionContacts found = find_contacts_by_subdivision({*disc, {}, *roller, motion2}, 0.3);
    EXPECT_EQ(found.status, SubdivisionStatus::kComplete);
    const double one_minus_cos = (r1 + r2 - 0.6) * (r1 + r2 + 0.6) / (2 * L * lever);
    const double angle = 2 * std::asin(std::sqrt(one_minus_cos / 2));
    expect_positions({-(kPi - angle), kPi - angle}, positions(found, true), 4e-15);
    EXPECT_LE(found.boxes, 10000U);
  }
}

// Two circles whose centres pass each other at the distance r1 + r2: a limit, at q = 0.
TEST(SubdivisionAtALimit, SaysPossibleAndWhere) {
  const auto one = circle({0, 0}, 0.75);
  const auto other = circle({0, 0}, 0.5);
  const SubdivisionContacts found = find_contacts_by_subdivision({*one, {}, *other, slider(1.25)}, 0.3);
  EXPECT_EQ(found.status, SubdivisionStatus::kUndecided);
  EXPECT_TRUE(positions(found, true).empty());
  ASSERT_EQ(found.possible.size(), 1U);
  EXPECT_TRUE(found.possible[0].opposed && found.possible[0].q.contains(0));
  EXPECT_TRUE(found.possible[0].phi.contains(kPi / 2));
  EXPECT_LE(found.possible[0].q.width(), 1e-5);
}

TEST(Subdivision, FindsNothingWhereTheCurvesDoNotReachEachOther) {
  const LobedCurve cam(1.37, 0.25);
  const auto roller = circle({0.5, 0}, 0.2);
  OneFreedom motion2;
  motion2.p_WO = {2.4, 0};
  const SubdivisionContacts found = find_contacts_by_subdivision({cam, {}, *roller, motion2}, 1.1);
  EXPECT_EQ(found.status, SubdivisionStatus::kComplete);
  EXPECT_TRUE(found.contacts.empty());
}

TEST(Subdivision, LooksOnlyAtTheGivenRangeOfASlide) {
  const LobedCurve cam(1.37, 0.15);
  const auto roller = circle({0, 0}, 0.23);
  SubdivisionOptions options;
  options.range = {1.5, 2};
  const SubdivisionContacts found = find_contacts_by_subdivision({cam, {}, *roller, slider(0)}, 0, options);
  EXPECT_EQ(found.status, SubdivisionStatus::kComplete);
  expect_positions({1.37 + 0.15 + 0.23}, positions(found, true), 1e-14);
  EXPECT_TRUE(positions(found, false).empty());
}

// A circle slides into a hole of its own size: at q = 0 they touch all round.
TEST(Subdivision, SaysThatItsBudgetEndedWhereCurvesTouchAllRound) {
  const auto hole = circle({0, 0}, 0.75, Side::kOutside);
  const auto disc = circle({0, 0}, 0.75);
  SubdivisionOptions options;
  options.max_boxes = 3000;
  const SubdivisionContacts found = find_contacts_by_subdivision({*hole, {}, *disc, slider(0)}, 0, options);
  EXPECT_EQ(found.status, SubdivisionStatus::kExhausted);
  EXPECT_LE(found.boxes, 3000U);
  EXPECT_TRUE(std::any_of(found.possible.begin(), found.possible.end(), [](const PossibleContact& p) {
    return p.opposed && p.q.contains(0) && p.q.width() < 0.05 && p.phi.width() > 6.28;
  }));
}

// The roller's centre is its pivot: the distance does not depend on q.
TEST(Subdivision, SaysThatAContactMayBeAnywhereIfTheFollowerDoesNotMoveIt) {
  const auto disc = circle({0, 0}, 0.5);
  const auto roller = circle({0, 0}, 0.25);
  OneFreedom motion2;
  motion2.p_WO = {0.75, 0};
  SubdivisionOptions options;
  options.max_boxes = 4000;
  const SubdivisionContacts touching =
      find_contacts_by_subdivision({*disc, {}, *roller, motion2}, 0, options);
  EXPECT_EQ(touching.status, SubdivisionStatus::kExhausted);
  ASSERT_EQ(touching.possible.size(), 1U);
  EXPECT_GT(touching.possible[0].q.width(), 6.28);
  EXPECT_LT(touching.possible[0].phi.width(), 0.2);
  motion2.p_WO = {0.8, 0};
  const SubdivisionContacts apart = find_contacts_by_subdivision({*disc, {}, *roller, motion2}, 0, options);
  EXPECT_EQ(apart.status, SubdivisionStatus::kComplete);
  EXPECT_TRUE(apart.contacts.empty());
}

TEST(Subdivision, FollowsAChangeOfScale) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const LobedCurve cam(1.37 * scale, 0.25 * scale);
    const auto roller = circle({2.1 * scale, 0}, 0.23 * scale);
    OneFreedom motion2;
    motion2.p_WO = {2.3 * scale, 0.4 * scale};
    const SubdivisionContacts found = find_contacts_by_subdivision({cam, {}, *roller, motion2}, 0.37);
    const SubdivisionContacts plain = find_contacts_by_subdivision(
        {LobedCurve(1.37, 0.25), {}, *circle({2.1, 0}, 0.23), {true, {2.3, 0.4}, {0, 0}, {1, 0}, 0, {}}},
        0.37);
    EXPECT_EQ(found.status, SubdivisionStatus::kComplete);
    expect_positions(positions(plain, true), positions(found, true), 1e-12);
    expect_positions(positions(plain, false), positions(found, false), 1e-12);
  }
}

}  // namespace
}  // namespace higherpair
