#pragma once

#include "geometry/geometry_testing.hpp"
#include "higherpair/geometry/boundary.hpp"
#include "higherpair/geometry/span.hpp"

namespace higherpair::testing {

/// Of spans that fit together.
inline Boundary boundary(std::vector<SpanPtr> spans, bool closed) {
  return *Boundary::make(std::move(spans), closed, 1e-9);
}

/// Normal, speed, curvature and its slope of a span are the derivatives of its points, by central differences
/// at uneven places; errors relative to the size and the largest curvature there.
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

}  // namespace higherpair::testing
