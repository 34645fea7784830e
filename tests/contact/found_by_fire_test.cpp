// Cases in which random trials violated a law, reduced in size; each comment tells what went wrong.
#include "contact/pair_follower.hpp"
#include "contact_laws.hpp"
#include "higherpair/contact/conic_contacts.hpp"
#include "higherpair/contact/finder.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

OneFreedom slide(const Vector2d& p_WO, const Vector2d& p_BO, double direction, double theta) {
  OneFreedom freedom;
  freedom.turns = false;
  freedom.p_WO = p_WO;
  freedom.p_BO = p_BO;
  freedom.direction_W = unit_vector(direction);
  freedom.theta = theta;
  freedom.R_WB = Rotation<double>::from_angle(theta);
  return freedom;
}

OneFreedom pivot(const Vector2d& p_WO, const Vector2d& p_BO) {
  OneFreedom freedom;
  freedom.p_WO = p_WO;
  freedom.p_BO = p_BO;
  return freedom;
}

Curve hyperbola(const Vector2d& vertex, const std::array<double, 2>& semi_axes, double angle) {
  Curve curve = make_hyperbola({0, 0}, semi_axes, angle).value();
  curve.vertex_B = vertex;
  return curve;
}

// The branches touch a million times farther out than the smaller curve is large. There the normal determines
// the point on it only to within metres; the last step was rejected as a whole, and the two points stayed
// that far apart.
TEST(FoundByFire, BranchesThatTouchFarOutDoMeet) {
  const ContactPair pair = {
      hyperbola({-3.3203, -1.6089}, {3.6869, 3.0762}, -2.6931),
      slide({-0.0028019, 0.016887}, {-0.011608, -0.0094738}, 1.9888, 2.878),
      hyperbola({-0.00049555, 0.015634}, {0.0093452, 0.0084029}, 2.9339),
      pivot({0.016513, 0.021943}, {-0.017182, -0.014013}),
  };
  int far = 0;
  for (const CurveContact& contact : find_curve_contacts(pair, 0.0085129).contacts) {
    if (!contact.free || contact.branch == 0) {
      continue;
    }
    const ContactResult solved = solve_contact(pair, 0.0085129, contact.q, contact.n_W, contact.branch);
    ASSERT_EQ(solved.status, ContactStatus::kOk);
    const testing::ContactLaws laws(pair, solved.at);
    EXPECT_TRUE(laws.broken.empty()) << contact.q << ": " << laws.broken.front();
    EXPECT_LE((solved.at.p1_W - contact.p_W).norm(), 1e-3 * contact.p_W.norm());
    far += contact.p_W.norm() > 1e4 ? 1 : 0;
  }
  EXPECT_EQ(far, 1);
}

// Two parabolas that are equal to within 5e-9: where their axes are parallel they touch at infinity. Rounding
// turned this into contacts at 1e55 m, and the follower was placed there.
TEST(FoundByFire, NearlyEqualParabolasDoNotTouchAtInfinity) {
  const double rotation = 1.8035532772115683;
  const ContactPair pair = {
      make_parabola({-7.5e-05, 0.0001}, 0.021850752, rotation).value(),
      slide({0.00017, 0.000173}, {-5.9e-05, 3e-05}, -1.1191954, -1.1191954),
      make_parabola({-7.5e-05, 0.0001}, 0.0218507521, rotation, Side::kOutside).value(),
      pivot({-0.000166, 0}, {-0.000102, -0.00011}),
  };
  for (const CurveContact& contact : find_curve_contacts(pair, -8e-06).contacts) {
    EXPECT_LE(contact.p_W.norm(), 1e6);
    EXPECT_FALSE(contact.free);
  }
  EXPECT_EQ(find_nearest_contact(pair, -8e-06, 0).status, FindStatus::kNoContact);
}

