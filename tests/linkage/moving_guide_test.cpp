#include "higherpair/linkage/moving_guide.hpp"

#include "linkage/moving_ends.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

TEST(MovingGuide, SeesAPointMoveByTheDerivativesOfWhereItSeesIt) {
  Random random(61);
  RatesCheck check;
  while (check.count() < 2000) {
    const MovingGuide guide = random_guide(random);
    const MovingPoint point = random_point(random);
    const auto values_at = [&](double t) {
      const BodyMotion body = guide.body.at(t);
      // From positions only: the inverse of the body's pose, then of the guide's pose on it.
      const Vector2d p_B = body.X_WB.inverse_times(point.at(t).p_W);
      const Vector2d p_G = guide.u_B.inverse() * Vector2d(p_B - guide.p_B);
      return std::array<double, 2>{p_G.x(), p_G.y()};
    };
    const SeenMotion seen = seen_from(guide.at(0), point.at(0));
    EXPECT_AT_MOST(std::abs(seen.p.x() - values_at(0)[0]) + std::abs(seen.p.y() - values_at(0)[1]), 4e-15);
    check.compare<2>(values_at, {false, false}, {seen.v.x(), seen.v.y()}, {seen.a.x(), seen.a.y()});
  }
  check.expect_small();
}

TEST(MovingGuide, WhatSlidesOnItIsSeenToSlide) {
  Random random(62);
  Worst along, across;
  for (int i = 0; i < 5000; ++i) {
    const GuideMotion guide = random_guide(random).at(0);
    const double s = random.between(-2, 2), s_dot = random.between(-2, 2), s_ddot = random.between(-2, 2);
    const SeenMotion seen = seen_from(guide, slide_motion(guide, s, s_dot, s_ddot));
    along.see(std::abs(seen.p.x() - s) + std::abs(seen.v.x() - s_dot) + std::abs(seen.a.x() - s_ddot));
    across.see(std::abs(seen.p.y()) + std::abs(seen.v.y()) + std::abs(seen.a.y()));
  }
  EXPECT_AT_MOST(along.value(), 2e-14);
  EXPECT_AT_MOST(across.value(), 2e-14);
}

}  // namespace
}  // namespace higherpair
