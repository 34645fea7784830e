// Forces inside dyads: each body is in balance with them.
#include "higherpair/linkage/dyad_statics.hpp"

#include "linkage/linkage_testing.hpp"

#include <gtest/gtest.h>

namespace higherpair::testing {
namespace {

constexpr int kDyads = 1000;
constexpr double kRounding = 1e-12;  // for moments of about 1 and sines above 0.1

TEST(DyadStatics, TwoLinksTurnEachOtherNowhere) {
  Random random(5);
  for (int i = 0; i < kDyads; ++i) {
    const Vector2d a = random.vector(1), b = random.vector(1);
    const double on_a = random.between(-1, 1), on_b = random.between(-1, 1);
    if (std::abs(cross(a, b)) < 0.1 * a.norm() * b.norm() || a.norm() < 0.1 || b.norm() < 0.1) continue;
    const Vector2d C = rrr_inner_force(a, b, on_a, on_b);
    EXPECT_NEAR(cross(a, C) + on_a, 0, kRounding);
    EXPECT_NEAR(cross(b, Vector2d(-C)) + on_b, 0, kRounding);
  }
}

TEST(DyadStatics, ALinkOnALineCarriesWhatIsAlongIt) {
  Random random(6);
  for (int i = 0; i < kDyads; ++i) {
    const Vector2d arm = random.vector(1), u = unit_vector(random.angle());
    const double moment = random.between(-1, 1), along = random.between(-1, 1);
    if (std::abs(arm.dot(u)) < 0.1) continue;
    const Vector2d C = rrp_inner_force(arm, u, moment, along);
    EXPECT_NEAR(cross(arm, C) + moment, 0, kRounding);
    // The force -C acts on the slider, and along u nothing else but `along`.
    EXPECT_NEAR(along - C.dot(u), 0, kRounding);
  }
}

TEST(DyadStatics, AGuideBetweenTwoPinsPassesOnWhatTurnsThem) {
  Random random(7);
  for (int i = 0; i < kDyads; ++i) {
    const Vector2d A = random.vector(1), B = random.vector(1), p = random.vector(1);
    const Vector2d u = unit_vector(random.angle());
    const double s = (B - A).dot(u);
    const double on_a = random.between(-1, 1), on_b = random.between(-1, 1);
    if (std::abs(s) < 0.1) continue;
    const Vector2d N = rpr_inner_force(s, on_a, on_b) * perp(u);
    // With the guide's force at any point p of the guide, and with the moment that the link then needs about
    // A, the slider is in balance.
    const double passed = -on_a - cross(Vector2d(p - A), N);
    EXPECT_NEAR(on_b - cross(Vector2d(p - B), N) - passed, 0, kRounding);
  }
}

}  // namespace
}  // namespace higherpair::testing
