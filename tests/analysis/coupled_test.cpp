// Groups that have no closed form, redundant members, and mechanisms that cannot be run.
#include "analysis/random_mechanism.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "support/texts.hpp"

#include <chrono>
#include <cstdio>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;

using namespace higherpair::testing;

Vector2d vector_at(double angle, double length) {
  return {length * std::cos(angle), length * std::sin(angle)};
}

bool has_coupled_group(const Run& run) {
  return std::any_of(run.plan().groups.begin(), run.plan().groups.end(),
                     [](const Group& group) { return std::holds_alternative<CoupledBodies>(group.kind); });
}

/// A mechanism of one freedom that can be driven at either of two joints.
struct TwoWays {
  Builder builder;
  int easy = 0;  ///< driven here it is made of dyads
  int hard = 0;  ///< driven here bodies are coupled
};

// Stephenson's six-bar: a ternary link carried by three legs, one on the crank and two on ground. Driven at a
// grounded leg it is a four-bar and a dyad; driven at the crank it cannot be split into groups smaller than
// four bodies.
TwoWays stephenson(Random& random) {
  TwoWays result;
  Builder& b = result.builder;
  const auto body = [&](const char* name) {
    return b.body(name, {random.between(-1, 1), random.between(-1, 1)}, random.angle());
  };
  const double turn = random.angle();
  const Vector2d P1 = vector_at(turn, 0.5), P2 = vector_at(turn + random.between(1.5, 2.5), 0.5),
                 P3 = vector_at(turn - random.between(1.5, 2.5), 0.5);
  const Vector2d A = P1 + vector_at(turn + random.between(0.4, 1), random.between(0.5, 0.9));
  const Vector2d O1 = A + vector_at(turn + random.between(1.8, 2.5), random.between(0.3, 0.5));
  const Vector2d O2 = P2 + vector_at(turn + random.between(2.4, 3.2), random.between(0.5, 0.9));
  const Vector2d O3 = P3 + vector_at(turn - random.between(0.8, 1.4), random.between(0.5, 0.9));
  const int crank = body("crank"), leg1 = body("leg1"), plate = body("plate"), leg2 = body("leg2"),
            leg3 = body("leg3");
  result.hard = b.revolute(0, crank, O1);
  b.revolute(crank, leg1, A);
  b.revolute(leg1, plate, P1);
  b.revolute(plate, leg2, P2);
  b.revolute(leg3, plate, P3);
  result.easy = b.revolute(0, leg2, O2);
  b.revolute(leg3, 0, O3);
  return result;
}

// A four-bar driven between its crank and its coupler.
TwoWays four_bar(Random& random) {
  TwoWays result;
  Builder& b = result.builder;
  const double turn = random.angle();
  const Vector2d A = vector_at(turn, random.between(0.4, 0.8)), O2(random.between(0.8, 1.2), 0);
  const Vector2d B = A + vector_at(turn + random.between(0.8, 2.3), random.between(0.5, 0.9));
  const int crank = b.body("crank", A, random.angle()), coupler = b.body("coupler", B, random.angle()),
            rocker = b.body("rocker", O2, random.angle());
  result.easy = b.revolute(0, crank, Vector2d::Zero());
  result.hard = b.revolute(crank, coupler, A);
  b.revolute(coupler, rocker, B);
  b.revolute(rocker, 0, O2);
  return result;
}

JointMotion motion_at_joint(const Run& run, int joint) {
  return joint_motion(run.mechanism(), run.mechanism().joints[joint], run.row.bodies);
}

