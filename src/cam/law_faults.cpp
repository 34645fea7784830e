#include "law_faults.hpp"

#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace higherpair {
namespace {

// At each end of a polynomial: powers of higher degrees would cancel.
constexpr std::size_t kMostConditions = 12;

using Fault = std::optional<LawFault>;

bool is_finite(const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

// `reached`: the value where the segment begins; none for the first segment.
Fault fault_of_polynomial(const LawSegment& segment, std::optional<double> reached, double largest) {
  const auto wrong = [](const char* key, std::string rule) { return LawFault{{}, {}, key, std::move(rule)}; };
  for (const auto& [key, conditions] : {std::pair("start", &segment.start), std::pair("end", &segment.end)}) {
    if (conditions->empty()) {
      return wrong(key,
                   "is missing: a polynomial needs its value there, and as many derivatives as are to be "
                   "given, [s, v, a, ...]");
    }
    if (conditions->size() > kMostConditions) {
      return wrong(
          key, fmt::format("has {} conditions: at most {} at each end", conditions->size(), kMostConditions));
    }
  }
  if (segment.rise != 0) {
    return wrong("rise", "a polynomial rises from start to end: leave it out");
  }
  if (reached && !(std::abs(segment.start.front() - *reached) <= kSameLawValue * largest)) {
    return wrong("start",
                 fmt::format("the law would jump: it begins at {} where the segment before ends at {}; "
                             "values in start and end count from 0, not from there",
                             segment.start.front(), *reached));
  }
  return {};
}

Fault fault_of_segment(const LawSegment& segment, std::optional<double> reached, double largest) {
  const auto wrong = [](const char* key, std::string rule) { return LawFault{{}, {}, key, std::move(rule)}; };
  if (!(segment.over > 0) || !std::isfinite(segment.over)) {
    return wrong("over", "must be > 0");
  }
  if (!std::isfinite(segment.rise) || !is_finite(segment.start) || !is_finite(segment.end) ||
      !is_finite(segment.cosines) || !is_finite(segment.sines)) {
    return wrong("", "has a number that is not finite");
  }
  if (segment.type == LawType::kPolynomial) {
    return fault_of_polynomial(segment, reached, largest);
  }
  if (segment.type == LawType::kDwell && segment.rise != 0) {
    return wrong("rise", "a dwell stays where it is: leave it out, or choose another law");
  }
  for (const auto& [key, conditions] : {std::pair("start", &segment.start), std::pair("end", &segment.end)}) {
    if (!conditions->empty()) {
      return wrong(key, "has a meaning for law = \"polynomial\" only");
    }
  }
  const bool sum = segment.type == LawType::kHarmonics;
  if (sum && segment.cosines.empty() && segment.sines.empty()) {
    return wrong("sines", "is missing: harmonics need sines or cosines, [first, second, ...]");
  }
  if (!sum && !segment.cosines.empty()) {
    return wrong("cosines", "has a meaning for law = \"harmonics\" only");
  }
  if (!sum && !segment.sines.empty()) {
    return wrong("sines", "has a meaning for law = \"harmonics\" only");
  }
  return {};
}

Fault fault_of_segments(const LawDescription& description) {
  double largest = std::abs(description.start);
  for (const LawSegment& segment : description.segments) {
    largest += std::abs(segment.rise);
    for (const auto* conditions : {&segment.start, &segment.end}) {
      largest += conditions->empty() ? 0 : std::abs(conditions->front());
    }
  }
  std::optional<double> reached;
  for (std::size_t i = 0; i < description.segments.size(); ++i) {
    const LawSegment& segment = description.segments[i];
    if (auto fault = fault_of_segment(segment, reached, largest)) {
      fault->segment = i;
      return fault;
    }
    reached = segment.type == LawType::kPolynomial ? segment.end.front()
                                                   : reached.value_or(description.start) + segment.rise;
  }
  return {};
}

Fault fault_of_points(const LawDescription& description) {
  const auto wrong = [](std::optional<std::size_t> point, const char* key, std::string rule) {
    return LawFault{{}, point, key, std::move(rule)};
  };
  const std::vector<Vector2d>& points = description.points;
  if (description.degree != 3 && description.degree != 5) {
    return wrong({}, "degree", "must be 3 or 5");
  }
  if (!(description.smoothing >= 0) || !std::isfinite(description.smoothing)) {
    return wrong({}, "smoothing", "must be >= 0");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) {
      return wrong(i, "", "is not finite");
    }
    if (i > 0 && points[i].x() == points[i - 1].x()) {
      return wrong(i, "",
                   fmt::format("has the same x as the point before, {}: give each x once", points[i].x()));
    }
    if (i > 0 && points[i].x() < points[i - 1].x()) {
      return wrong(i, "",
                   fmt::format("x must grow from point to point: {} comes after {}", points[i].x(),
                               points[i - 1].x()));
    }
  }
  const bool periodic = description.ends == SplineEnds::kPeriodic;
  const std::size_t least = periodic && description.period == 0 ? 4 : 3;
  if (points.size() < least) {
    return wrong({}, "", fmt::format("a spline needs at least {} points, found {}", least, points.size()));
  }
  if (periodic && description.period != 0 &&
      !(description.period > points.back().x() - points.front().x() && std::isfinite(description.period))) {
    return wrong({}, "period", "must be longer than the points are apart");
  }
  return {};
}

}  // namespace

std::optional<LawFault> fault_of(const LawDescription& description) {
  if (!std::isfinite(description.origin) || !std::isfinite(description.start)) {
    return LawFault{{}, {}, "origin", "must be finite, as start"};
  }
  if (description.segments.empty() == description.points.empty()) {
    return LawFault{{}, {}, "", "a law has either segments or points"};
  }
  return description.points.empty() ? fault_of_segments(description) : fault_of_points(description);
}

}  // namespace higherpair
