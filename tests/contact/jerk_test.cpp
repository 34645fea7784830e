#include "contact/freedoms.hpp"
#include "contact/pair_follower.hpp"
#include "contact/pair_jerk.hpp"
#include "contact_laws.hpp"
#include "higherpair/contact/finder.hpp"
#include "higherpair/contact/rolling.hpp"
#include "linkage/four_bar_motion.hpp"
#include "random_pairs.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::pivot;
using testing::RandomCase;
using testing::RandomPairs;

// Third derivative of sqrt(m) from m and its derivatives.
double third_derivative_of_root(double m, double m1, double m2, double m3) {
  const double s = std::sqrt(m);
  const double s1 = m1 / (2 * s);
  const double s2 = (m2 - 2 * s1 * s1) / (2 * s);
  return (m3 - 6 * s1 * s2) / (2 * s);
}

// A flat face on an ellipse 2 x 1 about its centre: s² = a² sin²u + b² cos²u. The frozen linkage is a Scotch
// yoke whose pin is s' beside the pivot, so that its third derivative is -s'.
TEST(Jerk, OfAFlatFaceOnAnEllipseIsThatOfItsSupport) {
  OneFreedom slide;
  slide.turns = false;
  slide.direction_W = Vector2d::UnitY();
  const ContactPair pair = {make_ellipse(Vector2d::Zero(), {2, 1}, 0).value(), pivot(0, 0),
                            make_line(Vector2d::Zero(), Vector2d(0, -1)).value(), slide};
  for (const double degrees : {15.0, 37.0, 141.0, -63.0}) {
    const double u = degrees * kPi / 180;
    const double m = 4 * std::sin(u) * std::sin(u) + std::cos(u) * std::cos(u);
    const double third =
        third_derivative_of_root(m, 3 * std::sin(2 * u), 6 * std::cos(2 * u), -12 * std::sin(2 * u));
    const ContactResult result = solve_contact(pair, u, std::sqrt(m), Vector2d::UnitY(), 1);
    ASSERT_EQ(result.status, ContactStatus::kOk);
    const auto jerk = slipping_jerk(pair, result.at);
    ASSERT_TRUE(jerk && jerk->linkage_d3q);
    EXPECT_LE(std::abs(jerk->d3q - third), 1e-13) << degrees;
    EXPECT_LE(std::abs(*jerk->linkage_d3q + 3 * std::sin(2 * u) / (2 * std::sqrt(m))), 1e-14) << degrees;
  }
}

// The assembly mode in which link 4 is at θ4.
AssemblyMode mode_at(const FourBar& linkage, double theta2, double theta4) {
  const auto distance = [&](AssemblyMode mode) {
    return std::abs(nearest_turn(four_bar_by_crank(linkage, {theta2, 1, 0}, mode).theta4 - theta4, 0));
  };
  return distance(AssemblyMode::kPlus) < distance(AssemblyMode::kMinus) ? AssemblyMode::kPlus
                                                                        : AssemblyMode::kMinus;
}

struct Difference {
  double value = NAN;
  double error = INFINITY;
};

// d³θ4/dθ2³ of the four-bar between pivots and centres of curvature, from differences of θ4'' with two
// widths.
Difference four_bar_jerk(const ContactPair& pair, const ContactPosition& at) {
  const Vector2d O1 = pair.motion1.p_WO;
  const Vector2d O2 = pair.motion2.p_WO;
  const Vector2d arm1 = at.p1_W - at.rho1 * at.n_W - O1;
  const Vector2d arm2 = at.p2_W + at.rho2 * at.n_W - O2;
  const FourBar linkage = {(O2 - O1).norm(), arm1.norm(), std::abs(at.rho1 + at.rho2), arm2.norm(),
                           angle_of(O2 - O1)};
  const AssemblyMode mode = mode_at(linkage, angle_of(arm1), angle_of(arm2));
  const auto slope = [&](double h) {
    const auto alpha = [&](double d) {
      const FourBarMotion motion = four_bar_by_crank(linkage, {angle_of(arm1) + d, 1, 0}, mode);
      return motion.rates ? motion.rates->alpha4 : NAN;
    };
    return (8 * (alpha(h) - alpha(-h)) - (alpha(2 * h) - alpha(-2 * h))) / (12 * h);
  };
  const double wide = slope(1e-3);
  const double narrow = slope(5e-4);
  return {(16 * narrow - wide) / 15, std::abs(narrow - wide)};
}

