#pragma once

#include "geometry/geometry_testing.hpp"
#include "higherpair/geometry/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace higherpair::testing {

/// A boundary of spans that join up.
inline Boundary boundary(std::vector<SpanPtr> spans, bool closed) {
  return *Boundary::make(std::move(spans), closed, 1e-9);
}

/// Checks normal, speed, curvature and its slope against derivatives of the span's points, by central
/// differences at random parameters; errors relative to the size and to the largest curvature there.
inline void expect_span_laws(const Span& span, double size, double tolerance) {
  const Bounds range = span.range();
  const double h = 1e-5 * range.width();
  Worst tangent;
  Worst turn;
  Worst slope;
  for (const double part : {0.013, 0.137, 0.291, 0.503, 0.617, 0.881, 0.987}) {
    const double t = range.low + part * range.width();
    const SpanPoint at = span.at(t);
    const SpanPoint before = span.at(t - h);
    const SpanPoint after = span.at(t + h);
    const double ds = 2 * h * at.speed;
    EXPECT_NEAR(at.n_B.norm(), 1, 1e-14);
    EXPECT_GT(at.speed, 0);
    tangent.see(((after.p_B - before.p_B) / ds - perp(at.n_B)).norm());
    turn.see((cross(before.n_B, after.n_B) / ds - at.kappa) * size);
    slope.see(((after.kappa - before.kappa) / ds - at.slope) * size * size);
    turn.see(-((cross(before.n_B, after.n_B) / ds - at.kappa) * size));
    slope.see(-((after.kappa - before.kappa) / ds - at.slope) * size * size);
  }
  EXPECT_AT_MOST(tangent.value(), tolerance);
  EXPECT_AT_MOST(turn.value(), tolerance);
  EXPECT_AT_MOST(slope.value(), tolerance);
}

/// Checks over random intervals of all lengths that speed and turn of a span lie within its bounds, and that
/// the bounds narrow in proportion to the interval.
inline void expect_bounds(const Span& span, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const Bounds range = span.range();
  for (int k = 0; k < 400; ++k) {
    const double width = range.width() * std::pow(10, -6 * share(engine));
    const double low = range.low + share(engine) * (range.width() - width);
    const Bounds t{low, std::min(low + width, range.high)};
    const auto bounds = span.bounds(t);
    ASSERT_TRUE(bounds) << "seed " << seed << " over " << t.low << " ... " << t.high;
    for (int i = 0; i <= 12; ++i) {
      const double place = i == 0 ? t.low : i == 12 ? t.high : t.low + share(engine) * t.width();
      const SpanPoint point = span.at(place);
      const double speed = span.is_corner() ? 0 : point.speed;
      const double turn = span.is_corner() ? 1 : point.kappa * point.speed;
      EXPECT_TRUE(bounds->speed.contains(speed)) << seed << " at " << place << ": " << speed;
      const double rounding = 1e-15 * std::abs(turn) + 1e-13 / range.width();  // of the curvature
      EXPECT_TRUE(bounds->turn.low - rounding <= turn && turn <= bounds->turn.high + rounding)
          << seed << " at " << place << ": " << turn;
    }
  }
  for (int k = 0; k < 100; ++k) {
    const double middle = range.low + (0.01 + 0.98 * share(engine)) * range.width();
    const auto over = [&](double half) {
      return *span.bounds({middle - half * range.width(), middle + half * range.width()});
    };
    const SpanBounds wide = over(1e-4);
    const SpanBounds narrow = over(1e-6);
    const auto rounding = [](const Bounds& bounds) {
      return 1e-10 * std::max(std::abs(bounds.low), std::abs(bounds.high));
    };
    EXPECT_LE(narrow.speed.width(), wide.speed.width() / 30 + rounding(wide.speed))
        << seed << " at " << middle;
    EXPECT_LE(narrow.turn.width(), wide.turn.width() / 30 + rounding(wide.turn) + 1e-10 / range.width())
        << seed << " at " << middle;
  }
}

}  // namespace higherpair::testing
