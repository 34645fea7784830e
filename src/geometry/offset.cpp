#include "higherpair/geometry/contour.hpp"
#include "higherpair/geometry/tolerances.hpp"

#include <cmath>

namespace higherpair {
namespace {

// Where 1 + κ d, the ratio of the offset's length to the span's, is least and largest, sampled four times as
// finely as the span's parts.
struct OffsetStretch {
  SpanPoint least;
  SpanPoint largest;
};

OffsetStretch stretch_of(const Span& span, double distance) {
  const int probes = 4 * span.parts();
  const Bounds range = span.range();
  OffsetStretch stretch = {span.at(range.low), span.at(range.low)};
  for (int k = 1; k <= probes; ++k) {
    const SpanPoint point = span.at(range.low + range.width() * k / probes);
    if (point.kappa * distance < stretch.least.kappa * distance) {
      stretch.least = point;
    }
    if (point.kappa * distance > stretch.largest.kappa * distance) {
      stretch.largest = point;
    }
  }
  return stretch;
}

// An arc that is offset by its radius becomes a point.
bool vanishes(const OffsetStretch& stretch, double distance) {
  return std::abs(1 + stretch.least.kappa * distance) <= kVanishedRadius &&
         std::abs(1 + stretch.largest.kappa * distance) <= kVanishedRadius;
}

std::optional<OffsetFault> cusp(const OffsetStretch& stretch, double distance) {
  if (1 + stretch.least.kappa * distance > kLeastOffsetRadius) {
    return std::nullopt;
  }
  return OffsetFault{OffsetFault::Kind::kCusp, stretch.least.p_B, 1 / std::abs(stretch.least.kappa)};
}

}  // namespace

tl::expected<std::vector<SpanPtr>, OffsetFault> offset_spans(const Boundary& boundary, double distance) {
  std::vector<SpanPtr> spans;
  for (std::size_t i = 0; i < boundary.spans().size(); ++i) {
    const SpanPtr& span = boundary.spans()[i];
    const Bounds range = span->range();
    const bool notch = boundary.joint_after(static_cast<int>(i)) == SpanJoint::kNotch;
    if ((span->is_corner() && distance < 0) || (notch && distance > 0)) {
      return tl::unexpected(OffsetFault{OffsetFault::Kind::kCorner, span->at(range.high).p_B});
    }
    if (span->is_corner()) {
      spans.push_back(conic_span(*make_circle(span->at(range.low).p_B, distance), range.low, range.high));
      continue;
    }
    const OffsetStretch stretch = stretch_of(*span, distance);
    if (!vanishes(stretch, distance)) {
      if (const auto fault = cusp(stretch, distance)) {
        return tl::unexpected(*fault);
      }
      spans.push_back(offset_span(span, distance));
    }
    if (notch) {
      // A concave corner becomes a concave arc, whose normals turn backwards.
      const Vector2d p = span->at(range.high).p_B;
      const SpanPtr& next = boundary.spans()[(i + 1) % boundary.spans().size()];
      const double from = angle_of(span->at(range.high).n_B);
      const double to = nearest_turn(angle_of(next->at(next->range().low).n_B), from);
      spans.push_back(conic_span(*make_circle(p, -distance, Side::kOutside), to, from));
    }
  }
  return spans;
}

}  // namespace higherpair