// Ellipses with a = 1, e = 1/2 about foci 2 apart: dq/du = -r/(2 - r), r = p/(1 + e cos u), p = 1 - e².
TEST(Jerk, OfEllipsesRollingAboutTheirFociIsThatOfTheRatioOfRadii) {
  const double e = 0.5;
  const double p = 1 - e * e;
  const Curve ellipse = make_ellipse(Vector2d(-e, 0), {1, std::sqrt(p)}, 0).value();
  const ContactPair pair = {ellipse, pivot(0, 0), ellipse, pivot(2, 0)};
  RollingTrack track;
  ASSERT_LE(start_rolling(track, pair, 0, 0, Vector2d::UnitX()).mismatch, 1e-14);
  for (const double degrees : {0.0, 20.0, 45.0, 110.0, 180.0, 301.0}) {
    const double u = degrees * kPi / 180;
    ASSERT_TRUE(roll_to(track, u).converged);
    // dq/du = -p/D with D = 2 + 2 e cos u - p.
    const double D = 2 + 2 * e * std::cos(u) - p;
    const double D1 = -2 * e * std::sin(u);
    const double third = p * (-2 * e * std::cos(u) / (D * D) - 2 * D1 * D1 / (D * D * D));
    const PairJerk jerk = rolling_jerk(pair, track.at);
    EXPECT_LE(std::abs(jerk.d3q - third), 1e-12) << degrees;
    // Where the apsides meet, all links of the linkage are in line.
    const bool in_line = std::abs(std::sin(u)) < 1e-9;
    EXPECT_EQ(jerk.linkage_d3q.has_value(), !in_line) << degrees;
    if (jerk.linkage_d3q) {
      EXPECT_LE(std::abs(*jerk.linkage_d3q - four_bar_jerk(pair, track.at).value), 1e-7) << degrees;
      EXPECT_GT(std::abs(*jerk.linkage_d3q - third), 0.05) << degrees;
    }
  }
}

TEST(Jerk, OfDiscsRollingAboutTheirCentresIsNone) {
  const ContactPair pair = {make_circle(Vector2d::Zero(), 0.031).value(), pivot(0, 0),
                            make_circle(Vector2d::Zero(), 0.0127).value(), pivot(0.0437, 0)};
  RollingTrack track;
  ASSERT_LE(start_rolling(track, pair, 0.2, 0.7, Vector2d::UnitX()).mismatch, 1e-16);
  ASSERT_TRUE(roll_to(track, 1.2).converged);
  EXPECT_LE(std::abs(rolling_jerk(pair, track.at).d3q), 1e-12);
}

// Random pairs well away from limits.
struct Found {
  RandomCase one;
  FollowedContact track;
};

std::optional<Found> next_healthy(RandomPairs& random) {
  const RandomCase one = random.next();
  const FindResult found = find_nearest_contact(one.pair, one.u, one.q);
  if (found.status != FindStatus::kFound) {
    return std::nullopt;
  }
  const ContactPosition& at = found.at;
  const double lever = velocity_per_q(one.pair.motion2, at.p2_W).norm();
  const testing::ContactLaws laws(one.pair, at);
  const bool healthy = std::abs(at.gap_q) > 0.1 * lever && laws.conforming_ > 0.05L &&
                       testing::length_scale(one.pair, at) < 50 * one.size;
  return healthy ? std::optional(Found{one, start_track(one.pair, at, found.branch)}) : std::nullopt;
}

// d/du of d²q/du² over the five points u - 2h … u + 2h, combined from two widths.
Difference jerk_by_difference(const Found& found, double h) {
  double slopes[2];
  for (int i = 0; i < 2; ++i, h /= 2) {
    double d2q[4];
    for (int k = 0; k < 4; ++k) {
      FollowedContact track = found.track;
      const double steps[] = {-2, -1, 1, 2};
      if (follow_to(track, found.track.at.u + steps[k] * h).status != TrackStatus::kOk) {
        return {};
      }
      d2q[k] = track.at.d2q;
    }
    slopes[i] = (8 * (d2q[2] - d2q[1]) - (d2q[3] - d2q[0])) / (12 * h);
  }
  return {(16 * slopes[1] - slopes[0]) / 15, std::abs(slopes[1] - slopes[0])};
}

TEST(Jerk, OfRandomPairsIsTheDifferenceOfTheirAccelerations) {
  RandomPairs random(20611);
  int compared = 0;
  int unlike_linkage = 0;
  for (int i = 0; i < 500; ++i) {
    const auto found = next_healthy(random);
    if (!found) {
      continue;
    }
    const double u_unit = found->one.pair.motion1.turns ? 1 : found->one.size;
    const double q_unit = found->one.pair.motion2.turns ? 1 : found->one.size;
    const Difference difference = jerk_by_difference(*found, 2e-3 * u_unit);
    const auto jerk = slipping_jerk(found->one.pair, found->track.at);
    ASSERT_TRUE(jerk) << i;
    // The rounding of d²q, about 1e-13 of it and of 1, divided by h.
    const double unit = q_unit / (u_unit * u_unit * u_unit);
    const double rounding = 1e-9 * (unit + std::abs(found->track.at.d2q) / u_unit);
    if (!(difference.error < 1e-5 * (std::abs(difference.value) + unit))) {
      continue;
    }
    ++compared;
    EXPECT_LE(std::abs(jerk->d3q - difference.value), difference.error + rounding) << i;
    unlike_linkage += std::abs(jerk->d3q - *jerk->linkage_d3q) > 1e-3 * std::abs(jerk->d3q) ? 1 : 0;
  }
  EXPECT_GT(compared, 60);
  EXPECT_GT(unlike_linkage, 20);
}

