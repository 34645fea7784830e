#include "higherpair/linkage/four_bar_limits.hpp"

#include "higherpair/linkage/grashof.hpp"
#include "linkage/four_bar_motion.hpp"
#include "linkage/linkage_testing.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

constexpr std::array kMovingLinks{FourBarLink::kCrank, FourBarLink::kCoupler, FourBarLink::kRocker};

FourBar any_four_bar(Random& random) {
  const double r1 = random.between(0.2, 3), r2 = random.between(0.2, 3), r3 = random.between(0.2, 3);
  return {r1, r2, r3, random.between(0.2, 3), random.angle()};
}

double limit_angle(const FourBarLimit& limit, FourBarLink link) {
  if (link == FourBarLink::kCrank) return limit.theta2;
  return link == FourBarLink::kCoupler ? limit.theta3 : limit.theta4;
}

TEST(FourBarLimits, CloseTheLoopWithTheTwoOtherLinksInLine) {
  Random random(91);
  Worst closure, line;
  int count = 0;
  for (int i = 0; i < 5000; ++i) {
    const FourBar linkage = any_four_bar(random);
    const double size = std::max({linkage.r1, linkage.r2, linkage.r3, linkage.r4});
    for (const FourBarLink link : kMovingLinks) {
      for (const FourBarLimit& limit : four_bar_limits(linkage, link)) {
        const auto gap = linkage.r2 * direction(limit.theta2) + linkage.r3 * direction(limit.theta3) -
                         linkage.r1 * direction(linkage.theta1) - linkage.r4 * direction(limit.theta4);
        closure.see(std::abs(gap) / size);
        const double one = link == FourBarLink::kCrank ? limit.theta3 : limit.theta2;
        const double other = link == FourBarLink::kRocker ? limit.theta3 : limit.theta4;
        line.see(angle_error(one, limit.same_direction ? other : other + kPi));
        EXPECT_FALSE(limit.change_point);
        ++count;
      }
    }
  }
  EXPECT_GT(count, 10000);
  EXPECT_AT_MOST(closure.value(), 4e-15);
  EXPECT_AT_MOST(line.value(), 1e-15);
}

TEST(FourBarLimits, AreTheEndsOfTheRangeOfTheLinkAsADriver) {
  Random random(92);
  Worst worst;
  for (int i = 0; i < 5000; ++i) {
    const FourBar linkage = any_four_bar(random);
    const FourBar from_O4{linkage.r1, linkage.r4, linkage.r3, linkage.r2, linkage.theta1 + kPi};
    const std::array<DriverRange, 3> ranges{four_bar_crank_range(linkage), four_bar_coupler_range(linkage),
                                            four_bar_crank_range(from_O4)};
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<double> angles;
      for (const FourBarLimit& limit : four_bar_limits(linkage, kMovingLinks[k])) {
        angles.push_back(limit_angle(limit, kMovingLinks[k]));
      }
      ASSERT_EQ(angles.size(), static_cast<std::size_t>(2 * ranges[k].count));
      for (std::size_t n = 0; n < angles.size() / 2; ++n) {
        worst.see(distance_to_nearest(ranges[k].intervals[n].begin, angles));
        worst.see(distance_to_nearest(ranges[k].intervals[n].end, angles));
      }
    }
  }
  // Where a limit is nearly in line with the ground link, its angle is the square root of a small number.
  EXPECT_AT_MOST(worst.value(), 1e-12);
}

TEST(FourBarLimits, TheLinkStandsStillInTheModeTheyName) {
  Random random(93);
  Worst angle, rate;
  int count = 0;
  for (int i = 0; i < 5000; ++i) {
    const FourBar linkage = any_four_bar(random);
    for (const FourBarLink link : {FourBarLink::kCoupler, FourBarLink::kRocker}) {
      for (const FourBarLimit& limit : four_bar_limits(linkage, link)) {
        if (std::abs(std::sin(limit.theta3 - limit.theta4)) < 0.1) continue;
        const FourBarMotion motion = four_bar_by_crank(linkage, {limit.theta2, 1, 0}, limit.mode);
        ASSERT_TRUE(motion.rates);
        angle.see(angle_error(motion.theta3, limit.theta3) + angle_error(motion.theta4, limit.theta4));
        rate.see(link == FourBarLink::kCoupler ? std::abs(motion.rates->omega3)
                                               : std::abs(motion.rates->omega4));
        ++count;
      }
    }
  }
  EXPECT_GT(count, 5000);
  // The transmission angle is above 0.1 rad: with a long crank, roundings of the crank are magnified up to a
  // few hundred times.
  EXPECT_AT_MOST(angle.value(), 1e-12);
  EXPECT_AT_MOST(rate.value(), 1e-12);
}

