// Rows of discs and ovals that touch: where they are given they are those of a run that follows the motion.
#include "analysis/chain_testing.hpp"
#include "higherpair/linkage/four_bar.hpp"
#include "linkage/linkage_testing.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair::testing {
namespace {

enum class Shape { kDisc, kOval, kEdge };

Vector2d turned(const Vector2d& v, double angle) {
  return Rotation<double>::from_angle(angle) * v;
}

// A cam on ground and a follower on ground that touch at a place, with the shapes given; behind the follower
// maybe two links. Well away from limits where it starts, but not on its way.
class CamBuilder {
public:
  CamBuilder(unsigned seed, double scale) : random_(seed), scale_(scale) {}

  Mechanism build(Shape first, Shape second) {
    const int cam = b_.body("cam", place(), random_.angle());
    const int follower = b_.body("follower", place(), random_.angle());
    const bool cam_turns = random_.between(0, 1) < 0.8;
    b_.drive(cam_turns ? b_.revolute(0, cam, place()) : b_.prismatic(0, cam, place(), heading(), 0));
    const Vector2d p = place(), n = heading();
    const CurveRef on_cam = curve(first, cam, p, n);
    const CurveRef on_follower = curve(second, follower, p, -n);
    if (chance()) {
      b_.revolute(0, follower, p + length(0.4, 1.5) * turned(n, sign() * random_.between(0.7, 2.4)));
    } else {
      b_.prismatic(0, follower, p, turned(n, random_.between(-1, 1)), 0.2 * scale_);
    }
    chance() ? b_.contact(on_cam, on_follower) : b_.contact(on_follower, on_cam);
    if (chance()) {
      links_behind(follower);
    }
    return b_.mechanism;
  }

private:
  Vector2d place() { return {length(-1, 1), length(-1, 1)}; }
  Vector2d heading() { return turned(Vector2d(1, 0), random_.angle()); }
  double length(double low, double high) { return scale_ * random_.between(low, high); }
  double sign() { return chance() ? 1 : -1; }
  bool chance() { return random_.between(0, 1) < 0.5; }

  // The curve of a body whose outward normal at p is n.
  CurveRef curve(Shape shape, int body, const Vector2d& p, const Vector2d& n) {
    if (shape == Shape::kEdge) {
      return b_.edge(body, p);
    }
    const double radius = length(0.1, 0.8);
    return shape == Shape::kDisc ? b_.circle(body, p - radius * n, radius)
                                 : b_.ellipse_at(body, p, n, {radius, length(0.2, 0.6)}, random_.angle());
  }

  void links_behind(int follower) {
    const Vector2d C = place(), u = heading();
    const int a = b_.body("a", place(), random_.angle());
    const int b = b_.body("b", place(), random_.angle());
    b_.revolute(follower, a, C + length(0.5, 1) * u);
    b_.revolute(a, b, C);
    b_.revolute(b, 0, C + length(0.5, 1) * turned(u, sign() * random_.between(0.9, 2.2)));
  }

  Random random_;
  double scale_;
  Builder b_;
};

struct Counts {
  int proven = 0;
  int refused = 0;
};

Counts compare_many(Shape first, Shape second, unsigned cams, double scale, double way) {
  Counts counts;
  for (unsigned seed = 1; seed <= cams && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Mechanism mechanism = CamBuilder(seed, scale).build(first, second);
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

constexpr Shape kShapes[] = {Shape::kDisc, Shape::kOval, Shape::kEdge};

TEST(ChainContacts, ShortWaysOfRandomPairsAreThoseOfARun) {
  for (const Shape first : kShapes) {
    for (const Shape second : kShapes) {
      SCOPED_TRACE(static_cast<int>(first) * 10 + static_cast<int>(second));
      const Counts counts = compare_many(first, second, 150, 1, 0.5);
      if (first == Shape::kEdge && second == Shape::kEdge) {
        EXPECT_EQ(counts.proven + counts.refused, 0);
      } else {
        EXPECT_GT(counts.proven, 60);
        EXPECT_GT(counts.refused, 0);
      }
    }
  }
}

// Most come to a limit on a whole turn, which must not be passed over.
TEST(ChainContacts, WholeTurnsOfRandomPairsAreThoseOfARun) {
  for (const Shape first : {Shape::kDisc, Shape::kOval}) {
    for (const Shape second : kShapes) {
      const Counts counts = compare_many(first, second, 200, 1, 2 * kPi);
      EXPECT_GT(counts.proven, 10);
      EXPECT_GT(counts.refused, 60);
    }
  }
}

TEST(ChainContacts, LengthsOfAnyOrderAreAllTheSame) {
  for (const double scale : {1e-6, 1e-3, 1e3}) {
    SCOPED_TRACE(scale);
    EXPECT_GT(compare_many(Shape::kOval, Shape::kOval, 60, scale, 0.5).proven, 20);
    EXPECT_GT(compare_many(Shape::kDisc, Shape::kDisc, 60, scale, 0.5).proven, 20);
  }
}

// An eccentric disc about (0, 0) under a roller on an arm about (8, 0).
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

// The follower can just, or just not, be lifted over the top of the cam: within a window far narrower than a
// step, between two rows.
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

// What is an ellipse of one variant may be a circle, or no oval at all, of the next.
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