// Drives the easy joint, then the hard one through the positions that it had; compares all bodies.
void compare_ways(const TwoWays& ways, unsigned seed, Worst& worst, int& compared) {
  const auto driven_at = [&](int joint) {
    Builder builder = ways.builder;
    builder.drive(joint);
    return builder;
  };
  const Builder easy = driven_at(ways.easy), hard = driven_at(ways.hard);
  auto known = start_run(easy.mechanism, {easy.coordinate(ways.easy)});
  auto coupled = start_run(hard.mechanism, {hard.coordinate(ways.hard)});
  ASSERT_TRUE(known) << seed << known.error().reason;
  ASSERT_TRUE(coupled) << seed << coupled.error().reason;
  ASSERT_FALSE(has_coupled_group(*known));
  ASSERT_TRUE(has_coupled_group(*coupled));
  double last = 0;
  for (int k = 0; k < 12; ++k) {
    move_to(*known, {{easy.coordinate(ways.easy) + 0.03 * k, 0.9, 0.4}});
    if (known->row.status != RowStatus::kOk) return;
    const JointMotion driver = motion_at_joint(*known, ways.hard);
    // Near the dead point of the second driver the two runs diverge.
    if (std::abs(driver.velocity) < 0.3 || driver.velocity * last < 0) return;
    last = driver.velocity;
    move_to(*coupled, {{driver.position, driver.velocity, driver.acceleration}});
    ASSERT_EQ(coupled->row.status, RowStatus::kOk) << seed << " row " << k;
    EXPECT_AT_MOST(coupled->row.residual, 1e-13);
    for (std::size_t i = 1; i < known->row.bodies.size(); ++i) {
      const BodyMotion& a = known->row.bodies[i];
      const BodyMotion& c = coupled->row.bodies[i];
      const double speed = 1 + std::abs(a.omega) / std::abs(driver.velocity);
      worst.see((a.X_WB.p_WB - c.X_WB.p_WB).norm() / speed);
      worst.see(angle_error(a.theta, c.theta) / speed);
      worst.see(std::abs(a.omega - c.omega) / (speed * speed));
      worst.see((a.v_WB - c.v_WB).norm() / (speed * speed));
      // α is a difference of terms of this size.
      const double term = std::abs(a.omega * driver.acceleration / driver.velocity);
      worst.see(std::abs(a.alpha - c.alpha) / (speed * speed * speed + std::abs(a.alpha) + term));
    }
    ++compared;
  }
}

TEST(CoupledBodiesDrivenTheHardWay, MoveLikeTheSameMechanismMadeOfDyads) {
  for (const bool is_sixbar : {false, true}) {
    SCOPED_TRACE(is_sixbar ? "Stephenson's six-bar" : "four-bar");
    Worst worst;
    int compared = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
      Random random(seed);
      compare_ways(is_sixbar ? stephenson(random) : four_bar(random), seed, worst, compared);
    }
    EXPECT_GT(compared, 700);
    EXPECT_AT_MOST(worst.value(), 1e-12);
  }
}

// Three equal cranks on one coupler: a structure by the mobility formula, yet it moves.
Builder three_cranks(const Vector2d& third) {
  Builder b;
  const std::array<Vector2d, 3> pivots{Vector2d(0, 0), Vector2d(0.7, 0.1), third};
  const Vector2d arm = vector_at(0.9, 0.31);
  const int coupler = b.body("coupler", arm, 0);
  for (std::size_t i = 0; i < 3; ++i) {
    const int crank = b.body(fmt::format("crank{}", i), pivots[i], 0.9);
    const int joint = b.revolute(0, crank, pivots[i]);
    b.revolute(crank, coupler, pivots[i] + arm);
    if (i == 0) b.drive(joint);
  }
  return b;
}

TEST(RedundantMembers, OfAThirdParallelCrankDoNotKeepTheMechanismFromTurning) {
  const Builder b = three_cranks({0.2, 0.6});
  auto run = start_run(b.mechanism, {0.9});
  ASSERT_TRUE(run) << run.error().reason;
  EXPECT_EQ(run->plan().surplus, 1);
  for (int k = 0; k <= 72; ++k) {
    const double theta = 0.9 + k * kPi / 36;
    move_to(*run, {{theta, 2, -3}});
    ASSERT_EQ(run->row.status, RowStatus::kOk) << k;
    EXPECT_AT_MOST(run->row.residual, 1e-14);
    for (std::size_t i = 2; i <= 4; ++i) {
      EXPECT_NEAR(run->row.bodies[i].theta, theta, 1e-13);
      EXPECT_NEAR(run->row.bodies[i].omega, 2, 1e-12);
      EXPECT_NEAR(run->row.bodies[i].alpha, -3, 1e-11);
    }
    EXPECT_NEAR(run->row.bodies[1].omega, 0, 1e-12);
  }
}

