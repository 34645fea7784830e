#include "contact/pair_follower.hpp"
#include "contact_laws.hpp"
#include "higherpair/contact/finder.hpp"
#include "random_pairs.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::RandomCase;
using testing::RandomPairs;

// A transformation of the plane: optionally mirrored in the x axis, then rotated, scaled and shifted.
struct Change {
  double scale = 1;
  double turn = 0;
  Vector2d move = Vector2d::Zero();
  bool mirror = false;

  [[nodiscard]] Vector2d direction(const Vector2d& v) const {
    const Vector2d seen = mirror ? Vector2d(v.x(), -v.y()) : v;
    return Rotation<double>::from_angle(turn) * seen;
  }
  [[nodiscard]] Vector2d point(const Vector2d& p) const { return scale * direction(p) + move; }
  [[nodiscard]] double angle_sign() const { return mirror ? -1 : 1; }

  // Body frames are mirrored and scaled but not rotated; instead a turning body's coordinate grows by `turn`.
  [[nodiscard]] Vector2d in_body(const Vector2d& v) const { return mirror ? Vector2d(v.x(), -v.y()) : v; }
  [[nodiscard]] Curve curve(const Curve& c) const {
    Curve changed = c;
    changed.vertex_B = scale * in_body(c.vertex_B);
    changed.axis_B = in_body(c.axis_B);
    changed.semi_latus = scale * c.semi_latus;
    return changed;
  }
  [[nodiscard]] OneFreedom freedom(const OneFreedom& f) const {
    OneFreedom changed = f;
    changed.p_WO = point(f.p_WO);
    changed.p_BO = scale * in_body(f.p_BO);
    changed.direction_W = direction(f.direction_W);
    changed.theta = angle_sign() * f.theta + turn;
    changed.R_WB = Rotation<double>::from_angle(changed.theta);
    return changed;
  }
  [[nodiscard]] ContactPair pair(const ContactPair& p) const {
    return {curve(p.curve1), freedom(p.motion1), curve(p.curve2), freedom(p.motion2)};
  }
  [[nodiscard]] double coordinate(const OneFreedom& f, double q) const {
    return f.turns ? angle_sign() * q + turn : scale * q;
  }
  [[nodiscard]] double rate_factor(const OneFreedom& f) const { return f.turns ? angle_sign() : scale; }
};

// Pairs that move well over the whole range, so that their answers differ by rounding only.
struct Case {
  RandomCase one;
  FollowedContact start;
};

constexpr int kRows = 40;

double degree_of(const RandomCase& one) {
  return (one.pair.motion1.turns ? 1.0 : one.size) * kPi / 180;
}

// Whether the track stays far from limits and conforming contacts over the range.
bool is_healthy(FollowedContact track, const RandomCase& one) {
  for (int k = 0; k <= kRows; ++k) {
    if (follow_to(track, one.u + k * degree_of(one)).status != TrackStatus::kOk) return false;
    const double lever = velocity_per_q(one.pair.motion2, track.at.p2_W).norm();
    const testing::ContactLaws laws(one.pair, track.at);
    const double extent = testing::length_scale(one.pair, track.at);
    if (!(std::abs(track.at.gap_q) > 0.1 * lever) || !(laws.conforming_ > 0.05L) || extent > 50 * one.size ||
        std::abs(track.at.rho1) + std::abs(track.at.rho2) > 1e3 * one.size) {
      return false;
    }
  }
  return true;
}

std::vector<Case> healthy_cases(unsigned seed, int count) {
  std::vector<Case> cases;
  RandomPairs random(seed);
  while (static_cast<int>(cases.size()) < count) {
    const RandomCase one = random.next();
    const FindResult found = find_nearest_contact(one.pair, one.u, one.q);
    if (found.status != FindStatus::kFound) continue;
    const FollowedContact track = start_track(one.pair, found.at, found.branch);
    if (is_healthy(track, one)) cases.push_back({one, track});
  }
  return cases;
}

double q_unit(const RandomCase& one) {
  return one.pair.motion2.turns ? 1 : one.size;
}

void expect_changed(const Case& c, const Change& change, double tolerance) {
  const ContactPair pair = change.pair(c.one.pair);
  const ContactPair& original = c.one.pair;
  const double u = change.coordinate(original.motion1, c.one.u);
  const FindResult found = find_nearest_contact(pair, u, change.coordinate(original.motion2, c.start.at.q));
  ASSERT_EQ(found.status, FindStatus::kFound);
  FollowedContact here = c.start;
  FollowedContact there = start_track(pair, found.at, found.branch);
  const double per_u = change.rate_factor(original.motion1);
  const double per_q = change.rate_factor(original.motion2);
  for (int k = 0; k <= kRows; ++k) {
    const double at = c.one.u + k * degree_of(c.one);
    ASSERT_EQ(follow_to(here, at).status, TrackStatus::kOk);
    ASSERT_EQ(follow_to(there, change.coordinate(original.motion1, at)).status, TrackStatus::kOk);
    const double q = change.coordinate(original.motion2, here.at.q);
    const double unit = std::abs(per_q) * q_unit(c.one);
    const double wound = std::abs(here.at.q) / q_unit(c.one);
    ASSERT_LE(std::abs(there.at.q - q), tolerance * unit * (1 + wound)) << k;
    const double rate = unit / std::abs(per_u) / (original.motion1.turns ? 1 : c.one.size);
    ASSERT_LE(std::abs(there.at.dq * per_u - per_q * here.at.dq) / std::abs(per_u),
              10 * tolerance * (rate + std::abs(there.at.dq)))
        << k;
    ASSERT_LE((there.at.n_W - change.direction(here.at.n_W)).norm(), 100 * tolerance) << k;
    ASSERT_LE((there.at.p1_W - change.point(here.at.p1_W)).norm(),
              100 * tolerance * (change.scale * c.one.size + change.move.norm()))
        << k;
  }
}

