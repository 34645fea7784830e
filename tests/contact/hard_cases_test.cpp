#include "contact/freedoms.hpp"
#include "contact/pair_follower.hpp"
#include "contact_laws.hpp"
#include "higherpair/contact/finder.hpp"
#include "linkage/four_bar_motion.hpp"
#include "random_pairs.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::pivot;

Curve disc(double x, double y, double radius) {
  return make_circle(Vector2d(x, y), radius).value();
}

Curve ring(double x, double y, double radius) {
  return make_circle(Vector2d(x, y), radius, Side::kOutside).value();
}

// Distance of P from a huge circle through the origin of a body that is turned by q about O, with the centre
// on its +y axis: (|P|² - 2 R y)/(|P - C| + R) avoids cancellation.
long double distance_from_huge(const Vector2d& p, const Vector2d& O, long double q, long double R) {
  const long double dx = static_cast<long double>(p.x()) - O.x();
  const long double dy = static_cast<long double>(p.y()) - O.y();
  const long double x = std::cos(q) * dx + std::sin(q) * dy;
  const long double y = -std::sin(q) * dx + std::cos(q) * dy;
  return (x * x + y * y - 2 * R * y) / (std::hypot(x, y - R) + R);
}

// A follower whose face is an arc with a radius of up to 10⁹ times the mechanism's size, convex or concave.
TEST(HardContacts, NearlyFlatFacesLoseNoDigits) {
  for (const double R : {1e3, 1e6, 1e9}) {
    const Curve arc{CurveKind::kCircle, Side::kInside, Vector2d::Zero(), Vector2d::UnitY(), R, 1};
    const ContactPair pair = {disc(0.2, 0.05, 0.3), pivot(0, 0), arc, pivot(1.1, 0.2)};
    const FindResult found = find_nearest_contact(pair, 0.4, 0.2);
    ASSERT_EQ(found.status, FindStatus::kFound);
    FollowedContact track = start_track(pair, found.at, found.branch);
    for (int k = 0; k <= 360; ++k) {
      const double u = 0.4 + k * kPi / 180;
      ASSERT_EQ(follow_to(track, u).status, TrackStatus::kOk) << u;
      const testing::ContactLaws laws(pair, track.at);
      EXPECT_TRUE(laws.broken.empty()) << R << " at " << u << ": " << laws.broken.front();
      // One Newton step in extended precision from the answer.
      const Vector2d c = Rotation<double>::from_angle(u) * Vector2d(0.2, 0.05);
      const auto gap = [&](long double q) {
        return distance_from_huge(c, pair.motion2.p_WO, q, R) - static_cast<long double>(0.3);
      };
      const long double q = track.at.q;
      const long double slope = (gap(q + 1e-6L) - gap(q - 1e-6L)) / 2e-6L;
      EXPECT_LE(std::abs(gap(q) / slope), 2e-15L) << R << " at " << u;
    }
  }
}

// A disc in a ring of nearly its own radius: the link ρ1 + ρ2 is as short as the clearance.
TEST(HardContacts, ADiscInARingWithLittlePlayTurnsAsItsDragLink) {
  for (const double play : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const double arm2 = 0.3 + 0.2 * play;
    const double distance = 0.4 * play;
    const ContactPair pair = {disc(0.3, 0, 1), pivot(0, 0), ring(arm2, 0, 1 + play), pivot(distance, 0)};
    const FourBar linkage{distance, 0.3, play, arm2, 0};
    const FourBarMotion start = four_bar_by_crank(linkage, {0.3, 1, 0}, AssemblyMode::kPlus);
    ASSERT_EQ(start.status, LinkageStatus::kOk);
    const Vector2d n = -unit_vector(start.theta3 + kPi);
    const Vector2d n_W = -n;  // c2 - c1 = (ρ1 + ρ2) n with ρ1 + ρ2 < 0
    const Vector2d p = 0.3 * unit_vector(0.3) + n_W;
    const int branch = velocity_per_q(pair.motion2, p).dot(n_W) > 0 ? 1 : -1;
    const ContactResult at = solve_contact(pair, 0.3, start.theta4, n_W, branch);
    ASSERT_EQ(at.status, ContactStatus::kOk) << play;
    FollowedContact track = start_track(pair, at.at, branch);
    int held = 0;
    for (int k = 1; k <= 720; ++k) {
      const double u = 0.3 + k * kPi / 180;
      if (follow_to(track, u).status != TrackStatus::kOk) continue;
      ++held;
      const FourBarMotion exact = four_bar_by_crank(linkage, {u, 1, 0}, AssemblyMode::kPlus);
      EXPECT_LE(std::abs(track.at.q - nearest_turn(exact.theta4, track.at.q)), 1e-14) << play << " at " << u;
      EXPECT_LE(std::abs(track.at.dq - exact.rates->omega4), 1e-14 / play) << play << " at " << u;
    }
    EXPECT_EQ(held, 720) << play;
  }
}

