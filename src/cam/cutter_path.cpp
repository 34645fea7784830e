#include "higherpair/cam/cutter_path.hpp"

#include "higherpair/geometry/contour.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "tolerances.hpp"

#include <utility>

namespace higherpair {
namespace {

// By bisection where dκ/ds changes sign from - to +; otherwise one of the ends.
SpanPoint least_curvature(const Span& span, double from, double to) {
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
  return span.at(low);
}

// The point of least signed curvature on the spans of a boundary except its corners, to within rounding: a
// zero of dκ/ds between samples, four times as many as show the shape. Curvature +∞ if there are only
// corners.
SpanPoint hollowest_point(const Boundary& boundary) {
  SpanPoint least;
  least.kappa = kInf;
  for (const SpanPtr& span : boundary.spans()) {
    const Bounds range = span->range();
    const int probes = span->is_corner() ? 0 : 4 * span->parts();
    for (int k = 0; k < probes; ++k) {
      const double from = range.low + range.width() * k / probes;
      const double to = k + 1 == probes ? range.high : range.low + range.width() * (k + 1) / probes;
      const SpanPoint point = least_curvature(*span, from, to);
      least = point.kappa < least.kappa ? point : least;
    }
  }
  return least;
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

tl::expected<Boundary, CutterFault> cutter_path(const Boundary& flank, double radius) {
  using Kind = CutterFault::Kind;
  auto path = offset_of(flank, radius);
  if (!path && path.error().kind == OffsetFault::Kind::kCorner) {
    return tl::unexpected(CutterFault{Kind::kNotch, path.error().at_B, 0});
  }
  const SpanPoint hollow = hollowest_point(flank);
  const double limit = hollow.kappa < 0 ? -1 / hollow.kappa : kInf;
  if (!path || radius > limit * (1 + kSameCutterRadius)) {
    const double below = limit * (1 - kJustBelowCutter);
    return tl::unexpected(
        CutterFault{Kind::kHollow, hollow.p_B, can_cut(flank, below) ? limit : largest_cutter(flank, below)});
  }
  if (const auto crossing = find_self_crossing(*path)) {
    return tl::unexpected(CutterFault{Kind::kCrossing, crossing->p_B, largest_cutter(flank, radius)});
  }
  return *std::move(path);
}

}  // namespace higherpair
