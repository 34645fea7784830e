// Runs that have come to the same row over few rows and over many continue alike; those with a different past
// or another branch ahead do not.
#include "higherpair/analysis/go_on_alike.hpp"

#include "analysis/run_testing.hpp"
#include "geometry/geometry_testing.hpp"
#include "higherpair/analysis/branch_run.hpp"
#include "higherpair/io/profile_reader.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::kDegree;

// Moves a run from `from` to `to` in equal rows; returns it at the last of them.
Run moved(Run run, double from, double to, int rows) {
  for (int k = 1; k <= rows; ++k) {
    move_to(run, {{k == rows ? to : from + (to - from) * k / rows, 1, 0}});
  }
  return run;
}

TEST(GoingOn, IsTheSameOverFewRowsAndOverMany) {
  for (const char* name : {"four_bar", "watt_sixbar", "ellipse_cam_roller", "spline_cam", "scotch_yoke",
                           "knife_edge", "planetary_gear"}) {
    SCOPED_TRACE(name);
    const auto start = start_run(testing::shipped(name).mechanism, {0}).value();
    double from = 0;
    auto few = start;
    auto many = start;
    for (const double to : {31.7, 90.0, 180.0, 200.3, 360.0, 361.7, 777.7, 100.1}) {
      few = moved(few, from * kDegree, to * kDegree, 1);
      many = moved(many, from * kDegree, to * kDegree, 157);
      EXPECT_TRUE(go_on_alike(few, many)) << to;
      from = to;
    }
  }
}

TEST(GoingOnElsewhere, IsNotTheSame) {
  const Mechanism mechanism = testing::shipped("four_bar").mechanism;
  const auto start = start_run(mechanism, {0}).value();
  const auto run = moved(start, 0, 1, 3);
  EXPECT_FALSE(go_on_alike(run, moved(start, 0, 1 + 1e-13, 3)));             // another row
  EXPECT_FALSE(go_on_alike(run, moved(start, 0, 1 + 2 * kPi, 3)));           // a whole turn on
  const auto other = start_on_branch(run.model, {0}, 1 - branch_of(start));  // another branch
  ASSERT_TRUE(other);
  EXPECT_FALSE(go_on_alike(run, moved(*other, 0, 1, 3)));
}

TEST(GoingOnElsewhere, IsWhereAnOutputHasMovedTheOtherWay) {
  const auto start = start_run(testing::shipped("four_bar").mechanism, {0}).value();
  const auto run = moved(start, 0, 1, 3);
  auto other = run;
  other.at.outputs.front().sense = -other.at.outputs.front().sense;
  EXPECT_FALSE(go_on_alike(run, other));
}

// A slide of 20 nm: change points that differ by half a hundredth of that are not the same.
TEST(GoingOnElsewhere, IsJudgedRelativeToTheSize) {
  constexpr double size = 2e-8;
  Mechanism m;
  const int slider = add_body(m, "slider", Vector2d(-size, 0));
  add_driver(m, add_prismatic(m, "guide", add_point(m, kGround, "O", Vector2d::Zero()),
                              add_point(m, slider, "P", Vector2d(size, 0)), Vector2d::UnitX()));
  auto run = start_run(m, {0}).value();
  run.at.reported.resize(1);
  run.at.reported[0].driver = size / 2;
  auto other = run;
  EXPECT_TRUE(go_on_alike(run, other));
  other.at.reported[0].driver = 0.505 * size;
  EXPECT_FALSE(go_on_alike(run, other));
}

// Beyond its limit a mechanism is in the same state wherever it was lost; back from there it no longer is.
TEST(GoingOnBeyondALimit, IsTheSameWhereverItWasLost) {
  const double from = 0;
  const double beyond = 150 * kDegree;
  const auto start = start_run(testing::shipped("lock_up").mechanism, {from}).value();
  const auto few = moved(start, from, beyond, 1);
  const auto many = moved(start, from, beyond, 400);
  ASSERT_FALSE(few.at.on_branch);
  EXPECT_EQ(few.at.on_branch, many.at.on_branch);
  EXPECT_TRUE(go_on_alike(few, many));
  EXPECT_FALSE(go_on_alike(few, moved(many, beyond, from + 0.01, 1)));
}

}  // namespace
}  // namespace higherpair
