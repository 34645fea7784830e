// Chains of discs and ovals in contact: where they give rows, these agree with those of a run that follows
// the motion.
#include "analysis/chain_testing.hpp"
#include "analysis/random_cam.hpp"
#include "linkage/four_bar_motion.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair::testing {
namespace {

struct Counts {
  int proven = 0;
  int refused = 0;
};

Counts compare_many(CamShape first, CamShape second, unsigned cams, double scale, double way) {
  Counts counts;
  for (unsigned seed = 1; seed <= cams && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Mechanism mechanism = RandomCam(seed, scale).build(first, second);
    const bool turns = mechanism.joints[0].type == JointType::kRevolute;
    const double start = turns ? mechanism.bodies[1].guess_theta : 0.0;
    const std::size_t rows = 30 + 10 * (seed % 30);
    const Outcome outcome =
        compare(mechanism, turn(start, (seed % 2 == 0 ? way : -way) * (turns ? 1 : 0.2 * scale), rows));
    counts.proven += outcome == Outcome::kProven ? 1 : 0;
    counts.refused += outcome == Outcome::kNotProven ? 1 : 0;
  }
  return counts;
}

constexpr CamShape kShapes[] = {CamShape::kDisc, CamShape::kOval, CamShape::kEdge};

TEST(ChainContacts, ShortWaysOfRandomPairsAreThoseOfARun) {
  for (const CamShape first : kShapes) {
    for (const CamShape second : kShapes) {
      SCOPED_TRACE(static_cast<int>(first) * 10 + static_cast<int>(second));
      const Counts counts = compare_many(first, second, 150, 1, 0.5);
      if (first == CamShape::kEdge && second == CamShape::kEdge) {
        EXPECT_EQ(counts.proven + counts.refused, 0);
      } else {
        EXPECT_GT(counts.proven, 60);
        EXPECT_GT(counts.refused, 0);
      }
    }
  }
}

// Most pairs come to a limit within a whole turn, which must not be passed over.
TEST(ChainContacts, WholeTurnsOfRandomPairsAreThoseOfARun) {
  for (const CamShape first : {CamShape::kDisc, CamShape::kOval}) {
    for (const CamShape second : kShapes) {
      const Counts counts = compare_many(first, second, 200, 1, 2 * kPi);
      EXPECT_GT(counts.proven, 4);
      EXPECT_GT(counts.refused, 60);
    }
  }
}

TEST(ChainContacts, LengthsOfAnyOrderAreAllTheSame) {
  for (const double scale : {1e-6, 1e-3, 1e3}) {
    SCOPED_TRACE(scale);
    EXPECT_GT(compare_many(CamShape::kOval, CamShape::kOval, 60, scale, 0.5).proven, 20);
    EXPECT_GT(compare_many(CamShape::kDisc, CamShape::kDisc, 60, scale, 0.5).proven, 20);
  }
}

// An eccentric disc turning about (0, 0) under a roller on an arm about (8, 0).
struct Eccentric {
  double eccentricity = 1, disc = 2, roller = 1.5, arm = 6, distance = 8;

