#pragma once

#include "higherpair/geometry/bounds.hpp"
#include "higherpair/geometry/support_curve.hpp"
#include "numeric/interval.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace higherpair {

/// What lies between a curve's support h and slope h′ about a reference point, and its radius, over an
/// interval of normals; and h, h′ at its middle.
struct ArcBounds {
  Interval middle_h;
  Interval middle_dh;
  Interval h;
  Interval dh;
  Interval rho;
};

/// \param about  the reference point in the body's frame \param phi  at most a half turn wide. With δ the
/// angle from the middle m and ρ the bounds of the radius over the interval,
///     h = h_m + h′_m sin δ + (ρ - h_m)(1 - cos δ),   h′ = h′_m cos δ + (ρ - h_m) sin δ,
/// since h + h″ = ρ: h = h_m cos δ + h′_m sin δ + ∫ ρ(m+τ) sin(δ-τ) dτ, τ from 0 to δ. |δ| <= π/2.
[[nodiscard]] inline ArcBounds arc_bounds(const SupportCurve& curve, std::size_t piece,
                                          const IntervalVector& about, const Interval& phi) {
  const double m = boost::numeric::median(phi);
  const SupportValue value = curve.at(piece, m);
  const IntervalVector n = unit_interval(m);
  ArcBounds arc;
  arc.middle_h = around(value.h, value.error) - about.dot(n);
  arc.middle_dh = around(value.dh, value.error) - about.dot(n.turned());
  const Bounds rho = curve.radius(piece, to_bounds(phi));
  assert(value.error >= 0 && rho.low <= rho.high);
  arc.rho = to_interval(rho);
  const Interval from_middle = phi - m;
  const double half = std::max(-from_middle.lower(), from_middle.upper());
  const Interval sin_delta(-half, half);
  const Interval versine(0.0, OutwardRounding::mul_up(half, half) / 2);
  const Interval bend = arc.rho - arc.middle_h;
  arc.h = arc.middle_h + arc.middle_dh * sin_delta + bend * versine;
  arc.dh = arc.middle_dh * (1.0 - versine) + bend * sin_delta;
  return arc;
}

}  // namespace higherpair