// A small ellipse in a large ring, just before a limit: the contact of the other branch is two thousandths of
// the mechanism's size away. The position between the two was reported as a crossing of branches, although
// nothing touches there.
TEST(FoundByFire, TwoContactsNextToALimitAreNotACrossing) {
  const ContactPair pair = {
      make_ellipse({0.013681, -0.01822}, {0.002, 0.000462}, -1.416).value(),
      slide({-0.012538, 0.033075}, {-0.03623, -0.04004}, 1.29363, 0.2751),
      make_circle({0.00974, -0.005153}, 0.115812, Side::kOutside).value(),
      slide({0.020287, 0.079704}, {0.009, -0.027338}, 1.9687, 2),
  };
  const double u = 0.142772;
  const FindResult found = find_nearest_contact(pair, u, 0.1);
  ASSERT_EQ(found.status, FindStatus::kFound);
  for (const double step : {-0.0001, -0.0002, -0.000285, -0.0003, -0.0004}) {
    FollowedContact track = start_track(pair, found.at, found.branch);
    const bool held = follow_to(track, u + step).status == TrackStatus::kOk;
    const auto list = find_curve_contacts(pair, u + step).contacts;
    const bool there = std::any_of(list.begin(), list.end(), [&](const CurveContact& contact) {
      return contact.free && contact.branch == found.branch;
    });
    EXPECT_EQ(held, there) << step;
    if (held) {
      const testing::ContactLaws laws(pair, track.at);
      EXPECT_TRUE(laws.broken.empty()) << step << ": " << laws.broken.front();
      EXPECT_EQ(track.branch, found.branch) << step;
    }
  }
}

// For a face and a slide the conditions are linear, so that one step leads to the contact from anywhere. But
// the step carried along the rounding of the position where it began, here 10⁻⁷ of the curve.
TEST(FoundByFire, AStepFromFarAwayDoesNotBringItsRoundingAlong) {
  const ContactPair pair = {
      make_line({0, 0}, unit_vector(1.30777)).value(),
      pivot({35000, 0}, {0, 20000}),
      make_parabola({2000, 6810}, 300, 1).value(),
      slide({13000, -20000}, {9660, -20000}, -1.2, -0.01),
  };
  const double u = -1.3296;
  for (const double q : {0.0, 1e6, -1e9, 1e12}) {
    const ContactResult solved = solve_contact(pair, u, q, Vector2d::UnitX(), 1);
    const ContactResult other = solve_contact(pair, u, q, Vector2d::UnitX(), -1);
    ASSERT_TRUE(solved.status == ContactStatus::kOk || other.status == ContactStatus::kOk) << q;
    const ContactPosition& at = solved.status == ContactStatus::kOk ? solved.at : other.at;
    const testing::ContactLaws laws(pair, at);
    EXPECT_TRUE(laws.broken.empty()) << q << ": " << laws.broken.front();
  }
}

// The ellipse turns about its centre, so that the ring hardly moves while the normal runs round the ellipse;
// on the ellipse's flat side the two conform, and the contact jumps. Steps were compared with the prediction
// of the ring's motion only, and a long one missed the jump.
TEST(FoundByFire, AJumpOfTheNormalAloneIsALimit) {
  const ContactPair pair = {
      make_ellipse({0, 0}, {0.00257, 0.000325}, 0.6986).value(),
      pivot({0.00259, 0.00177}, {0, 0}),
      make_circle({-0.000822, -0.000575}, 0.01537, Side::kOutside).value(),
      slide({-0.000686, -0.00106}, {0.00107, 0.000138}, -1.734, 0.847),
  };
  const double u = 2.0208;
  const FindResult found = find_nearest_contact(pair, u, 0.0093);
  ASSERT_EQ(found.status, FindStatus::kFound);
  for (const double step : {0.001, 0.01, 0.03, 0.1}) {
    FollowedContact track = start_track(pair, found.at, found.branch);
    bool lost = false;
    for (int k = 1; k * step <= 0.3 && !lost; ++k) {
      lost = follow_to(track, u + k * step).status != TrackStatus::kOk;
    }
    EXPECT_TRUE(lost) << step;
    // It ends where the curvatures are opposite.
    EXPECT_NEAR(track.at.rho1 / -track.at.rho2, 1, 1e-4) << step;
  }
}