// Allows for levers down to 1/10 of their full length and for the rounding of coordinates up to 50 sizes
// away.
constexpr double kRounding = 2e-12;

TEST(Invariance, ScaledPairsMoveTheSameFromAMillionthToAMillion) {
  for (const Case& c : healthy_cases(101, 120)) {
    for (const double scale : {1e-6, 0.037, 1e6}) {
      SCOPED_TRACE(scale);
      expect_changed(c, {scale, 0, Vector2d::Zero(), false}, kRounding);
    }
  }
}

TEST(Invariance, TurnedAndMovedPairsMoveTheSame) {
  for (const Case& c : healthy_cases(102, 120)) {
    expect_changed(c, {1, 1.234, Vector2d(3.1 * c.one.size, -1.7 * c.one.size), false}, kRounding);
    expect_changed(c, {1, kPi / 2, Vector2d::Zero(), false}, kRounding);
  }
}

TEST(Invariance, MirroredPairsMoveMirrored) {
  for (const Case& c : healthy_cases(103, 120)) {
    expect_changed(c, {1, 0, Vector2d::Zero(), true}, kRounding);
    expect_changed(c, {2.5, -0.7, Vector2d(c.one.size, 0), true}, kRounding);
  }
}

// Driving by the follower gives the inverse function: du/dq = 1/q', d²u/dq² = -q''/q'³.
TEST(Invariance, ExchangedBodiesGiveTheInverseMotion) {
  int compared = 0;
  for (const Case& c : healthy_cases(104, 200)) {
    const ContactPair& pair = c.one.pair;
    const ContactPair exchanged = {pair.curve2, pair.motion2, pair.curve1, pair.motion1};
    const ContactPosition& at = c.start.at;
    const double gap_u = -velocity_per_q(pair.motion1, at.p1_W).dot(at.n_W);
    if (!(std::abs(gap_u) > 0.1 * velocity_per_q(pair.motion1, at.p1_W).norm())) continue;
    const Vector2d n = -at.n_W;
    const int branch = gap_u > 0 ? 1 : -1;
    const double nudge = 1e-3 * (pair.motion1.turns ? 1 : c.one.size);
    const ContactResult back = solve_contact(exchanged, at.q, at.u + nudge, n, branch);
    if (back.status != ContactStatus::kOk || back.step_n > 0.1) continue;
    ++compared;
    const double unit = pair.motion1.turns ? 1 : c.one.size;
    EXPECT_LE(std::abs(back.at.q - at.u), 20 * kRounding * unit * (1 + std::abs(at.u) / unit));
    EXPECT_LE(std::abs(back.at.dq * at.dq - 1), 20 * kRounding);
    const double inverse = -at.d2q / (at.dq * at.dq * at.dq);
    EXPECT_LE(std::abs(back.at.d2q - inverse),
              1e3 * kRounding * (std::abs(inverse) + back.at.dq * back.at.dq / unit + unit / q_unit(c.one)));
    EXPECT_LE((back.at.n_W + at.n_W).norm(), 20 * kRounding);
  }
  EXPECT_GT(compared, 100);
}

TEST(Invariance, FewRowsAndManyRowsAgreeWhereTheyCoincide) {
  for (const Case& c : healthy_cases(105, 60)) {
    FollowedContact few = c.start;
    FollowedContact many = c.start;
    for (int k = 1; k <= 5; ++k) {
      const double from = c.one.u + (k - 1) * 8 * degree_of(c.one);
      const double to = c.one.u + k * 8 * degree_of(c.one);
      ASSERT_EQ(follow_to(few, to).status, TrackStatus::kOk);
      for (int i = 1; i <= 1000; ++i) {
        ASSERT_EQ(follow_to(many, i == 1000 ? to : from + (to - from) * i / 1000).status, TrackStatus::kOk);
      }
      EXPECT_LE(std::abs(few.at.q - many.at.q), kRounding * (q_unit(c.one) + std::abs(few.at.q)));
      EXPECT_LE(std::abs(few.phi - many.phi), 100 * kRounding);
    }
  }
}

TEST(Invariance, GoingBackReturnsToTheStart) {
  for (const Case& c : healthy_cases(106, 120)) {
    FollowedContact track = c.start;
    ASSERT_EQ(follow_to(track, c.one.u + kRows * degree_of(c.one)).status, TrackStatus::kOk);
    ASSERT_EQ(follow_to(track, c.one.u).status, TrackStatus::kOk);
    EXPECT_LE(std::abs(track.at.q - c.start.at.q), kRounding * (q_unit(c.one) + std::abs(track.at.q)));
    EXPECT_LE(std::abs(track.phi - c.start.phi), 100 * kRounding);
    EXPECT_EQ(track.branch, c.start.branch);
  }
}

}  // namespace
}  // namespace higherpair
