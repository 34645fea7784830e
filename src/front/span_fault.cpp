// Checks the spans of a curve that a program made: that their points, normals and curvatures belong together.
#include "model_data.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace higherpair {
namespace {

// The values beside a place in the span.
struct Sample {
  SpanPoint before, at, after;
};

std::vector<Sample> samples_of(const Span& span, double step) {
  const Bounds range = span.range();
  std::vector<Sample> samples;
  for (int i = 0; i < kSpanSamples; ++i) {
    const double t = range.low + (i + kSpanPlace) * range.width() / kSpanSamples;
    samples.push_back({span.at(t - step), span.at(t), span.at(t + step)});
  }
  return samples;
}

bool is_finite(const SpanPoint& point) {
  return point.p_B.allFinite() && point.n_B.allFinite() && std::isfinite(point.kappa) &&
         std::isfinite(point.slope) && std::isfinite(point.speed);
}

bool is_unit(const Vector2d& n) {
  return std::abs(n.norm() - 1) <= kUnitDirection;
}

}  // namespace

// With the parameter's step h, p(t + h) - p(t - h) = 2 h p' with p' = speed t, and the same for the normal,
// n' = κ speed t, each to within a fraction of its largest value.
std::string fault_of(const Span& span) {
  const Bounds range = span.range();
  if (!(std::isfinite(range.width()) && range.low < range.high)) {
    return "its range must be finite and not empty";
  }
  const double step = kSpanStep * range.width();
  double farthest = 0, fastest = 0, sharpest = 0;
  const std::vector<Sample> samples = samples_of(span, step);
  for (const auto& [before, at, after] : samples) {
    if (!is_finite(before) || !is_finite(at) || !is_finite(after)) return "its values must be finite";
    if (!is_unit(at.n_B)) return "its normal must be a unit vector";
    farthest = std::max(farthest, at.p_B.norm());
    fastest = std::max(fastest, std::abs(at.speed));
    sharpest = std::max(sharpest, std::abs(at.kappa * at.speed));
  }
  for (const auto& [before, at, after] : span.is_corner() ? std::vector<Sample>{} : samples) {
    const Vector2d path = 2 * step * at.speed * perp(at.n_B);
    const double rounding = kSpanRounding * farthest + kSpanMismatch * 2 * step * fastest;
    if (!((after.p_B - before.p_B - path).norm() <= rounding)) {
      return "its points must move at its speed along its normal turned +90 degrees";
    }
    const double turn_rounding = kSpanRounding + kSpanMismatch * 2 * step * sharpest;
    if (!((after.n_B - before.n_B - at.kappa * path).norm() <= turn_rounding)) {
      return "its curvature is not that with which its normal turns";
    }
  }
  return "";
}

}  // namespace higherpair
