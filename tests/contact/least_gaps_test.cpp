#include "higherpair/contact/least_gaps.hpp"

#include "higherpair/contact/separation.hpp"
#include "higherpair/geometry/support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

// The local minima of the gap over all normals, by a fine grid and the parabola through three values.
std::vector<double> least_on_grid(const Curve& curve1, const Pose<double>& X_W1, const Curve& curve2,
                                  const Pose<double>& X_W2, int count = 40'000) {
  const auto placed1 = place(curve1, X_W1), placed2 = place(curve2, X_W2);
  std::vector<double> gaps;
  for (int i = 0; i < count; ++i) {
    const Vector2d n = unit_vector(2 * kPi * i / count), inward = -n;
    const bool exist = has_point(placed1, n) && has_point(placed2, inward);
    gaps.push_back(exist ? (support_point(placed2, inward).p_W - support_point(placed1, n).p_W).dot(n) : NAN);
  }
  std::vector<double> least;
  for (int i = 0; i < count; ++i) {
    const double before = gaps[(i + count - 1) % count], here = gaps[i], after = gaps[(i + 1) % count];
    if (here <= before && here < after) {
      least.push_back(here - (after - before) * (after - before) / (8 * (before - 2 * here + after)));
    }
  }
  std::sort(least.begin(), least.end());
  return least;
}

class Random {
public:
  explicit Random(unsigned seed) : random_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Curve body() { return make_ellipse(place(), {between(0.3, 2), between(0.3, 2)}, between(0, kPi)).value(); }
  Curve ring(unsigned kind) {
    const double turn = between(-kPi, kPi);
    switch (kind) {
      case 0:
        return make_circle(place(), between(1, 3), Side::kOutside).value();
      case 1:
        return make_ellipse(place(), {between(1, 3), between(1, 3)}, turn, Side::kOutside).value();
      case 2:
        return make_parabola(place(), between(0.2, 2), turn, Side::kOutside).value();
      default:
        return make_hyperbola(place(), {between(0.5, 2), between(0.5, 2)}, turn, Side::kOutside).value();
    }
  }
  Pose<double> pose() { return {Rotation<double>::from_angle(between(-kPi, kPi)), place()}; }

private:
  Vector2d place() { return {between(-0.2, 0.2), between(-0.2, 0.2)}; }
  std::mt19937 random_;
};

constexpr double kAll = std::numeric_limits<double>::infinity();

std::vector<double> gaps_of(const std::vector<CommonNormal>& normals) {
  std::vector<double> gaps;
  for (const CommonNormal& at : normals) {
    gaps.push_back(at.gap());
  }
  std::sort(gaps.begin(), gaps.end());
  return gaps;
}

TEST(LeastGaps, AreAllThatAFineGridShows) {
  std::size_t most = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    Random random(seed);
    const Curve ring = random.ring(seed % 4), body = random.body();
    const Pose<double> X_W1 = random.pose(), X_W2 = random.pose();
    const auto expected = least_on_grid(body, X_W1, ring, X_W2);
    const auto found = gaps_of(least_gaps(body, X_W1, ring, X_W2, kAll));
    ASSERT_EQ(found.size(), expected.size()) << seed;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i], expected[i], 1e-7) << seed;
    }
    most = std::max(most, found.size());
  }
  EXPECT_GT(most, 1U);
}

TEST(LeastGaps, AreThoseWithinReachWhicheverBodyIsFirst) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const Curve ring = random.ring(seed % 4), body = random.body();
    const Pose<double> X_W1 = random.pose(), X_W2 = random.pose();
    auto all = gaps_of(least_gaps(body, X_W1, ring, X_W2, kAll));
    std::erase_if(all, [](double gap) { return gap > 0.5; });
    EXPECT_EQ(gaps_of(least_gaps(body, X_W1, ring, X_W2, 0.5)).size(), all.size()) << seed;
    const auto exchanged = gaps_of(least_gaps(ring, X_W2, body, X_W1, 0.5));
    ASSERT_EQ(exchanged.size(), all.size()) << seed;
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_NEAR(exchanged[i], all[i], 1e-13) << seed;
    }
  }
}

TEST(LeastGaps, AreWithoutTheOneThatIsKnown) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const Curve ring = random.ring(seed % 4), body = random.body();
    const Pose<double> X_W1 = random.pose(), X_W2 = random.pose();
    const auto all = least_gaps(body, X_W1, ring, X_W2, kAll);
    for (const CommonNormal& known : all) {
      auto expected = gaps_of(all);
      std::erase(expected, known.gap());
      EXPECT_EQ(gaps_of(least_gaps(body, X_W1, ring, X_W2, kAll, &known.n_W)), expected) << seed;
    }
  }
}