TEST(FourBarLimits, OfACrankRockerAreTheTwoTriangles) {
  const FourBar linkage{7, 2, 6, 5, 0.3};
  EXPECT_TRUE(four_bar_limits(linkage, FourBarLink::kCrank).empty());
  const auto limits = four_bar_limits(linkage, FourBarLink::kRocker);
  ASSERT_EQ(limits.size(), 4U);
  // Stretched: 8, 5, 7; folded: 4, 5, 7 with the crank away from the rocker's end.
  const double stretched = std::acos(88.0 / 112), folded = std::acos(40.0 / 56);
  EXPECT_TRUE(limits[0].same_direction && limits[1].same_direction);
  EXPECT_AT_MOST(angle_error(limits[0].theta2, 0.3 + stretched), 1e-15);
  EXPECT_AT_MOST(angle_error(limits[1].theta2, 0.3 - stretched), 1e-15);
  EXPECT_AT_MOST(angle_error(limits[2].theta2, 0.3 + folded + kPi), 1e-15);
  EXPECT_AT_MOST(angle_error(limits[3].theta2, 0.3 - folded + kPi), 1e-15);
  EXPECT_AT_MOST(angle_error(limits[0].theta4, 0.3 + kPi - std::acos(10.0 / 70)), 1e-15);
}

TEST(FourBarLimits, ReproduceTheSwingOfTheArmsInTheTextbookExercise) {
  const auto data = textbook("exercise3_000");
  const double arm = number(data["arm"]);
  const FourBar linkage{number(data["frame_2d"]), arm, number(data["coupler_2a"]), arm, 0};
  const double low = number(data["arm_angle_range_deg"][0]) * kDegree;
  const double high = number(data["arm_angle_range_deg"][1]) * kDegree;
  const auto limits = four_bar_limits(linkage, FourBarLink::kCrank);
  ASSERT_EQ(limits.size(), 4U);
  for (const FourBarLimit& limit : limits) {
    // In the folded limit (coupler and arm 4 in the same direction) the short side 6 subtends the smaller
    // angle.
    EXPECT_AT_MOST(std::abs(std::abs(limit.theta2) - (limit.same_direction ? low : high)), 1e-15);
  }
  EXPECT_TRUE(four_bar_limits(linkage, FourBarLink::kCoupler).empty());
}

TEST(FourBarLimits, MarkChangePoints) {
  const FourBar parallelogram{0.31, 0.17, 0.31, 0.17, 0.4};
  for (const FourBarLink link : {FourBarLink::kCrank, FourBarLink::kRocker}) {
    const auto limits = four_bar_limits(parallelogram, link);
    EXPECT_EQ(limits.size(), 2U);
    for (const FourBarLimit& limit : limits) {
      EXPECT_TRUE(limit.change_point);
      EXPECT_AT_MOST(std::abs(std::sin(limit.theta2 - 0.4)), 1e-15);
      EXPECT_AT_MOST(std::abs(std::sin(limit.theta3 - 0.4)), 1e-15);
    }
  }
  // In the crossed assembly, with the cranks opposite, the coupler has limits. With parallel cranks it does
  // not turn in any position, and can leave this assembly where all links are in line.
  const auto limits = four_bar_limits(parallelogram, FourBarLink::kCoupler);
  EXPECT_EQ(limits.size(), 4U);
  for (const FourBarLimit& limit : limits) {
    EXPECT_EQ(limit.change_point, limit.same_direction);
    if (limit.change_point) {
      EXPECT_AT_MOST(angle_error(limit.theta3, 0.4), 1e-15);
      EXPECT_AT_MOST(angle_error(limit.theta2, limit.theta4), 1e-15);
      EXPECT_AT_MOST(std::abs(std::sin(limit.theta2 - 0.4)), 1e-15);
      continue;
    }
    EXPECT_AT_MOST(std::abs(std::abs(std::sin(0.5 * (limit.theta3 - 0.4))) - 17.0 / 31), 1e-15);
  }
}

// A kite is folded where its two long and its two short links coincide; coupler and rocker can then swing
// together while the crank lies on the frame.
TEST(FourBarLimits, OfAKiteAndARhombusHaveTheFoldedPositions) {
  const auto kite = four_bar_limits({5, 5, 3, 3, 0}, FourBarLink::kCrank);
  ASSERT_EQ(kite.size(), 4U);
  int folded = 0;
  for (const FourBarLimit& limit : kite) {
    folded += limit.change_point ? 1 : 0;
    EXPECT_AT_MOST(angle_error(limit.theta2, limit.change_point ? 0 : limit.theta2), 1e-15);
    // The short links in line: an isosceles triangle 5, 5, 6.
    EXPECT_AT_MOST(limit.change_point ? 0 : std::abs(std::sin(std::abs(limit.theta2) / 2) - 0.6), 1e-15);
  }
  EXPECT_EQ(folded, 2);
  // Crank and coupler of the same length, folded, while the rocker lies on the frame, towards O2.
  for (const FourBarLimit& limit : four_bar_limits({3, 5, 5, 3, 0.2}, FourBarLink::kRocker)) {
    if (!limit.change_point) continue;
    ++folded;
    EXPECT_AT_MOST(angle_error(limit.theta4, 0.2 + kPi), 1e-15);
    EXPECT_AT_MOST(angle_error(limit.theta3, limit.theta2 + kPi), 1e-15);
  }
  EXPECT_EQ(folded, 4);
  const auto rhombus = four_bar_limits({2, 2, 2, 2, 0}, FourBarLink::kCrank);
  ASSERT_EQ(rhombus.size(), 3U);
  for (const FourBarLimit& limit : rhombus) {
    EXPECT_TRUE(limit.change_point);
    EXPECT_AT_MOST(std::abs(std::sin(limit.theta2)), 1e-15);
  }
}

}  // namespace
}  // namespace higherpair
