// Forces of linkages and cams, computed for many rows at a time, are those of a run that follows the motion
// and solves its balance by factorised matrices.
#include "analysis/random_cam.hpp"
#include "analysis/random_mechanism.hpp"
#include "dynamics/chain_agreement.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair::testing {
namespace {

using Quantity = ChainColumn::Quantity;

constexpr std::array kDyads{RandomGroup::kRrr, RandomGroup::kRrp, RandomGroup::kRrpS, RandomGroup::kRpr,
                            RandomGroup::kRprS};

struct Counts {
  int proven = 0;
  ChainErrors worst;
};

Counts compare_many(std::span<const RandomGroup> groups, std::size_t most_bodies, unsigned count) {
  Counts counts;
  for (unsigned seed = 1; seed <= count; ++seed) {
    RandomMechanism made = RandomBuilder(seed, most_bodies, groups).build();
    Random random(seed + 1000);
    add_random_loads(made.mechanism, random);
    const ChainAgreement agrees =
        agreement(made.mechanism, turn(made.start, seed % 2 == 0 ? 0.9 : -0.4, 10 + seed % 40), true);
    EXPECT_NE(agrees.outcome, Outcome::kNoChain) << "seed " << seed;
    EXPECT_EQ(agrees.broken, "") << "seed " << seed;
    counts.proven += agrees.outcome == Outcome::kProven ? 1 : 0;
    const auto see = [](double& worst, double error) { worst = error <= worst ? worst : error; };
    see(counts.worst.second_rate, agrees.errors.second_rate);
    see(counts.worst.force, agrees.errors.force);
  }
  return counts;
}

// Errors are relative to the largest force at a joint, in units of its last place; sines of dyads are at
// least 0.02.
TEST(ChainForces, OfEveryDyadAreThoseOfARun) {
  for (const RandomGroup group : kDyads) {
    SCOPED_TRACE(static_cast<int>(group));
    const Counts counts = compare_many(std::array{group}, 4, 300);
    EXPECT_GT(counts.proven, 100);
    EXPECT_AT_MOST(counts.worst.force, 1000);
  }
}

TEST(ChainForces, OfChainsOfDyadsAreThoseOfARun) {
  const Counts counts = compare_many(kDyads, 8, 400);
  EXPECT_GT(counts.proven, 60);
  EXPECT_AT_MOST(counts.worst.force, 2000);
}

// A slider-crank with its pins at (0, 0) and on the x axis and its crank upright; a force acts on the piston.
struct Press {
  double r = 0.05, l = 0.17, force = 310;

  [[nodiscard]] Mechanism mechanism() const {
    Builder b;
    const double x = std::sqrt(l * l - r * r);
    const int crank = b.body("crank", {0, 0}, kPi / 2);
    const int rod = b.body("rod", {0, r}, 0.2);
    const int piston = b.body("piston", {x, 0}, 0);
    b.drive(b.revolute(0, crank, {0, 0}));
    b.revolute(crank, rod, {0, r});
    b.revolute(rod, piston, {x, 0});
    b.prismatic(0, piston, {x, 0}, {1, 0}, x);
    b.mechanism.loads.push_back({"gas", piston, Vector2d(0.02, 0.013), Vector2d(-force, 0), 0, {}});
    return b.mechanism;
  }
};

TEST(ChainForces, HoldAForceOnASliderByTheTorqueOfTheTextbook) {
  const Press press;
  const auto rows = turn(kPi / 2, 2 * kPi, 73);
  const Mechanism mechanism = press.mechanism();
  auto chain = DyadChain::of(mechanism, *make_plan(mechanism), rows,
                             {{0, std::nullopt, Quantity::kEffort},
                              {0, std::nullopt, Quantity::kEffortByPower},
                              {2, std::nullopt, Quantity::kForceX},
                              {2, std::nullopt, Quantity::kForceY},
                              {3, std::nullopt, Quantity::kForceX},
                              {3, std::nullopt, Quantity::kForceY},
                              {3, std::nullopt, Quantity::kMoment}});
  ASSERT_TRUE(chain);
  ASSERT_TRUE(chain->solve(mechanism));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double theta = rows[k].position;
    const double phi = std::asin(press.r / press.l * std::sin(theta));
    const double torque = -press.force * press.r * std::sin(theta + phi) / std::cos(phi);
    ASSERT_NEAR(chain->values(0)[k], torque, 1e-13);
    ASSERT_NEAR(chain->values(1)[k], torque, 1e-13);
    // The rod is a two-force member.
    ASSERT_NEAR(chain->values(2)[k], press.force, 1e-12);
    ASSERT_NEAR(chain->values(3)[k], -press.force * std::tan(phi), 1e-12);
    ASSERT_EQ(chain->values(4)[k], 0);
    ASSERT_NEAR(chain->values(5)[k], press.force * std::tan(phi), 1e-12);
    ASSERT_NEAR(chain->values(6)[k], -press.force * 0.013, 1e-13);
  }
}

