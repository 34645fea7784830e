// A motion that runs back returns to where it began; one that has switched to another contact would not.
#include "contact/pair_follower.hpp"
#include "higherpair/contact/conic_contacts.hpp"
#include "higherpair/contact/critical_positions.hpp"
#include "random_pair.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

constexpr double kWay = 0.7;  // [rad], in one call
// At a smaller ∂gap/∂q, closer to a limit, rounding moves q by more than the tolerance of this test.
constexpr double kFarFromLimit = 1e-3;

// Follows every contact of the pair at u forward and back; returns how many were followed all the way.
int run_forth_and_back(const ContactPair& given, double u) {
  const ContactPair other = with_other_side(given);
  int count = 0;
  for (const CurveContact& contact : find_curve_contacts(given, u).contacts) {
    const ContactPair& pair = contact.opposed ? given : other;
    const double gap_q = contact.n_W.dot(velocity_per_q(pair.motion2, contact.p_W));
    const int branch = gap_q > 0 ? 1 : -1;
    const ContactResult start = solve_contact(pair, u, contact.q, contact.n_W, branch);
    if (contact.coincident || start.status != ContactStatus::kOk || std::abs(gap_q) < kFarFromLimit) {
      continue;
    }
    FollowedContact track = start_track(pair, start.at, branch);
    if (follow_to(track, u + kWay).status != TrackStatus::kOk) {
      continue;
    }
    EXPECT_EQ(follow_to(track, u).status, TrackStatus::kOk) << "q = " << contact.q;
    EXPECT_NEAR(track.at.q, start.at.q, 1e-9) << "u = " << u;
    ++count;
  }
  return count;
}

TEST(Reversal, EndsWhereTheMotionBegan) {
  int count = 0;
  for (unsigned number = 0; number < 144; ++number) {
    const testing::RandomPair random = testing::random_pair(number);
    SCOPED_TRACE(random.text);
    count += run_forth_and_back(random.pair, random.u);
  }
  EXPECT_GT(count, 150);
}

// Two contacts, one with a minimum and one with a maximum of the gap, pass each other at 1e-4 of q and 0.03
// of the normal. On the way back a step of 10° went from one to the other.
TEST(Reversal, TellsNeighbouringContactsApart) {
  const double u = 1.391678163948994;
  ContactPair pair;
  pair.curve1 = {CurveKind::kEllipse,
                 Side::kOutside,
                 {-2.0572566066436351, 0.042527029292307228},
                 unit_vector(-0.7609102862355847),
                 0.50818304004218595,
                 0.17512489469429388};
  pair.motion1.p_WO = {-0.24500515301133285, -0.81148306712113105};
  pair.curve2 = {CurveKind::kEllipse,
                 Side::kInside,
                 {1.6624879785331315, -0.10171093670205211},
                 unit_vector(3.033213288484121),
                 0.074639828215448276,
                 0.026042786664919732};
  pair.motion2 = {false,
                  {2.3113671498243731, -0.54626503789944891},
                  {0.89833836042211135, -0.0093441112850558561},
                  unit_vector(0.2769317140578811),
                  0.9685038163866091,
                  Rotation<double>::from_angle(0.9685038163866091)};
  EXPECT_EQ(run_forth_and_back(pair, u), 4);
}

}  // namespace
}  // namespace higherpair
