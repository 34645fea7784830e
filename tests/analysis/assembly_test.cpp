// The search for assemblies of mechanisms with many dyads, most of which have no part in why it fails.
#include "higherpair/analysis/branches.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/analysis/start_ranges.hpp"
#include "higherpair/mechanism/description.hpp"
#include "mechanism_builder.hpp"
#include "support/texts.hpp"

#include <atomic>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::Builder;
using testing::contains;

constexpr double kRadiusOfCrank = 0.03;

// A driven crank of length 30 mm about the origin.
struct CrankMechanism {
  Builder builder;
  int crank = builder.body("crank", {0, 0}, 0);

  CrankMechanism() { builder.drive(builder.revolute(0, crank, {0, 0})); }

  // A slider on the x axis, on a rod from the pin of the crank.
  void add_slider(const std::string& name, double length) {
    const int rod = builder.body(name + "_rod", {kRadiusOfCrank, 0}, 0);
    const int slider = builder.body(name + "_slider", {kRadiusOfCrank + length, 0}, 0);
    (void)builder.revolute(crank, rod, {kRadiusOfCrank, 0});
    (void)builder.revolute(rod, slider, {kRadiusOfCrank + length, 0});
    (void)builder.prismatic(0, slider, {kRadiusOfCrank + length, 0}, {1, 0}, kRadiusOfCrank + length);
  }

  // Two links from P, a point of a body, to a pin of ground at Q, that meet at C. \returns the second link
  int add_dyad(const std::string& name, int body, const Vector2d& P, const Vector2d& C, const Vector2d& Q) {
    const int one = builder.body(name + "_one", P, 0);
    const int two = builder.body(name + "_two", Q, 0);
    (void)builder.revolute(body, one, P);
    (void)builder.revolute(one, two, C);
    (void)builder.revolute(0, two, Q);
    return two;
  }
};

std::string numbered(const std::string& name, int k) {
  return name + std::to_string(10 + k);
}

// Thirty slider-cranks on one crank, the last with a rod of 20 mm: at 80 degrees it cannot reach the axis,
// whatever the modes of the others. It can where 30 |sin| is at most 20.
TEST(Assembly, FailsAtOnceWhereOneOfManyDyadsIsTooShort) {
  CrankMechanism cranks;
  for (int k = 0; k < 30; ++k) {
    cranks.add_slider(numbered("k", k), k < 29 ? 0.1 : 0.02);
  }
  const double from = 80 * kPi / 180;
  const auto run = start_run(cranks.builder.mechanism, {from});
  ASSERT_FALSE(run);
  EXPECT_TRUE(contains(run.error().reason, numbered("k", 29)));
  const auto ranges = find_start_ranges(cranks.builder.mechanism, {from}, kDefaultClosure);
  ASSERT_TRUE(ranges);
  ASSERT_FALSE(ranges->empty());
  EXPECT_NEAR(std::remainder(ranges->front().high, 2 * kPi), std::asin(2.0 / 3), 1e-8);
}

// The last dyad only reaches the rocker where that is in the mode farther from the poses.
struct RockerWithDyad : CrankMechanism {
  Vector2d C{0.065, std::sqrt(0.06 * 0.06 - 0.035 * 0.035)};
  int rocker = 0;

  explicit RockerWithDyad(int sliders) {
    rocker = add_dyad("a", crank, {kRadiusOfCrank, 0}, C, {0.1, 0});
    for (int k = 0; k < sliders; ++k) {
      add_slider(numbered("k", k), 0.1);
    }
    const Vector2d Q(0.065, -0.1);
    // Links of 30 mm, whose common pin is where it may be.
    const int one = builder.body("z_one", C, 0);
    const int two = builder.body("z_two", Q, 0);
    (void)builder.revolute(rocker, one, C);
    builder.mechanism.bodies[one].points.push_back({"D", {0.03, 0}});
    builder.mechanism.bodies[two].points.push_back({"D", {0.03, 0}});
    Joint pin;
    pin.name = "D";
    pin.first = {one, 1};
    pin.second = {two, 0};
    builder.mechanism.joints.push_back(pin);
    (void)builder.revolute(0, two, Q);
  }
};

TEST(Assembly, IsFoundInAModeFarFromThePosesThatOneOfManyDyadsNeeds) {
  const RockerWithDyad mechanism(30);
  const auto run = start_run(mechanism.builder.mechanism, {0});
  ASSERT_TRUE(run) << run.error().reason;
  const Vector2d C_W = run->at.state.bodies[mechanism.rocker].X_WB * Vector2d(mechanism.C - Vector2d(0.1, 0));
  EXPECT_NEAR(C_W.x(), mechanism.C.x(), 1e-14);
  EXPECT_NEAR(C_W.y(), -mechanism.C.y(), 1e-14);
}

// Two for each slider and for the last dyad, one for the rocker.
TEST(Assembly, IsFoundInEveryCombinationOfModes) {
  const RockerWithDyad mechanism(3);
  const auto branches = list_branches(mechanism.builder.mechanism, {0});
  ASSERT_TRUE(branches);
  EXPECT_TRUE(branches->complete);
  EXPECT_EQ(branches->assemblies.size(), 16U);
}

// Each dyad depends on the one before, so that all modes of all of them have to be tried for the last.
TEST(Assembly, SearchCanBeStopped) {
  CrankMechanism chain;
  int body = chain.crank;
  Vector2d P(kRadiusOfCrank, 0);
  for (int k = 0; k < 40; ++k) {
    const Vector2d Q = 0.1 * unit_vector(k);
    const Vector2d middle = (P + Q) / 2;
    const Vector2d half = (Q - P) / 2;
    const Vector2d C = middle + perp(half).normalized() * std::sqrt(1 - half.squaredNorm());
    body = chain.add_dyad(numbered("k", k), body, P, C, Q);
    P = C;
  }
  const int last = chain.builder.body("z", P, 0);
  (void)chain.builder.revolute(body, last, P);
  (void)chain.builder.slot(0, last, P + Vector2d(0.001, 0), {1, 0}, 0);
  chain.builder.mechanism.bodies[0].points.back().p_B = {0, 50};
  const std::atomic<bool> stop = true;
  EXPECT_FALSE(find_start_ranges(chain.builder.mechanism, {0.1}, kDefaultClosure, &stop));
}

}  // namespace
}  // namespace higherpair