// Links 0.5, 0.3, 0.45, 0.4; the crank has a limit where links 3 and 4 are in line.
TEST(HardContacts, AStartAtTheLimitGoesInwardAndNotBeyond) {
  const ContactPair pair = {disc(0.3, 0, 0.2), pivot(0, 0), disc(-0.25, 0, 0.1), pivot(0.75, 0)};
  const FourBar linkage{0.75, 0.3, 0.3, 0.25, 0};
  const DriverRange range = four_bar_crank_range(linkage);
  ASSERT_EQ(range.reach, DriverReach::kRanges);
  const double limit = range.intervals[0].end;
  for (const double before : {1e-3, 1e-6, 1e-9, 1e-12, 0.0}) {
    const double u = limit - before;
    const FourBarMotion exact = four_bar_by_crank(linkage, {u, 1, 0}, AssemblyMode::kPlus);
    ASSERT_NE(exact.status, LinkageStatus::kNotAssemblable);
    const double q = exact.theta4 - kPi;
    const FindResult found = find_nearest_contact(pair, u, q);
    if (found.status != FindStatus::kFound) {
      EXPECT_LE(before, 1e-9);  // a grazing contact may be missed
      continue;
    }
    const testing::ContactLaws laws(pair, found.at);
    FollowedContact outward = start_track(pair, found.at, found.branch);
    const TrackResult lost = follow_to(outward, limit + 0.01);
    EXPECT_EQ(lost.status, TrackStatus::kNotAssemblable);
    ASSERT_TRUE(lost.limit.has_value());
    EXPECT_LE(std::abs(lost.limit->u - limit), 1e-12) << before;
    FollowedContact inward = start_track(pair, found.at, found.branch);
    const TrackResult held = follow_to(inward, limit - 0.2);
    if (held.status != TrackStatus::kOk) {
      EXPECT_LE(before, 1e-9);  // rounding decides which branch this is
      continue;
    }
    const double q_inward = inward.at.q;
    const FourBarMotion plus = four_bar_by_crank(linkage, {limit - 0.2, 1, 0}, AssemblyMode::kPlus);
    const FourBarMotion minus = four_bar_by_crank(linkage, {limit - 0.2, 1, 0}, AssemblyMode::kMinus);
    const double off = std::min(std::abs(q_inward - nearest_turn(plus.theta4 - kPi, q_inward)),
                                std::abs(q_inward - nearest_turn(minus.theta4 - kPi, q_inward)));
    EXPECT_LE(off, 1e-13) << before;
  }
}

// A parallelogram passes through its aligned positions as a parallelogram, also where a row falls on one.
TEST(HardContacts, AParallelogramStaysOneThroughItsAlignedPositions) {
  const ContactPair pair = {disc(0.2, 0, 0.3), pivot(0, 0), disc(0.2, 0, 0.25), pivot(0.55, 0)};
  for (const double first : {0.5, kPi / 6}) {
    const ContactResult at = solve_contact(pair, first, first, Vector2d::UnitX(), -1);
    const ContactResult other = solve_contact(pair, first, first, Vector2d::UnitX(), 1);
    const bool minus = at.status == ContactStatus::kOk && std::abs(at.at.q - first) < 1e-9;
    ASSERT_TRUE(minus || (other.status == ContactStatus::kOk && std::abs(other.at.q - first) < 1e-9));
    FollowedContact track = start_track(pair, minus ? at.at : other.at, minus ? -1 : 1);
    for (int k = 1; k <= 720; ++k) {
      const double u = first + k * kPi / 180;
      ASSERT_EQ(follow_to(track, u).status, TrackStatus::kOk) << u;
      const double share = std::abs(std::sin(u));
      EXPECT_LE(std::abs(track.at.q - u), std::min(1e-7, 1e-14 / share) + 1e-14) << u;
    }
  }
}

// The follower's disc turns about its own centre, so that the gap is constant. No contact with a motion may
// be reported.
TEST(HardContacts, ADiscAboutItsOwnCentreIsNoFollower) {
  for (const double distance : {0.49, 0.5, 0.51}) {
    const ContactPair pair = {disc(0.1, 0, 0.2), pivot(0, 0), disc(0, 0, 0.2), pivot(distance, 0)};
    const FindResult found = find_nearest_contact(pair, 0, 0.3);
    if (found.status == FindStatus::kFound) {
      EXPECT_LE(std::abs(found.at.gap_q), 1e-15);
    }
    const ContactResult solved = solve_contact(pair, 0, 0.3, Vector2d::UnitX(), 1);
    if (solved.status == ContactStatus::kOk) {
      EXPECT_LE(std::abs(solved.at.gap_q), 1e-15);
      EXPECT_LE((solved.at.p2_W - solved.at.p1_W).norm(), 1e-12);
    }
  }
}

TEST(HardContacts, ADriverAboutItsOwnCentreMovesNothing) {
  const ContactPair pair = {disc(0, 0, 0.2), pivot(0, 0), disc(-0.6, 0.1, 0.25), pivot(0.8, 0)};
  const FindResult found = find_nearest_contact(pair, 0, 0);
  ASSERT_EQ(found.status, FindStatus::kFound);
  FollowedContact track = start_track(pair, found.at, found.branch);
  for (int k = 1; k <= 36; ++k) {
    ASSERT_EQ(follow_to(track, k * kPi / 18).status, TrackStatus::kOk);
    EXPECT_LE(std::abs(track.at.q - found.at.q), 1e-14);
    EXPECT_LE(std::abs(track.at.dq), 1e-14);
    EXPECT_LE(std::abs(track.at.d2q), 1e-13);
  }
}

TEST(HardContacts, AGuessFarOffGivesAContactOrAReason) {
  testing::RandomPairs random(77);
  int solved = 0;
  for (int i = 0; i < 4000; ++i) {
    const testing::RandomCase one = random.next();
    const Vector2d n = unit_vector(random.between(-kPi, kPi));
    const int branch = random.pick(2) == 0 ? 1 : -1;
    const ContactResult result = solve_contact(one.pair, one.u, one.q, n, branch);
    if (result.status != ContactStatus::kOk) continue;
    ++solved;
    const testing::ContactLaws laws(one.pair, result.at);
    EXPECT_TRUE(laws.broken.empty()) << i << ": " << laws.broken.front();
    EXPECT_GE(branch * result.at.gap_q, 0) << i;
  }
  EXPECT_GT(solved, 400);
}

}  // namespace
}  // namespace higherpair