TEST(RedundantMembers, ThatDoNotFitAreRefused) {
  Builder b = three_cranks({0.2, 0.6});
  b.mechanism.bodies[4].points[1].p_B *= 1.01;
  const auto run = start_run(b.mechanism, {0.9});
  ASSERT_FALSE(run);
  EXPECT_TRUE(contains(run.error().reason, "remove drivers.d0"));
}

TEST(LooseMechanisms, AreRefusedWithTheNamesOfWhatIsLoose) {
  Random random(4);
  // A four-bar without a driver.
  const auto still = start_run(four_bar(random).builder.mechanism, {});
  ASSERT_FALSE(still);
  EXPECT_TRUE(contains(still.error().reason, "1 driver needed, 0 given"));
  // A link that is attached to the crank by one pin only.
  TwoWays ways = four_bar(random);
  const int flag = ways.builder.body("flag", {0.2, 0.3}, 0.4);
  ways.builder.revolute(1, flag, {0.25, 0.35});
  ways.builder.drive(ways.easy);
  const auto hanging = start_run(ways.builder.mechanism, {ways.builder.coordinate(ways.easy)});
  ASSERT_FALSE(hanging);
  EXPECT_TRUE(contains(hanging.error().reason, "2 drivers needed, 1 given"));
  EXPECT_TRUE(contains(hanging.error().reason, "in which flag can move"));
  // A body that is attached to nothing.
  ways.builder.body("stone", {2, 1}, 0);
  const auto apart = start_run(ways.builder.mechanism, {0});
  ASSERT_FALSE(apart);
  EXPECT_TRUE(contains(apart.error().reason, "stone"));
}

TEST(TooManyDrivers, AreRefused) {
  Random random(9);
  TwoWays ways = four_bar(random);
  ways.builder.drive(ways.easy);
  ways.builder.drive(ways.hard);
  const double easy = ways.builder.coordinate(ways.easy), hard = ways.builder.coordinate(ways.hard);
  const auto run = start_run(ways.builder.mechanism, {easy, hard});
  ASSERT_FALSE(run);
  EXPECT_TRUE(contains(run.error().reason, "driver"));
}

// A row of parallelograms, each driven by the one before; every crank turns like the first.
Builder ladder(int rungs) {
  Builder b;
  const double theta = 1.1;
  Vector2d O = Vector2d::Zero();
  int crank = b.body("crank0", O, theta);
  b.drive(b.revolute(0, crank, O));
  for (int i = 1; i <= rungs; ++i) {
    const Vector2d arm = vector_at(theta, 0.3 + 0.02 * (i % 3));
    const Vector2d next = O + Vector2d(0.7, i % 2 == 0 ? 0.1 : -0.1);
    const int coupler = b.body(fmt::format("coupler{}", i), O + arm, 0);
    const int rocker = b.body(fmt::format("crank{}", i), next, theta);
    b.revolute(crank, coupler, O + arm);
    b.revolute(coupler, rocker, next + arm);
    b.revolute(rocker, 0, next);
    crank = rocker;
    O = next;
  }
  return b;
}

TEST(Ladder, OfAThousandFourBarsRunsInOneFile) {
  using Clock = std::chrono::steady_clock;
  const auto ms = [](Clock::time_point from) {
    return std::chrono::duration<double, std::milli>(Clock::now() - from).count();
  };
  for (const int rungs : {250, 500, 1000}) {
    const Builder b = ladder(rungs);
    const auto before = Clock::now();
    auto run = start_run(b.mechanism, {1.1});
    ASSERT_TRUE(run) << run.error().reason;
    const double start = ms(before);
    const auto begin = Clock::now();
    for (int k = 0; k <= 20; ++k) {
      move_to(*run, {{1.1 + 0.02 * k, 1, 0}});
      ASSERT_EQ(run->row.status, RowStatus::kOk);
    }
    fmt::print("{} four-bars: start {:.2f} ms, {:.3f} ms a row\n", rungs, start, ms(begin) / 21);
    EXPECT_AT_MOST(run->row.residual, 1e-12 * run->plan().size);
    // Coordinates of up to 700 round to 1e-13, which turns a crank of 0.3 by 3e-13 at every rung.
    EXPECT_NEAR(run->row.bodies.back().theta, 1.5, 1e-14 * rungs);
    EXPECT_NEAR(run->row.bodies.back().omega, 1, 1e-13 * rungs);
  }
}

}  // namespace
}  // namespace higherpair
