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

RunEvent limit_event(const Run& run, std::size_t g, const Path& path, double s) {
  RunEvent event;
  event.type = EventType::kLimitPosition;
  set_place(event, path, s);
  name_item(run, g, event);
  event.cause = cause_of(run.plan.groups[g]);
  return event;
}

void report_limit(Run& run, const Path& path, RunEvent event) {
  const bool single = path.is_single();
  const double near = kSamePlace * (single ? driver_scale(run, 0) + std::abs(event.driver) : 1);
  const auto is_at = [&](double driver, double share) {
    return std::abs(single ? event.driver - driver : event.share - share) <= near;
  };
  const bool known = std::any_of(run.events.begin(), run.events.end(), [&](const RunEvent& other) {
    return is_same_item(event, other) && is_at(other.driver, other.share);
  });
  const bool at_row_before =
      run.limit_before && is_same_item(event, *run.limit_before) && is_at(run.limit_before->driver, 0);
  if (known || at_row_before) {
    return;
  }
  if (is_at(path.to[0], 1)) {
    run.limit_here = event;
  }
  run.events.push_back(std::move(event));
}

}  // namespace higherpair
