#include "limit_events.hpp"

#include "path.hpp"
#include "step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

constexpr double kSamePlace = 1e-9;  // of the driver's scale

const char* cause_of(const Group& group) {
  if (!group.contacts.empty()) {
    return "the two bodies cannot be kept in contact on this branch beyond this position of the driver";
  }
  if (std::holds_alternative<RrrDyad>(group.kind)) {
    return "the links are in line here: beyond this position of the driver they cannot reach each other";
  }
  if (std::holds_alternative<RrpDyad>(group.kind)) {
    return "the link stands at right angles to its slide here: beyond this position of the driver it cannot "
           "reach it";
  }
  if (std::holds_alternative<RprDyad>(group.kind)) {
    return "the two pins are as near as the offset of the slide here: beyond this position of the driver it "
           "cannot lead past both";
  }
  if (std::holds_alternative<SlideDyad>(group.kind)) {
    return "the two slides are parallel here: the point where they meet runs off to infinity";
  }
  return "the bodies cannot be put together on this branch beyond this position of the driver";
}

bool is_same_item(const RunEvent& a, const RunEvent& b) {
  return a.type == b.type && a.joint == b.joint && a.contact == b.contact;
}

}  // namespace

void add_limit(Run& run, std::size_t g, const Path& path, double s) {
  RunEvent event;
  event.type = EventType::kLimitPosition;
  set_place(event, path, s);
  name_item(run, g, event);
  event.cause = cause_of(run.plan.groups[g]);
  report_limit(run, path, std::move(event));
}

double place_of(const Run& run, std::size_t g, const Path& path, const LimitPosition& limit) {
  const auto driver = static_cast<std::size_t>(std::get<TrackedPair>(run.plan.groups[g].kind).driver);
  const double way = limit.u - path.from[driver];
  return path.is_single() ? way : way / (path.to[driver] - path.from[driver]);
}

void add_limit(Run& run, std::size_t g, const Path& path, const LimitPosition& limit) {
  RunEvent event;
  event.type = EventType::kLimitPosition;
  set_place(event, path, place_of(run, g, path, limit));
  if (std::get<TrackedPair>(run.plan.groups[g].kind).driver == 0) {
    event.driver = limit.u;
  }
  name_item(run, g, event);
  event.cause = cause_of(run.plan.groups[g]);
  report_limit(run, path, std::move(event));
}

void report_limit(Run& run, const Path& path, RunEvent event) {
  const double scale = path.is_single() ? driver_scale(run, 0) + std::abs(event.driver) : 1;
  const double near = kSamePlace * scale;
  const auto distance = [&](double share) { return std::abs(share * path.length); };
  const bool known = std::any_of(run.events.begin(), run.events.end(), [&](const RunEvent& other) {
    return is_same_item(event, other) && distance(event.share - other.share) <= near;
  });
  const bool at_row_before =
      run.limit_before && is_same_item(event, *run.limit_before) && distance(event.share) <= near;
  if (known || at_row_before) {
    return;
  }
  if (distance(1 - event.share) <= near) {
    run.limit_here = event;
  }
  run.events.push_back(std::move(event));
}

}  // namespace higherpair
