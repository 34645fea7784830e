#include "higherpair/numeric/newton_root.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct Found {
  std::optional<double> root;
  int calls = 0;
  double last = kNaN;  // argument of the last call
};

Found find(const std::function<ValueAndSlope(double)>& f, double h) {
  Found found;
  const auto counted = [&](double x) {
    ++found.calls;
    found.last = x;
    return f(x);
  };
  const double at_h = f(h).value;
  found.root = newton_root_between(counted, f(0), h, at_h);
  return found;
}

TEST(NewtonRoot, IsFoundInAFewCallsWhereFIsSmooth) {
  for (const double sense : {1.0, -1.0}) {
    const auto f = [&](double x) {
      return ValueAndSlope{std::exp(sense * x) - 1.7, sense * std::exp(sense * x)};
    };
    const Found found = find(f, sense * 1.3);
    ASSERT_TRUE(found.root);
    EXPECT_NEAR(*found.root, sense * std::log(1.7), 2e-16);
    EXPECT_EQ(found.last, *found.root);
    EXPECT_LE(found.calls, 8);
  }
}

TEST(NewtonRoot, IsFoundAtAKinkFromEitherSide) {
  for (const double steep : {0.03, 40.0}) {
    const auto f = [&](double x) {
      const double t = x - 0.37;
      return t < 0 ? ValueAndSlope{t + 0.3 * t * t, 1 + 0.6 * t} : ValueAndSlope{steep * t, steep};
    };
    const Found found = find(f, 2.1);
    ASSERT_TRUE(found.root);
    EXPECT_NEAR(*found.root, 0.37, 1e-16);
    EXPECT_LE(found.calls, 10);
  }
}

// As where a contact leaves a flat: beyond the root f has a jump, or is NaN.
TEST(NewtonRoot, IsApproachedFromOneSideWhereFJumpsBeyondIt) {
  for (const double beyond : {5.0, kNaN}) {
    const auto f = [&](double x) {
      const double t = x - 0.37;
      return t <= 0 ? ValueAndSlope{std::sin(t) - t * t, std::cos(t) - 2 * t} : ValueAndSlope{beyond, 0.8};
    };
    const Found found = [&] {
      Found one;
      one.root = newton_root_between(
          [&](double x) {
            ++one.calls;
            return f(x);
          },
          f(0), 1.9, 5.0);
      return one;
    }();
    ASSERT_TRUE(found.root) << beyond;
    EXPECT_NEAR(*found.root, 0.37, 2e-16) << beyond;
    EXPECT_LE(found.calls, 40) << beyond;
  }
}

TEST(NewtonRoot, IsAsExactBesideAJumpWhereverItIs) {
  for (int k = 1; k < 400; ++k) {
    const double at = 0.0847 * k / 400;
    const auto f = [&](double x) {
      const double t = x - at;
      return t < 0 ? ValueAndSlope{0.1 * t + 0.02 * t * t, 0.1 + 0.04 * t} : ValueAndSlope{3, 0.1};
    };
    const auto root = newton_root_between(f, f(0), 0.0953, 3);
    ASSERT_TRUE(root) << at;
    EXPECT_NEAR(*root, at, 1e-16) << at;
  }
}

TEST(NewtonRoot, IsNoneWhereFJumpsBeforeItFallsToZero) {
  const auto f = [](double x) { return ValueAndSlope{x < 0.4 ? -1 - x : 3, -1}; };
  EXPECT_FALSE(find(f, 1).root);
  EXPECT_FALSE(find([](double x) { return ValueAndSlope{1 + x, 1}; }, 1).root);
  EXPECT_FALSE(newton_root_between([](double x) { return ValueAndSlope{x, 1}; }, {kNaN, 1}, 1, 1));
}

TEST(NewtonRoot, DoesNotDependOnRightSlopes) {
  const auto f = [](double x) { return ValueAndSlope{x * x - 0.5, -3.0}; };
  const Found found = find(f, 1);
  ASSERT_TRUE(found.root || found.calls == 100);
  ASSERT_TRUE(found.root);
  EXPECT_NEAR(*found.root, std::sqrt(0.5), 1e-9);
}

}  // namespace
}  // namespace higherpair