// An ellipse in the middle of an ellipse with the same axes is nearest to it at points of symmetry, where
// arcs of a regular subdivision end.
TEST(LeastGaps, AreFoundAtTheEndsOfTheAxes) {
  const Pose<double> origin;
  const Curve ring = make_ellipse({0, 0}, {3, 2}, 0, Side::kOutside).value();
  const Curve slender = make_ellipse({0, 0}, {2.9, 0.5}, 0).value();
  const auto ends = least_gaps(slender, origin, ring, origin, kAll);
  ASSERT_EQ(ends.size(), 2U);
  for (const CommonNormal& at : ends) {
    EXPECT_NEAR(at.gap(), 0.1, 1e-15);
    EXPECT_NEAR(std::abs(at.n_W.x()), 1, 1e-15);
  }
}

// With semi-axes a, b and a - e, b - e, the gap along the normal at φ is √(a² c² + b² s²) less the same of
// the other: to first order e (a c² + b s²)/√(a² c² + b² s²), least at c² = b/(a + b).
TEST(LeastGaps, OfNearlyConformingEllipsesAreFound) {
  const Pose<double> origin;
  const Curve ring = make_ellipse({0, 0}, {3, 2}, 0, Side::kOutside).value();
  for (const double e : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11}) {
    const Curve near = make_ellipse({0, 0}, {3 - e, 2 - e}, 0).value();
    const auto gaps = gaps_of(least_gaps(near, origin, ring, origin, kAll));
    ASSERT_EQ(gaps.size(), 4U) << e;
    for (const double gap : gaps) {
      EXPECT_NEAR(gap / e, 2 * std::sqrt(6) / 5, 0.1 * e + 1e-14 / e) << e;
    }
  }
}

// Bodies that nearly conform to their rings: the bounds by which the separation is found otherwise do not
// tell their arcs apart.
TEST(LeastGaps, TheLeastOfAllIsTheSeparation) {
  for (unsigned seed = 0; seed < 2'000; ++seed) {
    Random random(seed);
    const double play = std::pow(10, random.between(-6, -0.3));
    const double a = random.between(0.5, 3), b = a * std::pow(10, random.between(-1.5, 0));
    const double turn = random.between(-3, 3);
    const Curve ring = make_ellipse({0, 0}, {a, b}, turn, Side::kOutside).value();
    const Vector2d center(play * random.between(-1, 1), play * random.between(-1, 1));
    const Curve body = make_ellipse(center, {a * (1 - play), b * (1 - play * random.between(0.5, 1.5))},
                                    turn + play * random.between(-1, 1))
                           .value();
    const Pose<double> X_WB = random.pose();
    const auto gaps = gaps_of(least_gaps(body, X_WB, ring, X_WB, kAll));
    ASSERT_FALSE(gaps.empty()) << seed;
    EXPECT_NEAR(gaps.front(), least_on_grid(body, X_WB, ring, X_WB, 10'000).front(), 1e-5 * play) << seed;
    EXPECT_NEAR(gaps.front(), separation(body, X_WB, ring, X_WB, 1e-12).gap, 3e-12) << seed;
  }
}

// An ellipse that touches an ellipse around it and overlaps it slightly 22 degrees beside that.
TEST(LeastGaps, OfWhichOneIsBesideAnotherAreTold) {
  constexpr double kRadians = kPi / 180;
  const Curve ring = make_ellipse({0, 0}, {42.737261914307936, 36.14534254690473}, 0, Side::kOutside).value();
  const Curve body =
      make_ellipse({0, 0}, {28.38657852025659, 23.621988036971494}, -1.6036259343962198 * kRadians).value();
  const Pose<double> X_W1{Rotation<double>::from_angle(297.98 * kRadians),
                          {-1.3010623976950921, 0.14974229014423418}};
  const Pose<double> X_W2{Rotation<double>::from_angle(-9.499769213685061 * kRadians),
                          {16.634952423598413, 2.1792928587087563}};
  const auto gaps = gaps_of(least_gaps(body, X_W1, ring, X_W2, 1));
  ASSERT_EQ(gaps.size(), 2U);
  EXPECT_NEAR(gaps[0], -0.000400033, 1e-9);
  EXPECT_NEAR(gaps[1], 0, 1e-12);
}

TEST(LeastGaps, AreFollowedAsTheBodiesMove) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const Curve ring = random.ring(seed % 4), body = random.body();
    const Pose<double> X_W1 = random.pose(), X_W2 = random.pose();
    const Pose<double> moved{X_W1.R_WB, X_W1.p_WB + Vector2d(1e-7, -2e-7)};
    for (const CommonNormal& before : least_gaps(body, X_W1, ring, X_W2, kAll)) {
      const auto after = moved_least_gap(body, moved, ring, X_W2, before);
      ASSERT_TRUE(after.has_value()) << seed;
      EXPECT_NEAR(after->gap() - before.gap(), -Vector2d(1e-7, -2e-7).dot(before.n_W), 1e-11) << seed;
    }
  }
}

}  // namespace
}  // namespace higherpair