TEST(Jerk, OfTheFrozenLinkageIsThatOfItsFourBar) {
  RandomPairs random(831);
  int compared = 0;
  for (int i = 0; i < 900; ++i) {
    const auto found = next_healthy(random);
    if (!found) {
      continue;
    }
    const ContactPair& pair = found->one.pair;
    const ContactPosition& at = found->track.at;
    const bool four_bar = pair.motion1.turns && pair.motion2.turns && pair.curve1.kind != CurveKind::kLine &&
                          pair.curve2.kind != CurveKind::kLine;
    if (!four_bar) {
      continue;
    }
    const auto jerk = slipping_jerk(pair, at);
    ASSERT_TRUE(jerk && jerk->linkage_d3q);
    const Difference difference = four_bar_jerk(pair, at);
    // Near a limit of the linkage differences are useless.
    if (!(difference.error < 1e-6 * (1 + std::abs(difference.value)))) {
      continue;
    }
    ++compared;
    EXPECT_LE(std::abs(*jerk->linkage_d3q - difference.value),
              difference.error + 1e-8 * (1 + std::abs(at.d2q) + std::abs(difference.value)))
        << i;
  }
  EXPECT_GT(compared, 15);
}

// Mirrored in the x axis and scaled.
ContactPair mirrored(ContactPair pair, double scale) {
  const auto flip = [&](Vector2d& v, double s) { v = Vector2d(s * v.x(), -s * v.y()); };
  for (Curve* curve : {&pair.curve1, &pair.curve2}) {
    flip(curve->vertex_B, scale);
    flip(curve->axis_B, 1);
    curve->semi_latus *= scale;
  }
  for (OneFreedom* motion : {&pair.motion1, &pair.motion2}) {
    flip(motion->p_WO, scale);
    flip(motion->p_BO, scale);
    flip(motion->direction_W, 1);
    motion->theta = -motion->theta;
    motion->R_WB = motion->R_WB.inverse();
  }
  return pair;
}

TEST(Jerk, FollowsScaledAndMirroredCopies) {
  RandomPairs random(77);
  int compared = 0;
  for (int i = 0; i < 150; ++i) {
    const auto found = next_healthy(random);
    if (!found) {
      continue;
    }
    ++compared;
    const double scale = i % 2 == 0 ? 0x1p20 : 0x1p-17;
    const ContactPair& pair = found->one.pair;
    const ContactPosition& at = found->track.at;
    const auto per = [&](const OneFreedom& motion) { return motion.turns ? -1.0 : scale; };
    const double f1 = per(pair.motion1);
    const double f2 = per(pair.motion2);
    const ContactPair copy = mirrored(pair, scale);
    const ContactResult result = solve_contact(copy, f1 * at.u, f2 * at.q, Vector2d(at.n_W.x(), -at.n_W.y()),
                                               found->track.branch * (pair.motion2.turns ? -1 : 1));
    ASSERT_EQ(result.status, ContactStatus::kOk) << i;
    const double factor = f2 / (f1 * f1 * f1);
    const auto jerk = slipping_jerk(pair, at);
    const auto copied = slipping_jerk(copy, result.at);
    ASSERT_TRUE(jerk && copied && copied->linkage_d3q);
    const double unit =
        (pair.motion2.turns ? 1 : found->one.size) / std::pow(pair.motion1.turns ? 1 : found->one.size, 3);
    const double tolerance = 1e-8 * (unit + std::abs(jerk->d3q) + std::abs(*jerk->linkage_d3q));
    EXPECT_LE(std::abs(copied->d3q / factor - jerk->d3q), tolerance) << i;
    EXPECT_LE(std::abs(*copied->linkage_d3q / factor - *jerk->linkage_d3q), tolerance) << i;
  }
  EXPECT_GT(compared, 20);
}

TEST(Jerk, IsNotGivenWhereNothingHoldsTheFollower) {
  // The pivot of the follower lies on the common normal.
  const ContactPair pair = {make_circle(Vector2d(1, 0), 0.5).value(), pivot(0, 0),
                            make_circle(Vector2d(-1, 0), 0.5).value(), pivot(3, 0)};
  ContactPosition at;
  at.n_W = Vector2d::UnitX();
  at.p1_W = at.p2_W = Vector2d(1.5, 0);
  at.rho1 = at.rho2 = 0.5;
  EXPECT_FALSE(slipping_jerk(pair, at));
}

}  // namespace
}  // namespace higherpair