  [[nodiscard]] Mechanism mechanism() const {
    Builder b;
    const int cam = b.body("cam", {0, 0}, 0);
    const double d = distance - eccentricity;
    const double reach = disc + roller;
    const double x = (d * d + reach * reach - arm * arm) / (2 * d);
    const Vector2d center(eccentricity + x, std::sqrt(reach * reach - x * x));
    const int follower = b.body("follower", {distance, 0}, 0);
    b.drive(b.revolute(0, cam, {0, 0}));
    b.revolute(0, follower, {distance, 0});
    b.contact(b.circle(cam, {eccentricity, 0}, disc), b.circle(follower, center, roller));
    return b.mechanism;
  }
};

TEST(ChainContacts, DiscsAreTheFourBarOfTheirCentres) {
  const Eccentric pair;
  const Mechanism mechanism = pair.mechanism();
  const auto rows = turn(0, 2 * kPi, 181);
  auto chain = DyadChain::of(
      mechanism, *make_plan(mechanism), rows,
      {{2, std::nullopt, ChainColumn::Quantity::kAngle}, {2, std::nullopt, ChainColumn::Quantity::kAlpha}});
  ASSERT_TRUE(chain);
  ASSERT_TRUE(chain->solve(mechanism));
  const FourBar linkage{pair.distance, pair.eccentricity, pair.disc + pair.roller, pair.arm, 0};
  double first = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const FourBarMotion motion = four_bar_by_crank(
        linkage, {rows[k].position, rows[k].velocity, rows[k].acceleration}, AssemblyMode::kMinus);
    first = k == 0 ? motion.theta4 : first;
    ASSERT_NEAR(std::remainder(chain->values(0)[k] - (motion.theta4 - first), 2 * kPi), 0, 1e-14);
    ASSERT_NEAR(chain->values(1)[k], motion.rates->alpha4, 1e-13);
  }
}

// The follower can, or cannot, just be lifted over the top of the cam. The critical window lies between two
// rows and is far narrower than a step.
TEST(ChainContacts, LimitsBetweenTwoRowsAreNotPassedOver) {
  for (const double short_by : {1e-3, 1e-5, 1e-8, -1e-8, -1e-5}) {
    SCOPED_TRACE(short_by);
    Eccentric pair;
    pair.arm = pair.distance + pair.eccentricity - (pair.disc + pair.roller) - short_by;
    EXPECT_NE(compare(pair.mechanism(), turn(0.05, 2 * kPi - 0.1, 60)), Outcome::kProven);
  }
}

TEST(ChainContacts, RollingPartingAndConcaveContactsAreNotForThem) {
  const auto is_chain = [](const Mechanism& mechanism) {
    const auto plan = make_plan(mechanism);
    return plan && DyadChain::of(mechanism, *plan, turn(0, 1, 9), {}).has_value();
  };
  const Mechanism plain = Eccentric().mechanism();
  EXPECT_TRUE(is_chain(plain));
  Mechanism other = plain;
  other.contacts[0].keep = Keep::kGap;
  EXPECT_FALSE(is_chain(other));
  other = plain;
  other.contacts[0].rolling = true;
  EXPECT_FALSE(is_chain(other));
  other = plain;
  other.bodies[1].curves[0].curve = make_circle({1, 0}, 20, Side::kOutside).value();
  EXPECT_FALSE(is_chain(other));
  other.bodies[1].curves[0].curve = make_parabola({1, 0}, 2, 0).value();
  EXPECT_FALSE(is_chain(other));
  other.bodies[1].curves[0].curve = make_line({1, 0}, {1, 0}).value();
  EXPECT_FALSE(is_chain(other));
}

// A curve that is an ellipse in one variant may be a circle, or no oval at all, in the next.
TEST(ChainContacts, VariantsMayBeOfOtherShapes) {
  const Mechanism plain = Eccentric().mechanism();
  const auto rows = turn(0, 2 * kPi, 91);
  auto chain =
      DyadChain::of(plain, *make_plan(plain), rows, {{2, std::nullopt, ChainColumn::Quantity::kAlpha}});
  ASSERT_TRUE(chain);
  ASSERT_TRUE(chain->solve(plain));
  const std::vector<double> first(chain->values(0).begin(), chain->values(0).end());
  Mechanism oval = plain;
  oval.bodies[1].curves[0].curve = make_ellipse({1, 0}, {2.2, 1.9}, 0.3).value();
  ASSERT_TRUE(chain->solve(oval));
  EXPECT_NE(chain->values(0)[17], first[17]);
  Mechanism open = plain;
  open.bodies[1].curves[0].curve = make_parabola({-1, 0}, 2, kPi).value();
  EXPECT_FALSE(chain->solve(open));
  ASSERT_TRUE(chain->solve(plain));
  EXPECT_TRUE(std::equal(first.begin(), first.end(), chain->values(0).begin()));
}

}  // namespace
}  // namespace higherpair::testing