// A crank, or a slide, that carries a rod and a rocker; the driven joint names ground as the second body.
TEST(ChainForces, OfDriversThatNameGroundSecondAreThoseOfARun) {
  for (const bool turns : {true, false}) {
    SCOPED_TRACE(turns);
    Builder b;
    const int first = b.body("first", {0.1, 0}, 0.3), rod = b.body("rod", {0.4, 0.6}, 1);
    const int rocker = b.body("rocker", {2, 0}, -0.7);
    const int driven = turns ? b.revolute(first, 0, {0, 0}) : b.prismatic(first, 0, {0, 0}, {0.6, 0.8}, 0.4);
    b.drive(driven);
    b.revolute(rod, first, {0.4, 0.5});
    b.revolute(rocker, rod, {1.7, 1.2});
    b.revolute(0, rocker, {2, 0});
    Random random(11);
    add_random_loads(b.mechanism, random);
    b.mechanism.springs.push_back({"driven", driven, {}, {}, 7, 0.3, 2});
    const ChainAgreement agrees = agreement(b.mechanism, turn(b.coordinate(driven), 0.4, 40), true);
    EXPECT_EQ(agrees.outcome, Outcome::kProven);
    EXPECT_EQ(agrees.broken, "");
    EXPECT_AT_MOST(agrees.errors.force, 100);
  }
}

bool has_chain_forces(const Mechanism& mechanism) {
  const auto plan = make_plan(mechanism);
  return plan && DyadChain::of(mechanism, *plan, turn(0, 1, 9), {{0, std::nullopt, Quantity::kEffort}});
}

TEST(ChainForces, AreOnlyForLoadsThatTheyKnow) {
  Mechanism mechanism = Press().mechanism();
  EXPECT_TRUE(has_chain_forces(mechanism));
  mechanism.springs.push_back({"on the guide", 3, {}, {}, 10, 0, 0});
  mechanism.springs.push_back({"on the driven pin", 0, {}, {}, 10, 0, 0});
  EXPECT_TRUE(has_chain_forces(mechanism));
  mechanism.springs.push_back({"between two links", 2, {}, {}, 10, 0, 0});
  EXPECT_TRUE(has_chain_forces(mechanism));
  Builder free;  // its roller turns freely
  const int crank = free.body("crank", {0, 0}, 0), roller = free.body("roller", {1, 0}, 0);
  free.drive(free.revolute(0, crank, {0, 0}));
  free.revolute(crank, roller, {1, 0});
  EXPECT_FALSE(has_chain_forces(free.mechanism));
}

// Links a, b, c and the ground d, with torsion springs on all pins but the driven one.
Mechanism sprung_four_bar(double a, double b, double c, double d) {
  Builder bar;
  const int crank = bar.body("crank", {0, 0}, 0), coupler = bar.body("coupler", {a, 0}, 0);
  const double x = ((d - a) * (d - a) + b * b - c * c) / (2 * (d - a));
  const Vector2d B(a + x, std::sqrt(b * b - x * x));
  const int rocker = bar.body("rocker", {d, 0}, 0.3);
  bar.drive(bar.revolute(0, crank, {0, 0}));
  const int knee = bar.revolute(crank, coupler, {a, 0});
  const int tip = bar.revolute(coupler, rocker, B);
  const int pivot = bar.revolute(rocker, 0, {d, 0});
  bar.mechanism.springs = {{"return", pivot, {}, {}, 7, 0.2, 0.3},
                           {"knee", knee, {}, {}, 11, -0.4, 0.5},
                           {"tip", tip, {}, {}, 5, 1.1, 0.2}};
  return bar.mechanism;
}

