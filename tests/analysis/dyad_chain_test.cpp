// Linkages in closed form: where their rows are proven, they are those of a run that follows the motion.
#include "analysis/chain_testing.hpp"
#include "analysis/random_cam.hpp"
#include "analysis/random_mechanism.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace higherpair::testing {
namespace {

using Quantity = ChainColumn::Quantity;

// A four-bar with pins at (0, 0) and (ground, 0), its crank along x.
Mechanism four_bar(double ground, double crank, double coupler, double rocker) {
  Builder b;
  const int first = b.body("crank", {0, 0}, 0);
  const double d = ground - crank;
  const double x = (d * d + coupler * coupler - rocker * rocker) / (2 * d);
  const Vector2d B(crank + x, std::sqrt(std::max(coupler * coupler - x * x, 0.0)));
  const int second = b.body("coupler", {crank, 0}, 0.3);
  const int third = b.body("rocker", {ground, 0}, -0.4);
  b.drive(b.revolute(0, first, {0, 0}));
  b.revolute(first, second, {crank, 0});
  b.revolute(second, third, B);
  b.revolute(third, 0, {ground, 0});
  return b.mechanism;
}

TEST(DyadChain, ProvenRowsOfRandomLinkagesAreThoseOfARun) {
  int proven = 0;
  int refused = 0;
  for (unsigned seed = 1; seed <= 1500 && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomMechanism random = RandomBuilder(seed, 4 + 2 * (seed % 3)).build();
    const double way = seed % 2 == 0 ? 1.3 : -0.4;
    const Outcome outcome = compare(random.mechanism, turn(random.start, way, 10 + seed % 40));
    proven += outcome == Outcome::kProven ? 1 : 0;
    refused += outcome == Outcome::kNotProven ? 1 : 0;
  }
  EXPECT_GT(proven, 150);
  EXPECT_GT(refused, 150);
}

TEST(DyadChain, FourBarsOfRandomLengthsAreProvenWhereTheyTurnFully) {
  Random random(7);
  int proven = 0;
  int cranks = 0;
  for (int k = 0; k < 400 && !HasFailure(); ++k) {
    SCOPED_TRACE("four-bar " + std::to_string(k));
    const double ground = random.between(0.5, 3), crank = random.between(0.3, 2);
    const double coupler = random.between(0.5, 3), rocker = random.between(0.5, 3);
    const Mechanism mechanism = four_bar(ground, crank, coupler, rocker);
    const Outcome outcome = compare(mechanism, turn(0.1, 2 * kPi, 181));
    // The crank turns fully where the distance of its end from the other pivot stays within the dyad's reach.
    const double far = coupler + rocker - (ground + crank);
    const double near = std::abs(ground - crank) - std::abs(coupler - rocker);
    const bool turns = far > 0.05 && near > 0.05;
    cranks += turns ? 1 : 0;
    proven += turns && outcome == Outcome::kProven ? 1 : 0;
    if (far < 0 || near < 0) {
      EXPECT_EQ(outcome, Outcome::kNotProven);
    }
  }
  EXPECT_GT(cranks, 30);
  EXPECT_GE(proven, 0.97 * cranks);
}

// The links are in line at 180 degrees, halfway between two rows, and out of reach within a window far
// narrower than a step: all rows themselves can be assembled.
TEST(DyadChain, LimitsBetweenTwoRowsAreNotPassedOver) {
  for (const double short_by : {1e-3, 1e-5, 1e-8, 0.0, -1e-8, -1e-5}) {
    SCOPED_TRACE(short_by);
    const Mechanism mechanism = four_bar(2, 0.7, 1.2, 1.5 - short_by);
    EXPECT_EQ(compare(mechanism, turn(0.05, 2 * kPi - 0.1, 60)), Outcome::kNotProven);
  }
  EXPECT_EQ(compare(four_bar(2, 0.7, 1.2, 1.6), turn(0.05, 2 * kPi - 0.1, 60)), Outcome::kProven);
}

TEST(DyadChain, AnglesGoOnOverManyTurnsBothWays) {
  const Mechanism mechanism = four_bar(1, 2, 3.5, 4);
  EXPECT_EQ(compare(mechanism, turn(0.2, 40 * kPi, 1441)), Outcome::kProven);
  EXPECT_EQ(compare(mechanism, turn(31.2, -20 * kPi, 721)), Outcome::kProven);
}

TEST(DyadChain, OtherDimensionsOfOneMechanismFollowEachOther) {
  Mechanism mechanism = four_bar(1, 2, 3.5, 4);
  const auto rows = turn(0, 2 * kPi, 91);
  const auto plan = make_plan(mechanism);
  auto chain = DyadChain::of(mechanism, *plan, rows, {{3, std::nullopt, Quantity::kAlpha}});
  ASSERT_TRUE(chain);
  ASSERT_TRUE(chain->solve(mechanism));
  const std::vector<double> first(chain->values(0).begin(), chain->values(0).end());
  const Mechanism other = four_bar(1.1, 2, 3.4, 4.2);
  ASSERT_TRUE(chain->solve(other));
  EXPECT_NE(chain->values(0)[17], first[17]);
  EXPECT_FALSE(chain->solve(four_bar(1.1, 2, 0.4, 0.5)));
  ASSERT_TRUE(chain->solve(mechanism));
  EXPECT_TRUE(std::equal(first.begin(), first.end(), chain->values(0).begin()));
}

TEST(DyadChain, LinksWithoutLengthAndFarOriginsAreNotProven) {
  Mechanism mechanism = four_bar(1, 2, 3.5, 4);
  const auto rows = turn(0, 2 * kPi, 91);
  const auto plan = make_plan(mechanism);
  auto chain = DyadChain::of(mechanism, *plan, rows, {{3, std::nullopt, Quantity::kX}});
  ASSERT_TRUE(chain);
  Mechanism point = mechanism;
  point.bodies[2].points[1].p_B = point.bodies[2].points[0].p_B;
  EXPECT_FALSE(chain->solve(point));
  Mechanism far = mechanism;
  for (NamedPoint& place : far.bodies[0].points) {
    place.p_B += Vector2d(1e6, 0);
  }
  EXPECT_FALSE(chain->solve(far));
  EXPECT_TRUE(chain->solve(mechanism));
}

// Computes every column alone, which leaves out what only the others need, and compares it bit by bit.
void compare_columns(const Mechanism& mechanism, const std::vector<DriverMotion>& rows) {
  const auto plan = make_plan(mechanism);
  const auto columns = all_columns(mechanism);
  auto chain = DyadChain::of(mechanism, *plan, rows, columns);
  if (!chain || !chain->solve(mechanism)) {
    return;
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    auto alone = DyadChain::of(mechanism, *plan, rows, {columns[i]});
    ASSERT_TRUE(alone && alone->solve(mechanism));
    for (std::size_t k = 0; k < rows.size(); ++k) {
      ASSERT_EQ(alone->values(0)[k], chain->values(i)[k]) << "row " << k << " of column " << i;
    }
  }
}

TEST(DyadChain, AColumnIsTheSameWhateverElseIsAskedFor) {
  constexpr std::array kDyads{RandomGroup::kRrr, RandomGroup::kRrp, RandomGroup::kRrpS, RandomGroup::kRpr,
                              RandomGroup::kRprS};
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const RandomMechanism made = RandomBuilder(seed, 8, kDyads).build();
    compare_columns(made.mechanism, turn(made.start, 0.4, 20));
    const Mechanism cam =
        RandomCam(seed, 1).build(seed % 2 == 0 ? CamShape::kDisc : CamShape::kOval, CamShape::kDisc);
    const bool turns = cam.joints[0].type == JointType::kRevolute;
    compare_columns(cam, turn(turns ? cam.bodies[1].guess_theta : 0.0, turns ? 0.3 : 0.05, 20));
  }
}

TEST(DyadChain, IsOnlyForOneDriverAndDyadsWithoutContactsAndEnds) {
  const auto is_chain = [](const Mechanism& mechanism) {
    const auto plan = make_plan(mechanism);
    return plan && DyadChain::of(mechanism, *plan, turn(0, 1, 9), {}).has_value();
  };
  Mechanism mechanism = four_bar(1, 2, 3.5, 4);
  EXPECT_TRUE(is_chain(mechanism));

  Builder b;
  const int crank = b.body("crank", {0, 0}, 0), rod = b.body("rod", {1, 0}, 0),
            piston = b.body("piston", {3, 0}, 0);
  b.drive(b.revolute(0, crank, {0, 0}));
  b.revolute(crank, rod, {1, 0});
  b.revolute(rod, piston, {3, 0});
  b.prismatic(0, piston, {3, 0}, {1, 0}, 2);
  EXPECT_TRUE(is_chain(b.mechanism));
  b.mechanism.joints.back().to = 4;
  EXPECT_FALSE(is_chain(b.mechanism));
}

}  // namespace
}  // namespace higherpair::testing
