#include "circle_arrangements.hpp"
#include "contact/pair_follower.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::closed_form;
using testing::Exact;
using testing::MaybeExact;
using testing::RoundOrFlat;

struct Shapes {
  const char* name;
  bool flat1;
  double rho1;
  bool flat2;
  double rho2;
};

OneFreedom joint(bool turns, const Vector2d& p_WO, const Vector2d& p_BO, double direction, double theta) {
  OneFreedom freedom;
  freedom.turns = turns;
  freedom.p_WO = p_WO;
  freedom.p_BO = p_BO;
  freedom.direction_W = unit_vector(direction);
  freedom.theta = theta;
  freedom.R_WB = Rotation<double>::from_angle(theta);
  return freedom;
}

// Arms 0.13 and 0.37 on pivots 0.63 apart with a coupler of 0.48: a crank-rocker.
std::pair<RoundOrFlat, RoundOrFlat> bodies(const Shapes& shapes, bool turns1, bool turns2) {
  RoundOrFlat one{shapes.flat1, shapes.rho1, joint(turns1, {0.31, -0.17}, {0.02, -0.013}, 0.4, 0.23),
                  0.13 * unit_vector(0.7), unit_vector(0.3)};
  RoundOrFlat two{shapes.flat2, shapes.rho2, joint(turns2, {0.91, 0.02}, {-0.011, 0.05}, -0.2, -0.41),
                  0.37 * unit_vector(turns2 ? 1.9 : 0.6), unit_vector(2.8)};
  if (shapes.flat1) one.a_B = 0.05 * unit_vector(0.9);
  if (shapes.flat2) two.a_B = 0.07 * unit_vector(-0.4);
  return {one, two};
}

Vector2d common_normal(const RoundOrFlat& one, const RoundOrFlat& two, double u, double q) {
  if (one.flat) return one.normal(u);
  if (two.flat) return -two.normal(q);
  return (two.place(q) - one.place(u)) / (one.rho + two.rho);
}

// Distance of the closed form from its limit: below 0.15 the comparison would measure the loss of digits near
// the limit.
double share_of_lever(const RoundOrFlat& one, const RoundOrFlat& two, double u, double q) {
  const Vector2d n = common_normal(one, two, u, q);
  const Vector2d p = one.flat ? Vector2d(two.place(q) - two.rho * n) : Vector2d(one.place(u) + one.rho * n);
  const Vector2d v = velocity_per_q(two.freedom, p);
  return v.dot(n) / v.norm();
}

double expected_q(const ContactPair& pair, const Exact& exact, double near) {
  return pair.motion2.turns ? nearest_turn(exact.q, near) : exact.q;
}

void expect_motion_of_linkage(const Shapes& shapes, bool turns1, bool turns2, AssemblyMode mode) {
  const auto [one, two] = bodies(shapes, turns1, turns2);
  const ContactPair pair = {one.curve(), one.freedom, two.curve(), two.freedom};
  constexpr int kRows = 720;
  std::optional<FollowedContact> track;
  int compared = 0;
  for (int k = 0; k <= 2 * kRows; ++k) {
    const double u = turns1 ? 2 * kPi * k / kRows : 1.1 * (1.0 * k / kRows - 1);
    const MaybeExact exact = closed_form(one, two, u, mode);
    const double share = exact ? share_of_lever(one, two, u, exact->q) : 0;
    if (!(std::abs(share) > 0.15)) {
      track.reset();
      continue;
    }
    if (!track) {
      const int branch = share > 0 ? 1 : -1;
      const Vector2d n = common_normal(one, two, u, exact->q);
      const ContactResult start = solve_contact(pair, u, exact->q, n, branch);
      ASSERT_EQ(start.status, ContactStatus::kOk);
      track = start_track(pair, start.at, branch);
    } else {
      ASSERT_EQ(follow_to(*track, u).status, TrackStatus::kOk) << "at " << u;
    }
    const ContactPosition& at = track->at;
    // A tolerance of 1e-13 for good transmission, larger as the lever becomes smaller.
    const double tolerance = 1e-13 / std::abs(share);
    ASSERT_LE(std::abs(at.q - expected_q(pair, *exact, at.q)), tolerance * std::max(1.0, std::abs(at.q)))
        << u;
    ASSERT_LE(std::abs(at.dq - exact->dq), tolerance * (1 + std::abs(exact->dq))) << u;
    ASSERT_LE(std::abs(at.d2q - exact->d2q), tolerance / share / share * (1 + std::abs(exact->d2q))) << u;
    ++compared;
  }
  EXPECT_GT(compared, 200);
}

const Shapes kShapes[] = {{"DiscOnDisc", false, 0.31, false, 0.17},
                          {"DiscInRing", false, 0.11, false, -0.59},
                          {"RingAroundDisc", false, -0.59, false, 0.11},
                          {"PointOnDisc", false, 0, false, 0.48},
                          {"DiscOnPoint", false, 0.48, false, 0},
                          {"PointInRing", false, 0, false, -0.48},
                          {"RingAroundPoint", false, -0.48, false, 0},
                          {"DiscOnFace", false, 0.09, true, 0},
                          {"PointOnFace", false, 0, true, 0},
                          {"FaceOnDisc", true, 0, false, 0.12},
                          {"FaceOnPoint", true, 0, false, 0}};

TEST(CirclesAndFlats, MoveAsTheirEquivalentLinkageOverWholeTurns) {
  for (const Shapes& shapes : kShapes) {
    for (const bool turns1 : {false, true}) {
      for (const bool turns2 : {false, true}) {
        for (const AssemblyMode mode : {AssemblyMode::kPlus, AssemblyMode::kMinus}) {
          SCOPED_TRACE(std::string(shapes.name) + (turns1 ? ", driver turns" : ", driver slides") +
                       (turns2 ? ", follower turns" : ", follower slides") +
                       (mode == AssemblyMode::kPlus ? ", plus" : ", minus"));
          expect_motion_of_linkage(shapes, turns1, turns2, mode);
        }
      }
    }
  }
}

}  // namespace
}  // namespace higherpair