// Whole turns count: links of the second linkage turn fully, three times.
TEST(ChainForces, OfTorsionSpringsAreThoseOfARun) {
  for (const Mechanism& mechanism : {sprung_four_bar(1, 4, 3, 5), sprung_four_bar(4, 3.5, 3.7, 1.2)}) {
    for (const auto& rows : {turn(0, 6 * kPi, 271), turn(0, -6 * kPi, 91)}) {
      const ChainAgreement agrees = agreement(mechanism, rows, true);
      EXPECT_EQ(agrees.outcome, Outcome::kProven);
      EXPECT_EQ(agrees.broken, "");
      EXPECT_AT_MOST(agrees.errors.force, 100);
    }
  }
}

// Rounding would decide which of two angles is nearer to the pose.
TEST(ChainForces, AreNotProvenWhereABodyStartsHalfATurnFromItsPose) {
  for (const double off : {kPi, kPi - 1e-3}) {
    Mechanism mechanism = sprung_four_bar(1, 4, 3, 5);
    Body& rocker = mechanism.bodies[3];
    const auto run = start_run(make_run_model(mechanism, *make_plan(mechanism)), {0});
    ASSERT_TRUE(run);
    // Moved towards its other pin, it is still nearest to this assembly and not to the mirrored one.
    const BodyMotion& at = run->row.bodies[3];
    const Vector2d along_B =
        point_of(mechanism, mechanism.joints[2].second) - point_of(mechanism, mechanism.joints[3].first);
    rocker.guess_p_WB = at.X_WB.p_WB + 0.2 * (at.X_WB.R_WB * along_B);
    rocker.guess_theta = at.theta + off;
    EXPECT_EQ(agreement(mechanism, turn(0, 1, 31), true).outcome == Outcome::kProven, off != kPi);
  }
}

Counts compare_cams(CamShape cam, CamShape follower, unsigned count) {
  Counts counts;
  for (unsigned seed = 1; seed <= count; ++seed) {
    Mechanism mechanism = RandomCam(seed, 1).build(cam, follower);
    const bool turns = mechanism.joints[0].type == JointType::kRevolute;
    const auto rows = turn(turns ? mechanism.bodies[1].guess_theta : 0.0, turns ? 0.3 : 0.05, 15 + seed % 20);
    Random random(seed);
    add_random_loads(mechanism, random);
    press_follower(mechanism, rows.front(), random.between(-5, 100), random);
    const ChainAgreement agrees = agreement(mechanism, rows, true);
    EXPECT_NE(agrees.outcome, Outcome::kNoChain) << "seed " << seed;
    EXPECT_EQ(agrees.broken, "") << "seed " << seed;
    counts.proven += agrees.outcome == Outcome::kProven ? 1 : 0;
    counts.worst.force = std::max(counts.worst.force, agrees.errors.force);
  }
  return counts;
}

TEST(ChainForces, OfContactsAreThoseOfARun) {
  for (const auto& [cam, follower] :
       {std::pair{CamShape::kDisc, CamShape::kDisc}, std::pair{CamShape::kDisc, CamShape::kEdge},
        std::pair{CamShape::kEdge, CamShape::kOval}, std::pair{CamShape::kOval, CamShape::kDisc},
        std::pair{CamShape::kOval, CamShape::kOval}}) {
    SCOPED_TRACE(static_cast<int>(cam) * 10 + static_cast<int>(follower));
    const Counts counts = compare_cams(cam, follower, 150);
    EXPECT_GT(counts.proven, 50);
    EXPECT_AT_MOST(counts.worst.force, 1e5);
  }
}

// A roller straight above an eccentric disc that turns about (0, 0), pressed down by `force` and by its
// inertia.
struct Tappet {
  double e = 0.01, reach = 0.05, force = 300, mass = 0;

  [[nodiscard]] Mechanism mechanism() const {
    Builder b;
    const int cam = b.body("cam", {0, 0}, 0), tappet = b.body("tappet", {0, 0}, 0);
    const double y = std::sqrt(reach * reach - e * e);
    b.drive(b.revolute(0, cam, {0, 0}));
    b.prismatic(0, tappet, {0, y}, {0, 1}, y);
    b.contact(b.circle(cam, {e, 0}, 0.6 * reach), b.circle(tappet, {0, y}, 0.4 * reach));
    b.mechanism.loads.push_back({"spring", tappet, Vector2d(0, y), Vector2d(0, -force), 0, {}});
    b.mechanism.bodies[tappet].mass = MassProperties{mass, Vector2d(0, y), 0};
    return b.mechanism;
  }
};

