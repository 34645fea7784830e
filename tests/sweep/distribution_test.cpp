// Distributions: quantiles compared with closed forms and known values, moments by integration of the
// quantile.
#include "higherpair/sweep/variants.hpp"

#include <cmath>
#include <functional>
#include <limits>

#include <gmock/gmock.h>

namespace higherpair {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

Distribution normal(double mean, double deviation, double low = -kNever, double high = kNever) {
  Distribution d;
  d.kind = DistributionKind::kNormal;
  d.mean = mean;
  d.deviation = deviation;
  d.low = low;
  d.high = high;
  return d;
}

Distribution uniform(double low, double high) {
  Distribution d;
  d.low = low;
  d.high = high;
  return d;
}

Distribution triangular(double low, double mode, double high) {
  Distribution d = uniform(low, high);
  d.kind = DistributionKind::kTriangular;
  d.mode = mode;
  return d;
}

// The mean of f: the integral of f(quantile), by the midpoint rule.
double mean_of(const Distribution& d, const std::function<double(double)>& f) {
  constexpr int kParts = 400000;
  double sum = 0;
  for (int i = 0; i < kParts; ++i) {
    sum += f(quantile(d, (i + 0.5) / kParts));
  }
  return sum / kParts;
}

void expect_moments(const Distribution& d, double mean, double variance) {
  const double m = mean_of(d, [](double x) { return x; });
  const double v = mean_of(d, [&](double x) { return (x - mean) * (x - mean); });
  EXPECT_NEAR(m, mean, 1e-4 * std::sqrt(variance));
  EXPECT_NEAR(v, variance, 1e-3 * variance);
}

TEST(Distributions, HaveTheQuantilesOfTheTables) {
  // Abramowitz and Stegun, table 26.5 (and 26.6 for the last).
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_quantile(0.95), 1.644853626951473, 1e-14);
  EXPECT_NEAR(normal_quantile(0.001), -3.090232306167813, 1e-14);
  EXPECT_NEAR(normal_quantile(0.5), 0, 1e-16);
  EXPECT_NEAR(quantile(uniform(-3, 5), 0.25), -1, 1e-15);
  EXPECT_NEAR(quantile(triangular(0, 0, 1), 0.75), 0.5, 1e-15);
  EXPECT_NEAR(quantile(triangular(0, 1, 1), 0.25), 0.5, 1e-15);
  EXPECT_NEAR(quantile(triangular(-2, 1, 4), 0.5), 1, 1e-15);
}

TEST(Distributions, HaveTheirMoments) {
  expect_moments(normal(7.3, 0.21), 7.3, 0.21 * 0.21);
  expect_moments(uniform(-3, 5), 1, 64 / 12.0);
  const double a = -1.3;
  const double c = 0.4;
  const double b = 2.9;
  expect_moments(triangular(a, c, b), (a + b + c) / 3, (a * a + b * b + c * c - a * b - a * c - b * c) / 18);
}

// Mean and variance of a normal distribution of mean 0 and deviation 1 that is truncated to [a, b].
TEST(Distributions, CutOffHaveTheMomentsOfTheClosedForm) {
  const auto density = [](double z) {
    return std::isinf(z) ? 0 : std::exp(-z * z / 2) / std::sqrt(2 * std::acos(-1));
  };
  for (const auto& [a, b] : {std::pair(-0.7, 1.9), {0.4, kNever}, {-kNever, -1.1}, {2.5, 3.5}}) {
    const Distribution unit = normal(0, 1, a, b);
    const double share = share_within(unit);
    const auto times = [&](double z) { return std::isinf(z) ? 0 : z * density(z); };
    const double mean = (density(a) - density(b)) / share;
    const double variance = 1 + (times(a) - times(b)) / share - mean * mean;
    expect_moments(unit, mean, variance);
    expect_moments(normal(20, 0.5, 20 + 0.5 * a, 20 + 0.5 * b), 20 + 0.5 * mean, 0.25 * variance);
  }
}

TEST(Distributions, NeverLeaveTheirLimits) {
  const double smallest = 0x1p-53;
  for (const Distribution& d : {normal(20, 0.01, 19.99, 20.03), normal(0, 1, 8, 9), normal(0, 1, -9, -8),
                                uniform(0.1, 0.3), triangular(0.1, 0.2, 0.3)}) {
    for (const double u : {smallest, 0.3, 0.5, 1 - smallest}) {
      EXPECT_GE(quantile(d, u), d.low);
      EXPECT_LE(quantile(d, u), d.high);
    }
  }
}

TEST(Distributions, FarInATailKeepTheirDigits) {
  // By symmetry the upper tail is the mirror image of the lower one.
  for (const double u : {0.001, 0.2, 0.5, 0.9}) {
    EXPECT_DOUBLE_EQ(quantile(normal(0, 1, 8, 9), u), -quantile(normal(0, 1, -9, -8), 1 - u));
  }
  EXPECT_LT(quantile(normal(0, 1, 8, 9), 0.5), 8.1);
  EXPECT_GT(quantile(normal(0, 1, 8, 9), 0.5), 8.05);
}

TEST(Distributions, OfValuesTakeEachOfThemEquallyOften) {
  Distribution d;
  d.kind = DistributionKind::kValues;
  d.values = {3, 1, 2};
  EXPECT_EQ(quantile(d, 0.01), 3);
  EXPECT_EQ(quantile(d, 0.34), 1);
  EXPECT_EQ(quantile(d, 0.99999), 2);
}

}  // namespace
}  // namespace higherpair
