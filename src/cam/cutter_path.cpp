#include "higherpair/cam/cutter_path.hpp"

#include "higherpair/geometry/contour.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// By bisection where dκ/ds changes sign from - to +; otherwise one of the ends.
SpanPoint least_curvature(const Span& span, double from, double to, double& at) {
  double low = from;
  double high = to;
  if (span.at(from).slope < 0 && span.at(to).slope > 0) {
    for (int i = 0; i < 60; ++i) {
      const double half = low + (high - low) / 2;
      (span.at(half).slope < 0 ? low : high) = half;
    }
  } else if (span.at(to).kappa < span.at(from).kappa) {
    low = to;
  }
  at = low;
  return span.at(low);
}

tl::expected<Boundary, OffsetFault> offset_of(const Boundary& flank, double radius) {
  auto spans = offset_spans(flank, radius);
  if (!spans) {
    return tl::unexpected(spans.error());
  }
  auto path = Boundary::make(*std::move(spans), flank.is_closed(), kOffsetMeets * (flank.size() + radius));
  // Fails for a span whose offset turns back between the samples taken by offset_spans.
  return path ? tl::expected<Boundary, OffsetFault>(*std::move(path))
              : tl::unexpected(OffsetFault{OffsetFault::Kind::kCusp});
}

bool can_cut(const Boundary& flank, double radius) {
  const auto path = offset_of(flank, radius);
  return path && !find_self_crossing(*path);
}

// The largest radius below `too_large` that can cut.
double largest_cutter(const Boundary& flank, double too_large) {
  double good = 0;
  double bad = too_large;
  while (bad - good > kBisectedRadius * too_large) {
    const double half = (good + bad) / 2;
    (can_cut(flank, half) ? good : bad) = half;
  }
  return good;
}

}  // namespace

HollowestPlace hollowest_place(const Boundary& boundary) {
  HollowestPlace least;
  least.point.kappa = kInf;
  for (std::size_t i = 0; i < boundary.spans().size(); ++i) {
    const Span& span = *boundary.spans()[i];
    const Bounds range = span.range();
    const int probes = span.is_corner() ? 0 : 4 * span.parts();
    for (int k = 0; k < probes; ++k) {
      const double from = range.low + range.width() * k / probes;
      const double to = k + 1 == probes ? range.high : range.low + range.width() * (k + 1) / probes;
      double at = from;
      const SpanPoint point = least_curvature(span, from, to, at);
      if (point.kappa < least.point.kappa) {
        least = {{static_cast<int>(i), at}, point};
      }
    }
  }
  return least;
}

tl::expected<Boundary, CutterFault> cutter_path(const Boundary& flank, double radius) {
  using Kind = CutterFault::Kind;
  auto path = offset_of(flank, radius);
  if (!path && path.error().kind == OffsetFault::Kind::kCorner) {
    return tl::unexpected(CutterFault{Kind::kNotch, path.error().at_B, 0});
  }
  const HollowestPlace hollow = hollowest_place(flank);
  const double limit = hollow.point.kappa < 0 ? -1 / hollow.point.kappa : kInf;
  if (!path || radius > limit * (1 + kSameCutterRadius)) {
    const double below = limit * (1 - kJustBelowCutter);
    return tl::unexpected(CutterFault{Kind::kHollow, hollow.point.p_B,
                                      can_cut(flank, below) ? limit : largest_cutter(flank, below)});
  }
  if (const auto crossing = find_self_crossing(*path)) {
    return tl::unexpected(CutterFault{Kind::kCrossing, crossing->p_B, largest_cutter(flank, radius)});
  }
  return *std::move(path);
}

}  // namespace higherpair
