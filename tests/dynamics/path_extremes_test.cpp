#include "higherpair/dynamics/path_extremes.hpp"

#include "dynamics/dynamics_testing.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::Analysis;

// A turning crank; the functions to be followed depend on its angle.
const char* const kCrank = R"([bodies.ground]
points.O = [0, 0]
[bodies.crank]
points.O = [0, 0]
points.A = [0.1, 0]
[joints]
O = { type = "revolute", between = ["ground.O", "crank.O"] }
[driver]
joint = "O"
)";

PathRange range_of(const std::function<double(double)>& f, double from, double to,
                   const std::vector<double>& breaks = {}, double noise = 0) {
  const Analysis analysis(kCrank);
  const PathQuantities quantity{{{true, true, noise}},
                                [&](const higherpair::Run& run, double, std::span<double> out) {
                                  out[0] = f(run.row.bodies[1].theta);
                                }};
  return path_extremes(analysis.run, straight_path({{from, 1, 0}}, {{to, 1, 0}}), {quantity}, breaks)
      .at(0)
      .at(0);
}

TEST(PathExtremes, AreSoughtOnSoMuchOfAPathAsHasAMillionSamples) {
  const Analysis analysis(kCrank);
  const auto farthest = [&](double to) {
    DriverPath path = straight_path({{0, 1, 0}}, {{to, 1, 0}});
    return cut_to_examined(analysis.run, path);
  };
  EXPECT_FALSE(farthest(0.1));
  EXPECT_FALSE(farthest(1000 * 2 * kPi));
  EXPECT_NEAR(farthest(1e6 * 2 * kPi).value() * 1e6, 1e6 / 720, 1e-3);  // two samples for each degree
  DriverPath path = straight_path({{0, 1, 0}}, {{1e4 * 2 * kPi, 1, 0}});
  path.knots = {0, 0.05, 1};
  const double end = cut_to_examined(analysis.run, path).value();
  EXPECT_NEAR(end * 1e4, 1e6 / 720, 1e-3);
  EXPECT_EQ(path.knots, (std::vector<double>{0, 0.05, end}));
}

TEST(PathExtremes, AreThoseOfTheFunctionToTheLastDigits) {
  const auto range = range_of([](double x) { return std::sin(x) + 0.1 * x; }, 0, 2 * kPi);
  ASSERT_TRUE(range.greatest && range.least);
  const double at = std::acos(-0.1);
  EXPECT_NEAR(range.greatest->driver, at, 1e-10);
  EXPECT_NEAR(range.greatest->value, std::sin(at) + 0.1 * at, 1e-15);
  EXPECT_NEAR(range.greatest->at, at / (2 * kPi), 1e-11);
  EXPECT_NEAR(range.least->driver, 2 * kPi - at, 1e-10);
}

TEST(PathExtremes, AreAtTheEndsOfThePathWhereTheyAreThere) {
  const auto range = range_of([](double x) { return std::exp(x); }, -0.7, 1.3);
  EXPECT_NEAR(range.least->value, std::exp(-0.7), 1e-14);
  EXPECT_NEAR(range.least->driver, -0.7, 1e-15);
  EXPECT_NEAR(range.greatest->value, std::exp(1.3), 1e-14);
  EXPECT_NEAR(range.greatest->driver, 1.3, 1e-15);
}

TEST(PathExtremes, TakeBothSidesOfAJump) {
  const double jump = 1.234567890123;
  const auto f = [&](double x) { return x < jump ? x : 0.2 - x; };
  for (const bool known : {false, true}) {
    std::vector<double> breaks;
    if (known) breaks = {jump / 3};
    const auto range = range_of(f, 0, 3, breaks);
    EXPECT_NEAR(range.greatest->value, jump, 1e-11);
    EXPECT_NEAR(range.greatest->driver, jump, 1e-11);
    EXPECT_NEAR(range.least->value, -2.8, 1e-14);
  }
}

TEST(PathExtremes, LeaveOutWhereAQuantityIsNotDefined) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto range = range_of([&](double x) { return x < 1 || x > 2.5 ? none : std::cos(x); }, 0, 3);
  EXPECT_NEAR(range.greatest->value, std::cos(1), 1e-11);
  EXPECT_NEAR(range.least->value, std::cos(2.5), 1e-11);
  const auto nowhere = range_of([&](double) { return none; }, 0, 3);
  EXPECT_FALSE(nowhere.greatest || nowhere.least);
}

// Rounding has a peak at every other position; each position is evaluated once.
TEST(PathExtremes, AreNotLookedForInRounding) {
  int calls = 0;
  const auto rounding = [&](double x) {
    ++calls;
    return 1e-16 * std::sin(1e15 * x);
  };
  const auto range = range_of(rounding, 0, 1, {}, 1e-13);
  EXPECT_EQ(range.greatest->value, 0);
  EXPECT_EQ(range.least->value, 0);
  EXPECT_LE(calls, 130);  // two for each degree
}

TEST(PathExtremes, OfAConstantAreItsFirstPlace) {
  const auto range = range_of([](double) { return 0.3; }, 0.5, 3);
  EXPECT_EQ(range.greatest->value, 0.3);
  EXPECT_NEAR(range.greatest->driver, 0.5, 1e-5);
}

TEST(PathExtremes, OfEqualPeaksAreTheFirst) {
  const auto range = range_of([](double x) { return std::sin(x); }, -1, 30);
  EXPECT_NEAR(range.greatest->driver, kPi / 2, 1e-9);
  EXPECT_NEAR(range.least->driver, 3 * kPi / 2, 1e-9);
}

TEST(PathExtremes, ComeOnlyWhereTheyAreSought) {
  const Analysis analysis(kCrank);
  const PathQuantities quantity{{{false, true, 0}, {true, false, 0}, {false, false, 0}},
                                [](const higherpair::Run&, double at, std::span<double> out) {
                                  std::fill(out.begin(), out.end(), at);
                                }};
  const auto ranges = path_extremes(analysis.run, straight_path({{0, 1, 0}}, {{1, 1, 0}}), {quantity}).at(0);
  EXPECT_TRUE(ranges[0].greatest && !ranges[0].least);
  EXPECT_TRUE(ranges[1].least && !ranges[1].greatest);
  EXPECT_FALSE(ranges[2].least || ranges[2].greatest);
}

TEST(PathExtremes, OfAPathOfOnePositionAreTheValueThere) {
  const Analysis analysis(kCrank);
  DriverPath path;
  path.knots = {0};
  path.motion = [](double, std::vector<DriverMotion>& drivers) { drivers = {{0.4, 1, 0}}; };
  const PathQuantities quantity{
      {{true, true, 0}},
      [](const higherpair::Run& run, double, std::span<double> out) { out[0] = run.row.bodies[1].theta; }};
  const auto range = path_extremes(analysis.run, path, {quantity}).at(0).at(0);
  EXPECT_EQ(range.greatest->value, 0.4);
  EXPECT_EQ(range.least->value, 0.4);
}

}  // namespace
}  // namespace higherpair
