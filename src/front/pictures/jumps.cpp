#include "jumps.hpp"

#include "column_scales.hpp"
#include "front/tolerances.hpp"
#include "higherpair/numeric/contains.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace higherpair {
namespace {

// By how much a step has to exceed the neighbouring ones to be a jump; none: the values are continuous at
// such an event. After a branch ends, the motion is on another branch even if the step is small.
std::optional<double> least_growth(EventType type) {
  switch (type) {
    case EventType::kLimitPosition:
    case EventType::kEnd:
      return kStepOntoBranch;
    case EventType::kSecondContact:
    case EventType::kContactOpen:
    case EventType::kCurvatureJump:
    case EventType::kCorner:
    case EventType::kEngage:
    case EventType::kRelease:
    case EventType::kLawJump:
      return kStepOfJump;
    case EventType::kDeadPoint:
    case EventType::kStrokeEnd:
    case EventType::kConforming:
    case EventType::kOverlap:
      break;
  }
  return std::nullopt;
}

// The change from the row before; 0 where there is none.
double step_to(std::span<const double> values, std::size_t row) {
  const double step = row > 0 && row < values.size() ? std::abs(values[row] - values[row - 1]) : 0;
  return std::isfinite(step) ? step : 0;
}

}  // namespace

std::vector<std::size_t> jumps_of(std::span<const double> values, const std::vector<Event>& events,
                                  const std::function<std::size_t(std::int64_t)>& index_of) {
  const double largest = largest_of(values);
  std::vector<std::size_t> jumps;
  for (const Event& event : events) {
    const auto growth = least_growth(event.type);
    const std::size_t row = index_of(event.row);
    if (!growth || row == 0 || row >= values.size() || contains(jumps, row)) continue;
    const double usual = std::max(step_to(values, row - 1), step_to(values, row + 1));
    if (step_to(values, row) > std::max(*growth * usual, kNoColumnJump * largest)) jumps.push_back(row);
  }
  std::sort(jumps.begin(), jumps.end());
  return jumps;
}

}  // namespace higherpair
