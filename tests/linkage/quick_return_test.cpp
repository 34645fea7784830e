#include "higherpair/linkage/quick_return.hpp"

#include "linkage/inverted_slider_crank.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

constexpr int kRows = 36000;

InvertedSliderCrankMotion at(const InvertedSliderCrank& linkage, double theta2) {
  return inverted_slider_crank_by_crank(linkage, {theta2, 1, 0}, AssemblyMode::kPlus);
}

// The crank angle between two given ones at which `value` of the motion crosses 0.
template <class Value>
double root_between(const InvertedSliderCrank& linkage, double low, double high, const Value& value) {
  const bool rises = value(at(linkage, low)) < 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    ((value(at(linkage, middle)) < 0) == rises ? low : high) = middle;
  }
  return (low + high) / 2;
}

// All crank angles of a turn at which `value` crosses 0.
template <class Value>
std::vector<double> roots(const InvertedSliderCrank& linkage, const Value& value) {
  std::vector<double> found;
  for (int k = 0; k < kRows; ++k) {
    const double low = 2 * kPi * (k + 0.37) / kRows;
    const double high = 2 * kPi * (k + 1.37) / kRows;
    if ((value(at(linkage, low)) < 0) != (value(at(linkage, high)) < 0)) {
      found.push_back(root_between(linkage, low, high, value));
    }
  }
  return found;
}

double ratio_of(const std::vector<double>& roots) {
  const double part = roots[1] - roots[0];
  return std::max(part, 2 * kPi - part) / std::min(part, 2 * kPi - part);
}

TEST(QuickReturn, HasTheTimeRatioOfTheLimitsOfItsSwing) {
  for (const double offset : {0.0, 0.011, -0.023}) {
    const InvertedSliderCrank linkage = {0.09, 0.041, offset, 0.3};
    const auto result = quick_return(linkage);
    ASSERT_TRUE(result);
    EXPECT_FALSE(result->lever_turns);
    const auto limits =
        roots(linkage, [](const InvertedSliderCrankMotion& motion) { return motion.rates->omega3; });
    ASSERT_EQ(limits.size(), 2U) << offset;
    EXPECT_NEAR(result->time_ratio, ratio_of(limits), 1e-12) << offset;
    const double swing = at(linkage, limits[1]).theta3 - at(linkage, limits[0]).theta3;
    EXPECT_NEAR(result->swing, std::abs(std::remainder(swing, 2 * kPi)), 1e-12) << offset;
  }
}

TEST(QuickReturn, OfWhitworthsHasTheTimeRatioOfTheHalfTurnsAcrossTheFrame) {
  for (const double offset : {0.0, 0.007, -0.013}) {
    const InvertedSliderCrank linkage = {0.03, 0.061, offset, -0.7};
    const auto result = quick_return(linkage);
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->lever_turns);
    EXPECT_EQ(result->swing, 0);
    const auto square = roots(linkage, [&](const InvertedSliderCrankMotion& motion) {
      return std::cos(motion.theta3 - linkage.theta1);
    });
    ASSERT_EQ(square.size(), 2U) << offset;
    EXPECT_NEAR(result->time_ratio, ratio_of(square), 1e-12) << offset;
  }
}

// From a textbook: with a crank half as long as the frame the lever swings by 60 degrees and returns twice as
// fast.
TEST(QuickReturn, ComesBackTwiceAsFastWithACrankOfHalfTheFrame) {
  const auto result = quick_return({0.062, 0.031, 0, 0});
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->swing, kPi / 3, 1e-15);
  EXPECT_NEAR(result->time_ratio, 2, 1e-14);
}

TEST(QuickReturn, IsNoneWhereTheCrankDoesNotTurnFully) {
  EXPECT_FALSE(quick_return({0.05, 0.04, 0.02, 0}));
  EXPECT_FALSE(quick_return({0.05, 0.04, -0.01, 0}));
  EXPECT_FALSE(quick_return({0.05, 0.05, 0, 0}));
}

}  // namespace
}  // namespace higherpair
