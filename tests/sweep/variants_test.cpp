// Variants are functions of their number: grids and lists in order, random draws with the moments of their
// distributions, Sobol points more even than random draws.
#include "higherpair/sweep/variants.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace higherpair {
namespace {

using ::testing::ElementsAre;

SweepVariable between(double low, double high, std::int64_t count = 0) {
  SweepVariable variable;
  variable.distribution.low = low;
  variable.distribution.high = high;
  variable.count = count;
  return variable;
}

SweepVariable values(std::vector<double> list) {
  SweepVariable variable;
  variable.distribution.kind = DistributionKind::kValues;
  variable.distribution.values = std::move(list);
  return variable;
}

SweepVariable normal_variable(double mean, double deviation) {
  SweepVariable variable;
  variable.distribution.kind = DistributionKind::kNormal;
  variable.distribution.mean = mean;
  variable.distribution.deviation = deviation;
  return variable;
}

VariantPlan plan_of(SweepMethod method, std::vector<SweepVariable> variables, std::int64_t count = 0,
                    std::uint64_t seed = 1) {
  VariantPlan plan;
  plan.method = method;
  plan.count = count;
  plan.seed = seed;
  plan.variables = std::move(variables);
  return plan;
}

std::vector<double> at(const Variants& variants, std::int64_t number) {
  std::vector<double> point(variants.plan().variables.size());
  variants.values(number, point);
  return point;
}

TEST(Variants, OfAGridAreAllPairsTheLastVariableFastest) {
  const Variants grid(plan_of(SweepMethod::kGrid, {values({7, 3}), between(1, 2, 3)}));
  ASSERT_EQ(grid.size(), 6);
  EXPECT_THAT(at(grid, 0), ElementsAre(7, 1));
  EXPECT_THAT(at(grid, 1), ElementsAre(7, 1.5));
  EXPECT_THAT(at(grid, 2), ElementsAre(7, 2));
  EXPECT_THAT(at(grid, 3), ElementsAre(3, 1));
  EXPECT_THAT(at(grid, 5), ElementsAre(3, 2));
}

TEST(Variants, OfAGridAreRoundNumbers) {
  const Variants grid(plan_of(SweepMethod::kGrid, {between(18, 22, 41)}));
  for (int k = 0; k <= 40; ++k) {
    EXPECT_EQ(at(grid, k)[0], (180 + k) / 10.0) << k;
  }
  EXPECT_THAT(at(Variants(plan_of(SweepMethod::kGrid, {between(18, 22, 1)})), 0), ElementsAre(18));
}

TEST(Variants, OfAListGoTogether) {
  const Variants list(plan_of(SweepMethod::kList, {values({7, 3, 5}), values({1, 2, 4})}));
  ASSERT_EQ(list.size(), 3);
  EXPECT_THAT(at(list, 1), ElementsAre(3, 2));
}

TEST(Variants, OfAGridCanBeCountedBeyondAllIntegers) {
  const std::vector<SweepVariable> many(20, between(0, 1, 1000000));
  EXPECT_NEAR(count_of(plan_of(SweepMethod::kGrid, many)) / 1e120, 1, 1e-12);
}

// Whatever the order in which they are asked for.
TEST(Variants, HavePlansWhoseMistakesAreNamed) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto random = [](std::vector<SweepVariable> variables) {
    return plan_of(SweepMethod::kRandom, std::move(variables), 3);
  };
  const auto normal = [&](double deviation, double low, double high) {
    SweepVariable variable = normal_variable(10, deviation);
    variable.distribution.low = low;
    variable.distribution.high = high;
    return fault_of(random({variable}));
  };
  const auto triangle = [&](double mode) {
    SweepVariable variable = between(1, 5);
    variable.distribution.kind = DistributionKind::kTriangular;
    variable.distribution.mode = mode;
    return fault_of(random({variable}));
  };
  EXPECT_EQ(fault_of(random({between(1, 5), normal_variable(3, 1), values({7})})), "");
  EXPECT_EQ(fault_of(plan_of(SweepMethod::kGrid, {values({7, 3}), between(1, 2, 3)})), "");
  EXPECT_EQ(fault_of(random({})), "variables: expected at least one");
  EXPECT_EQ(fault_of(plan_of(SweepMethod::kRandom, {values({1})}, -3)),
            "count: -3 variants, expected from 1 to 100000000000");
  EXPECT_EQ(fault_of(plan_of(SweepMethod::kGrid, {between(1, 2, 1'000'000), between(1, 2, 1'000'000)})),
            "count: 1000000000000 variants, expected from 1 to 100000000000");
  EXPECT_EQ(fault_of(plan_of(SweepMethod::kGrid, {between(1, 2, -1)})),
            "variables.: count = -1: must be >= 0");
  EXPECT_EQ(fault_of(plan_of(SweepMethod::kGrid, {SweepVariable{"r", {}, {}, 5}})),
            "variables.r: low = -inf, high = inf: must be finite, and low below high");
  EXPECT_EQ(fault_of(plan_of(SweepMethod::kList, {values({1, 2, 3}), values({1})})),
            "variables.: 1 values, but the first variable has 3: in a list all have equally many");
  EXPECT_EQ(fault_of(random({values({1, kNan})})), "variables.: `values` must be finite");
  EXPECT_EQ(fault_of(random({values({})})), "variables.: expected at least one of `values`");
  EXPECT_EQ(fault_of(random({between(5, 1)})),
            "variables.: low = 5, high = 1: must be finite, and low below high");
  EXPECT_EQ(triangle(3), "");
  EXPECT_EQ(triangle(7), "variables.: mode = 7: must lie from low = 1 to high = 5");
  EXPECT_EQ(normal(2, 9, 12), "");
  EXPECT_EQ(normal(0, 9, 12),
            "variables.: mean = 10, deviation = 0: must be finite, and the deviation above 0");
  EXPECT_EQ(normal(2, 12, 8), "variables.: low = 12, high = 8: low must be below high");
  EXPECT_EQ(normal(0.1, 20, 30), "variables.: next to nothing of this distribution lies between its limits");
}

