#include "higherpair/geometry/gear_pair.hpp"

#include "geometry/geometry_testing.hpp"

namespace higherpair {
namespace {

constexpr double kAlpha = 20 * kPi / 180;

InvoluteTooth tooth(double teeth, double shift = 0) {
  return {1, teeth, kAlpha, shift};
}

GearPair pair(double first, double second) {
  return {tooth(first), tooth(second), (first + second) / 2};
}

TEST(GearPair, TheInvoluteFunctionIsTabulated) {
  // Tables of inv α: 14.5° 0.0055448, 20° 0.0149044, 25° 0.0299753.
  EXPECT_NEAR(involute_function(kAlpha), 0.01490438387, 5e-12);
  EXPECT_NEAR(involute_function(14.5 * kPi / 180), 0.0055448, 5e-8);
  EXPECT_NEAR(involute_function(25 * kPi / 180), 0.0299753, 5e-8);
  for (const double alpha : {1e-5, 0.01, 0.35, 1.0, 1.5}) {
    EXPECT_NEAR(inverse_involute(involute_function(alpha)) / alpha, 1, 1e-5 * 1e-5 / alpha / alpha);
  }
  EXPECT_EQ(inverse_involute(0), 0);
}

TEST(GearPair, HasThePathOfContactAndContactRatioOfReferences) {
  const PathOfContact path = path_of_contact(pair(20, 40));
  EXPECT_NEAR(path.ratio, 1.635185964, 5e-10);
  EXPECT_NEAR(path.length(), 4.827283884, 5e-10);
  EXPECT_LT(std::max(path.past_base[0], path.past_base[1]), 0);
  EXPECT_NEAR(path_of_contact(pair(20, 20)).ratio, 1.556838303, 5e-10);
  // By hand for 20/40: √(11² - 9.396926²) - 10 sin 20°, and √(21² - 18.793852²) - 20 sin 20°.
  EXPECT_NEAR(path.recess, 5.718197 - 3.420201, 2e-6);
  EXPECT_NEAR(path.approach, 9.369691 - 6.840403, 2e-6);
}

TEST(GearPair, TheTipOfALargeWheelInterferesWithASmallPinion) {
  const PathOfContact path = path_of_contact(pair(13, 40));
  EXPECT_NEAR(path.past_base[0], 0.306157, 5e-7);
  EXPECT_LT(path.past_base[1], 0);
  // With the gears exchanged the place is the same.
  EXPECT_NEAR(path_of_contact(pair(40, 13)).past_base[1], path.past_base[0], 1e-14);
}

TEST(GearPair, ARackUndercutsFewTeeth) {
  EXPECT_NEAR(least_teeth(kAlpha), 17.0973, 5e-5);
  // The number of teeth for which the rack begins to cut at the base circle.
  EXPECT_NEAR(roll_at_root(tooth(least_teeth(kAlpha))), 0, 1e-15);
  EXPECT_NEAR(roll_at_root(tooth(0.7 * least_teeth(kAlpha), 0.3)), 0, 1e-15);
}

TEST(GearPair, TeethOfAClosePairHaveNoPlay) {
  for (const double shift : {-0.2, 0.0, 0.35, 0.8}) {
    const GearPair close = close_pair(tooth(17, 0.6 * shift), tooth(31, 0.4 * shift));
    EXPECT_NEAR(backlash(close), 0, 1e-13) << shift;
    EXPECT_NEAR(std::cos(working_pressure_angle(close)) * close.distance, 24 * std::cos(kAlpha), 1e-13);
  }
  EXPECT_EQ(close_pair(tooth(17), tooth(31)).distance, 24);
}

// Moving the centres apart opens the gap at each flank by about tan α per unit.
TEST(GearPair, PlayGrowsWithTheDistanceOfTheCentres) {
  GearPair apart = pair(17, 31);
  const double more = 1e-5;
  apart.distance += more;
  EXPECT_NEAR(backlash(apart) / (2 * more * std::tan(kAlpha)), 1, 1e-4);
  // Checked with the flanks themselves: turning the second wheel until its other flank touches is a distance
  // of j cos α_w along the other line of action.
  apart.distance += 0.1;
  const double alpha_w = working_pressure_angle(apart);
  const double pitch = 2 * kPi * std::cos(kAlpha) / 2;  // of the base circles
  const auto base_thickness = [](const InvoluteTooth& t) {
    return 2 * base_radius(t) * half_angle_at_base(t);
  };
  const double play = pitch - base_thickness(apart.first) - base_thickness(apart.second) +
                      (base_radius(apart.first) + base_radius(apart.second)) * 2 * involute_function(alpha_w);
  EXPECT_NEAR(backlash(apart) * std::cos(alpha_w), play, 1e-13);
}

TEST(GearPair, TeethFollowFromRatioDistanceAndModule) {
  const PairTeeth outer = teeth_of_pair(-0.5, 0.06, 0.002);
  EXPECT_TRUE(outer.are_whole);
  EXPECT_NEAR(outer.first, 20, 1e-12);
  EXPECT_NEAR(outer.second, 40, 1e-12);
  const PairTeeth inner = teeth_of_pair(3, 0.04, 0.002);  // a ring about a planet
  EXPECT_NEAR(inner.first, 60, 1e-12);
  EXPECT_NEAR(inner.second, 20, 1e-12);
  EXPECT_FALSE(teeth_of_pair(-0.5, 0.0601, 0.002).are_whole);
}

}  // namespace
}  // namespace higherpair
