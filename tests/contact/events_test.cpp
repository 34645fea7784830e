#include "contact/freedoms.hpp"
#include "contact/pair_follower.hpp"
#include "contact/touch/stroke_end.hpp"
#include "higherpair/contact/finder.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::pivot;

FollowedContact track_at(const ContactPair& pair, double u, double q) {
  const FindResult found = find_nearest_contact(pair, u, q);
  EXPECT_EQ(found.status, FindStatus::kFound);
  return start_track(pair, found.at, found.branch);
}

// An eccentric disc lifts a disc on a slide with offset: the stroke ends where crank and coupler are in line,
// at ±√((r3 ± r2)² - offset²).
TEST(Events, TheStrokeEndsWhereCrankAndCouplerAreInLine) {
  OneFreedom slide;
  slide.turns = false;
  slide.p_WO = Vector2d(0.013, 0);
  slide.direction_W = Vector2d::UnitY();
  const double r2 = 0.031;
  const double r3 = 0.08;
  const ContactPair pair = {make_circle(Vector2d(r2, 0), 0.05).value(), pivot(0, 0),
                            make_circle(Vector2d::Zero(), 0.03).value(), slide};
  FollowedContact track = track_at(pair, 0.1, 0.1);
  int ends = 0;
  for (int k = 1; k <= 72; ++k) {
    const double u = 0.1 + k * kPi / 36;
    if (const auto end = stroke_end(track, u)) {
      ++ends;
      const double length = end->q > std::hypot(r3, 0.013) ? r3 + r2 : r3 - r2;
      const double q = std::sqrt(length * length - 0.013 * 0.013);
      EXPECT_LE(std::abs(end->q - q), 1e-16);
      // Rounding of the lengths, and the same divided by the second derivative.
      EXPECT_LE(std::abs(end->dq), 5e-16);
      // The crank points along the line from its pivot to the slider, or against it.
      const double angle = std::atan2(q, 0.013) + (length > r3 ? 0 : kPi);
      EXPECT_LE(std::abs(end->u - nearest_turn(angle, end->u)), 3e-14);
    }
    ASSERT_EQ(follow_to(track, u).status, TrackStatus::kOk);
  }
  EXPECT_EQ(ends, 2);
}

TEST(Events, NoStrokeEndsWhereTheRateKeepsItsSign) {
  const ContactPair pair = {make_ellipse(Vector2d(0.01, 0), {0.03, 0.022}, 0.2).value(), pivot(0, 0),
                            make_circle(Vector2d(-0.06, 0), 0.02).value(), pivot(0.08, 0)};
  FollowedContact track = track_at(pair, 0, -0.6);
  int ends = 0;
  for (int k = 1; k <= 360; ++k) {
    const double before = track.at.dq;
    const auto end = stroke_end(track, k * kPi / 180);
    ASSERT_EQ(follow_to(track, k * kPi / 180).status, TrackStatus::kOk);
    EXPECT_EQ(end.has_value(), before * track.at.dq <= 0);
    if (end) {
      ++ends;
      EXPECT_LE(std::abs(end->dq), 1e-14);
      EXPECT_GT(end->u, (k - 1) * kPi / 180);
      EXPECT_LT(end->u, k * kPi / 180);
    }
  }
  EXPECT_GE(ends, 2);
  EXPECT_EQ(ends % 2, 0);
}

// A disc of radius r in an elliptic ring conforms where the ring's radius is r. Its centre is then on the
// ellipse's evolute, at ((a² - b²)/a cos³ t, (b² - a²)/b sin³ t) with (a² sin² t + b² cos² t)^{3/2} = a b r.
TEST(Events, ADiscConformsToAnEllipticRingWhereItsCentreMeetsTheEvolute) {
  const double a = 0.5;
  const double b = 0.3;
  const double r = 0.23;
  const double d = 0.11;
  const double arm = 0.17;
  const double square = (std::pow(a * b * r, 2.0 / 3) - b * b) / (a * a - b * b);
  const double sin = std::sqrt(square);
  const double cos = std::sqrt(1 - square);
  const Vector2d evolute((a * a - b * b) / a * cos * cos * cos, (b * b - a * a) / b * sin * sin * sin);
  const ContactPair pair = {make_circle(Vector2d(arm, 0), r).value(), pivot(0, 0),
                            make_ellipse(Vector2d::Zero(), {a, b}, 0, Side::kOutside).value(), pivot(d, 0)};
  // |c1(u) - O2| = |evolute point|.
  const double cosine = (arm * arm + d * d - evolute.squaredNorm()) / (2 * arm * d);
  ASSERT_LT(std::abs(cosine), 1);
  const double u = std::acos(cosine);
  const Vector2d c1 = arm * unit_vector(u);
  const double q = angle_of(c1 - pair.motion2.p_WO) - angle_of(evolute);
  ContactPosition guess;
  guess.u = u + 0.03;
  guess.q = q - 0.05;
  const Vector2d on_ring(a * cos, b * sin);
  guess.n_W = Rotation<double>::from_angle(q + 0.04) * Vector2d(on_ring - evolute).normalized();
  const auto conforming = conforming_near(pair, guess, 1);
  ASSERT_TRUE(conforming.has_value());
  EXPECT_LE(std::abs(conforming->u - u), 1e-13);
  EXPECT_LE(std::abs(conforming->q - q), 1e-13);
  EXPECT_LE(std::abs(conforming->rho1 + conforming->rho2), 1e-14);
  EXPECT_LE((conforming->p2_W - conforming->p1_W).norm(), 1e-15);

  // Two contacts merge there: a track from either side ends at the same position.
  for (const double aside : {-0.2, 0.2}) {
    const Vector2d n = Rotation<double>::from_angle(aside) * conforming->n_W;
    const int branch = conforming->gap_q > 0 ? 1 : -1;
    const ContactResult before = solve_contact(pair, u - 0.02, q, n, branch);
    ASSERT_EQ(before.status, ContactStatus::kOk);
    EXPECT_LT((before.at.rho1 + before.at.rho2) * aside, 0);
    FollowedContact track = start_track(pair, before.at, branch);
    const TrackResult lost = follow_to(track, u + 0.02);
    EXPECT_EQ(lost.status, TrackStatus::kNotAssemblable);
    ASSERT_TRUE(lost.limit.has_value());
    EXPECT_LE(std::abs(lost.limit->u - u), 1e-13);
  }
}

TEST(Events, CirclesFlatFacesAndPointsDoNotConform) {
  ContactPosition at;
  const Curve disc = make_circle(Vector2d(0.1, 0), 0.2).value();
  const Curve ring = make_circle(Vector2d(0, 0.1), 0.4, Side::kOutside).value();
  EXPECT_FALSE(conforming_near({disc, pivot(0, 0), ring, pivot(0.1, 0)}, at, 1));
  EXPECT_FALSE(conforming_near(
      {disc, pivot(0, 0), make_line(Vector2d::Zero(), Vector2d::UnitY()).value(), pivot(1, 0)}, at, 1));
  EXPECT_FALSE(
      conforming_near({make_point(Vector2d(0.1, 0)).value(), pivot(0, 0), disc, pivot(1, 0)}, at, 1));
}

}  // namespace
}  // namespace higherpair