// Far from the contact the second-order part of a Newton step may just cancel the first; the step was small
// then and taken for the last one. A disc (radius 1.3, centre 2 from its pivot) comes down on a face: gap = 2
// sin q - 1; the step is 0 where gap · 2 sin q = 2 (2 cos q)².
TEST(FoundByFire, AStepThatItsSecondOrderUndoesIsNotTheLast) {
  const ContactPair pair = {make_line({0, 0}, {0, 1}).value(), slide({0, 0}, {0, 0}, 0, 0),
                            make_circle({2, 0}, 1.3).value(), pivot({0, 0.3}, {0, 0})};
  const double undone = std::asin((0.5 + std::sqrt(24.25)) / 6);
  for (int k = -20; k <= 20; ++k) {
    const ContactResult result = solve_contact(pair, 0, undone + 1e-10 * k, Vector2d::UnitY(), 1);
    ASSERT_EQ(result.status, ContactStatus::kOk);
    EXPECT_NEAR(result.at.q, kPi / 6, 1e-15);
  }
}

// A point slides along y = r - e across a disc of radius r whose centre turns on a circle of radius e. When
// the disc is lowest, v = 0, it just touches the line, and the branches cross smoothly: x = e sin v ± √(2e)
// sin(v/2) √(2r - 2e sin²(v/2)). The rates there were means of those on both sides.
TEST(FoundByFire, RatesAtACrossingAreThoseOfTheSmoothMotion) {
  const double e = 0.3;
  const double r = 0.45;
  const ContactPair pair = {make_circle({0, e}, r).value(), pivot({0, 0}, {0, 0}), make_point({0, 0}).value(),
                            slide({0, r - e}, {0, 0}, 0, 0)};
  const double v = -0.4;
  for (const int sign : {1, -1}) {
    const double half = std::sin(v / 2);
    const double x =
        e * std::sin(v) + sign * std::sqrt(2 * e) * half * std::sqrt(2 * r - 2 * e * half * half);
    const FindResult found = find_nearest_contact(pair, kPi + v, x);
    ASSERT_EQ(found.status, FindStatus::kFound);
    ASSERT_NEAR(found.at.q, x, 1e-14);
    FollowedContact track = start_track(pair, found.at, found.branch);
    ASSERT_EQ(follow_to(track, kPi).status, TrackStatus::kOk);
    const double rate = e + sign * std::sqrt(e * r);
    EXPECT_NEAR(track.at.q, 0, 1e-13);
    EXPECT_NEAR(track.at.dq, rate, 1e-10);
    EXPECT_NEAR(track.at.d2q, 0, 1e-6);
    // Speed of the point relative to the disc's material there, which moves by ω × p.
    const double sliding = -(rate + (r - e));
    EXPECT_NEAR(track.at.sliding, sliding, 1e-10);
  }
}

// A search for an event met a position that cannot be assembled, and then asked for one that is NaN.
TEST(FoundByFire, NoNumberIsNoPlaceToGo) {
  const ContactPair pair = {make_circle({0.1, 0.02}, 0.3).value(), pivot({0, 0}, {0, 0}),
                            make_circle({-0.6, 0.1}, 0.25).value(), pivot({0.8, 0}, {0, 0})};
  const FindResult found = find_nearest_contact(pair, 0.2, 0);
  ASSERT_EQ(found.status, FindStatus::kFound);
  for (const double u : {NAN, INFINITY, -INFINITY}) {
    FollowedContact track = start_track(pair, found.at, found.branch);
    EXPECT_EQ(follow_to(track, u).status, TrackStatus::kNotAssemblable);
    EXPECT_EQ(track.at.u, 0.2);
  }
}

// Where a step of the driver is lost in the rounding of its position, steps make no progress.
TEST(FoundByFire, StepsThatLeadNowhereEnd) {
  const ContactPair pair = {make_circle({0.1, 0.02}, 0.3).value(), pivot({0, 0}, {0, 0}),
                            make_circle({-0.6, 0.1}, 0.25).value(), pivot({0.8, 0}, {0, 0})};
  const double far = 1e17;
  const FindResult found = find_nearest_contact(pair, far, 0);
  ASSERT_EQ(found.status, FindStatus::kFound);
  FollowedContact track = start_track(pair, found.at, found.branch);
  EXPECT_EQ(follow_to(track, far + 160).status, TrackStatus::kNotAssemblable);
  EXPECT_EQ(track.at.u, far);
}

}  // namespace
}  // namespace higherpair