// y = e sin θ + √(r² - e² cos² θ); the normal is inclined by φ with r sin φ = e cos θ.
TEST(ChainForces, OfATappetAreThoseOfTheTextbook) {
  const Tappet tappet;
  const auto rows = turn(0, 2 * kPi, 73);
  const Mechanism mechanism = tappet.mechanism();
  auto chain = DyadChain::of(mechanism, *make_plan(mechanism), rows,
                             {{0, std::nullopt, Quantity::kContactForce},
                              {0, std::nullopt, Quantity::kEffort},
                              {0, std::nullopt, Quantity::kEffortByPower},
                              {1, std::nullopt, Quantity::kForceX},
                              {1, std::nullopt, Quantity::kForceY},
                              {0, std::nullopt, Quantity::kForceY}});
  ASSERT_TRUE(chain && chain->solve(mechanism));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double s = std::sin(rows[k].position), c = std::cos(rows[k].position);
    const double tangent =
        tappet.e * c / std::sqrt(tappet.reach * tappet.reach - tappet.e * tappet.e * c * c);
    const double slope = tappet.e * c + tangent * tappet.e * s;
    ASSERT_NEAR(chain->values(0)[k], tappet.force * std::hypot(1, tangent), 1e-11);
    ASSERT_NEAR(chain->values(1)[k], tappet.force * slope, 1e-13);
    ASSERT_NEAR(chain->values(2)[k], tappet.force * slope, 1e-13);
    ASSERT_NEAR(chain->values(3)[k], tappet.force * tangent, 1e-12);
    ASSERT_EQ(chain->values(4)[k], 0);
    ASSERT_NEAR(chain->values(5)[k], tappet.force, 1e-11);
  }
}

// The inertia pulls the follower up most at the top, which lies between two rows.
TEST(ChainForces, OfAContactThatOpensBetweenTwoRowsAreNotProven) {
  Tappet tappet;
  tappet.force = 0;
  tappet.mass = 1;
  const auto rows = turn(0.02, 2 * kPi, 61);
  Mechanism mechanism = tappet.mechanism();
  const auto run = start_run(make_run_model(mechanism, *make_plan(mechanism)), {rows.front().position});
  ASSERT_TRUE(run);
  const DriverPath path = straight_path({rows.front()}, {rows.back()}, 60);
  const double pull = -follow_contact_forces(*run, path).lowest.front()->force;
  ASSERT_GT(pull, 0);
  for (const double share : {0.5, 0.99, 0.999999, 1.000001, 1.05, 2.0}) {
    SCOPED_TRACE(share);
    tappet.force = pull * share;
    const ChainAgreement agrees = agreement(tappet.mechanism(), rows, true);
    EXPECT_EQ(agrees.outcome, share > 1.04 ? Outcome::kProven : Outcome::kNotProven);
    EXPECT_EQ(agrees.broken, "");
    EXPECT_EQ(agreement(tappet.mechanism(), rows, false).outcome, Outcome::kProven);
  }
}

// A spring without length has no direction but that of rounding.
TEST(ChainForces, OfASpringWithoutLengthAreNotProven) {
  const auto rows = turn(kPi / 2, 1, 30);
  Mechanism mechanism = Press().mechanism();
  mechanism.springs.push_back({"short", std::nullopt, {1, 1}, {3, 0}, 10, 0.02, 1});
  EXPECT_EQ(agreement(mechanism, rows, true).outcome, Outcome::kProven);
  mechanism.springs.push_back({"none", std::nullopt, {1, 1}, {2, 0}, 10, 0.02, 1});
  EXPECT_EQ(agreement(mechanism, rows, true).outcome, Outcome::kNotProven);
  EXPECT_EQ(agreement(mechanism, rows, false).outcome, Outcome::kProven);
}

// Loads may vary just like dimensions.
TEST(ChainForces, OfVariantsFollowTheirLoads) {
  Press press;
  const auto rows = turn(kPi / 2, 1, 9);
  const Mechanism first = press.mechanism();
  auto chain = DyadChain::of(first, *make_plan(first), rows, {{0, std::nullopt, Quantity::kEffort}});
  ASSERT_TRUE(chain && chain->solve(first));
  const double torque = chain->values(0)[3];
  press.force *= 2;
  ASSERT_TRUE(chain->solve(press.mechanism()));
  EXPECT_NEAR(chain->values(0)[3], 2 * torque, 1e-13);
}

}  // namespace
}  // namespace higherpair::testing