TEST(Variants, HavePlansWhoseCorrelationsAreBetweenNormalVariables) {
  const auto fault = [](const std::vector<Correlation>& correlations) {
    VariantPlan plan =
        plan_of(SweepMethod::kSobol,
                {normal_variable(1, 2), normal_variable(3, 4), normal_variable(5, 6), between(1, 2)}, 3);
    plan.correlations = correlations;
    return fault_of(plan);
  };
  EXPECT_EQ(fault({{0, 1, 0.5}}), "");
  for (const std::size_t other : {0U, 3U, 7U}) {
    EXPECT_EQ(fault({{0, other, 0.5}}), "correlations.0: between 0 and " + std::to_string(other) +
                                            ": must be the indices of two normal variables without limits");
  }
  EXPECT_EQ(fault({{0, 1, 1}}), "correlations.0: coefficient = 1: must lie between -1 and 1");
  EXPECT_EQ(fault({{0, 1, 0.9}, {1, 2, 0.9}, {0, 2, -0.9}}), "correlations: these contradict each other");
}

TEST(Variants, AreFunctionsOfTheirNumber) {
  for (const SweepMethod method : {SweepMethod::kRandom, SweepMethod::kSobol}) {
    const auto plan = plan_of(method, {between(0, 1), normal_variable(3, 0.2), between(-1, 1)}, 5000, 42);
    const Variants forward(plan);
    std::vector<std::vector<double>> points;
    for (int i = 0; i < 5000; ++i) points.push_back(at(forward, i));
    const Variants backward(plan);
    for (int i = 4999; i >= 0; --i) {
      ASSERT_EQ(at(backward, i), points[i]);
    }
  }
}

TEST(Variants, ChangeWithTheSeed) {
  for (const SweepMethod method : {SweepMethod::kRandom, SweepMethod::kSobol}) {
    std::set<double> firsts;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      firsts.insert(at(Variants(plan_of(method, {between(0, 1)}, 10, seed)), 3)[0]);
    }
    EXPECT_EQ(firsts.size(), 50U);
  }
}

// A variable keeps its values when others are added after it.
TEST(Variants, OfAVariableDoNotDependOnThoseAfterIt) {
  for (const SweepMethod method : {SweepMethod::kRandom, SweepMethod::kSobol}) {
    const Variants one(plan_of(method, {between(0, 1)}, 100));
    const Variants two(plan_of(method, {between(0, 1), between(0, 1)}, 100));
    for (int i = 0; i < 100; ++i) {
      EXPECT_EQ(at(one, i)[0], at(two, i)[0]);
    }
  }
}

// The first 2^k points have one point in each of 2^k equal parts of every variable, and for pairs one in each
// box of a grid: the (0, m, 2)-net of the first two.
TEST(Variants, OfASobolSequenceLieInEveryPartOnce) {
  constexpr int kPoints = 1024;
  const Variants sobol(
      plan_of(SweepMethod::kSobol, {between(0, 1), between(0, 1), between(0, 1), between(0, 1)}, kPoints, 9));
  for (std::size_t variable = 0; variable < 4; ++variable) {
    std::set<int> parts;
    for (int i = 0; i < kPoints; ++i) parts.insert(static_cast<int>(at(sobol, i)[variable] * kPoints));
    EXPECT_EQ(parts.size(), static_cast<std::size_t>(kPoints)) << variable;
  }
  std::set<std::pair<int, int>> boxes;
  for (int i = 0; i < kPoints; ++i) {
    const auto point = at(sobol, i);
    boxes.emplace(static_cast<int>(point[0] * 32), static_cast<int>(point[1] * 32));
  }
  EXPECT_EQ(boxes.size(), static_cast<std::size_t>(kPoints));
}

