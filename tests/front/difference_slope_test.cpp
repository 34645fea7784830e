#include "front/sensitivity/difference_slope.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

struct Found {
  Slope slope;
  int steps = 0;
};

// Of f at 0, with steps of 0.02 and shorter ones, five at most.
template <class F>
Found slope_at_zero(F f) {
  DifferenceSlope found;
  int steps = 0;
  for (double h = 0.02; steps < 5 && found.needs_shorter_step(); h *= 0.1, ++steps) {
    found.add({f(-2 * h), f(-h), f(0.0), f(h), f(2 * h)}, h, std::abs(f(0.0)));
  }
  return {found.slope(), steps};
}

TEST(DifferenceSlope, OfASmoothFunctionTakesOneStep) {
  const Found found = slope_at_zero([](double x) { return 3 * std::sin(0.2 * x) + std::cos(0.3 * x); });
  EXPECT_EQ(found.steps, 1);
  EXPECT_EQ(found.slope.kind, SlopeKind::kDifferences);
  EXPECT_NEAR(found.slope.up, 0.6, 1e-9);
  EXPECT_EQ(found.slope.up, found.slope.down);
  EXPECT_LE(std::abs(found.slope.up - 0.6), found.slope.error);
}

TEST(DifferenceSlope, IsThatOfTheExtremeAtTheNumberWhereAnotherOneTakesOverBesideIt) {
  for (const double over : {-0.033, -0.011, -0.0007, 0.0031, 0.0123, 0.023}) {
    // With 40 times the slope.
    const double steep = over > 0 ? 52 : -52;
    const Found found = slope_at_zero([&](double x) {
      return std::max(7 + 1.3 * std::sin(x), 7 + 1.3 * std::sin(over) + steep * (x - over));
    });
    EXPECT_GT(found.steps, 1) << over;
    EXPECT_EQ(found.slope.kind, SlopeKind::kDifferences) << over;
    EXPECT_NEAR(found.slope.up, 1.3, 1e-8) << over;
    EXPECT_LE(found.slope.error, 1e-5) << over;
  }
}

TEST(DifferenceSlope, OfAKinkHasTwoSides) {
  const Found found = slope_at_zero([](double x) { return std::max(5 + 0.3 * x, 5 - 1.1 * x + x * x); });
  EXPECT_EQ(found.slope.kind, SlopeKind::kKink);
  EXPECT_NEAR(found.slope.up, 0.3, 1e-8);
  EXPECT_NEAR(found.slope.down, -1.1, 1e-8);
}

TEST(DifferenceSlope, OfNoiseHasAnErrorAsLargeAsItIs) {
  const Found found =
      slope_at_zero([](double x) { return 9 + 0.4 * x + 1e-3 * std::sin(1e9 * x * x + 1e5 * x); });
  EXPECT_GE(found.slope.error, std::abs(found.slope.up - 0.4) / 2);
  EXPECT_GT(found.slope.error, 1e-2);
}

TEST(DifferenceSlope, OfAConstantIsZeroWhateverItsRounding) {
  const Found found = slope_at_zero([](double x) { return 1e6 + (x > 0 ? 1e-9 : 0); });
  EXPECT_EQ(found.steps, 1);
  EXPECT_NEAR(found.slope.up, 0, 1e-7);
}

TEST(DifferenceSlope, OfWhatHasNoValueBesideHasNone) {
  const Found found = slope_at_zero([](double x) { return std::sqrt(x); });
  EXPECT_EQ(found.slope.kind, SlopeKind::kNone);
  EXPECT_EQ(found.slope.remark, "with another value the mechanism cannot be run all the way");
}

}  // namespace
}  // namespace higherpair