TEST(Variants, AtRandomHaveTheMomentsOfTheirDistributions) {
  constexpr int kPoints = 200000;
  const Variants random(plan_of(SweepMethod::kRandom, {normal_variable(10, 0.3), between(2, 5)}, kPoints, 3));
  double sums[2] = {0, 0};
  double squares[2] = {0, 0};
  double product = 0;
  for (int i = 0; i < kPoints; ++i) {
    const auto point = at(random, i);
    const double z[2] = {(point[0] - 10) / 0.3, (point[1] - 3.5) / (3 / std::sqrt(12.0))};
    for (int k = 0; k < 2; ++k) {
      sums[k] += z[k];
      squares[k] += z[k] * z[k];
    }
    product += z[0] * z[1];
  }
  // Five standard deviations of the mean.
  const double bound = 5 / std::sqrt(static_cast<double>(kPoints));
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(sums[k] / kPoints, 0, bound);
    EXPECT_NEAR(squares[k] / kPoints, 1, 2 * bound);
  }
  EXPECT_NEAR(product / kPoints, 0, bound);
}

TEST(Variants, ThatAreCorrelatedHaveTheirCoefficients) {
  constexpr int kPoints = 1 << 16;
  for (const SweepMethod method : {SweepMethod::kRandom, SweepMethod::kSobol}) {
    auto plan = plan_of(
        method, {normal_variable(10, 0.3), between(0, 1), normal_variable(-4, 2), normal_variable(1, 1)},
        kPoints, 5);
    plan.correlations = {{2, 0, 0.7}, {0, 3, -0.4}};
    const Variants variants(plan);
    double products[4][4] = {};
    for (int i = 0; i < kPoints; ++i) {
      const auto p = at(variants, i);
      const double z[4] = {(p[0] - 10) / 0.3, (p[1] - 0.5) * std::sqrt(12.0), (p[2] + 4) / 2, p[3] - 1};
      for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 4; ++b) products[a][b] += z[a] * z[b] / kPoints;
      }
    }
    const double bound = 5 * std::sqrt(2.0 / kPoints);
    const double expected[4][4] = {{1, 0, 0.7, -0.4}, {0, 1, 0, 0}, {0.7, 0, 1, 0}, {-0.4, 0, 0, 1}};
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) EXPECT_NEAR(products[a][b], expected[a][b], bound) << a << b;
    }
  }
}

TEST(Correlations, ThatContradictEachOtherHaveNoFactor) {
  auto plan = plan_of(SweepMethod::kRandom,
                      {normal_variable(0, 1), normal_variable(0, 1), normal_variable(0, 1)}, 10);
  plan.correlations = {{0, 1, 0.9}, {1, 2, 0.9}, {0, 2, -0.9}};
  EXPECT_FALSE(correlation_factor(plan));
  plan.correlations[2].coefficient = 0.9;
  EXPECT_TRUE(correlation_factor(plan));
}

// Published test vector of Random123 (kat_vectors: threefry2x64 with 20 rounds, counter and key 0).
TEST(Variants, AtRandomAreThoseOfThreefry) {
  const Variants random(plan_of(SweepMethod::kRandom, {between(0, 1)}, 10, 0));
  const double share = (static_cast<double>(0xc2b6e3a8c2c69865ULL >> 12U) + 0.5) * 0x1p-52;
  EXPECT_EQ(at(random, 0)[0], share);
}

// The sequence of Joe and Kuo begins 0.5 0.5, 0.75 0.25, 0.25 0.75 after zero; a shift exchanges the same
// digits of all points, so that digit-wise differences stay the same.
TEST(Variants, OfASobolSequenceAreThoseOfJoeAndKuo) {
  const Variants sobol(plan_of(SweepMethod::kSobol, {between(0, 1), between(0, 1)}, 16, 77));
  const auto digits = [&](int point, std::size_t variable) {
    return static_cast<std::uint64_t>(std::ldexp(at(sobol, point)[variable], 52));
  };
  const double expected[5][2] = {{0, 0}, {0.5, 0.5}, {0.75, 0.25}, {0.25, 0.75}, {0.375, 0.375}};
  for (int point = 0; point < 5; ++point) {
    for (std::size_t variable = 0; variable < 2; ++variable) {
      EXPECT_EQ(std::ldexp(static_cast<double>(digits(point, variable) ^ digits(0, variable)), -52),
                expected[point][variable])
          << point;
    }
  }
}

}  // namespace
}  // namespace higherpair
