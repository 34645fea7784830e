#include "limit_events.hpp"

#include "analysis/boundaries/span_ends.hpp"
#include "analysis/tolerances.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "joint_ends.hpp"
#include "step.hpp"
#include "straight_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {

RunEvent limit_event(const Run& run, std::size_t g, const Path& path, double s) {
  RunEvent event = event_at(EventType::kLimitPosition, path, s, limit_cause(run.plan().groups[g]));
  name_item(run, g, event);
  if (auto end = end_reached(run, g)) {
    event.type = EventType::kEnd;
    event.cause = *std::move(end);
  } else if (const auto at_end = joint_at_end(model_of(run), g, run.at.state)) {
    const Joint& joint = run.mechanism().joints[at_end->joint];
    event.type = EventType::kEnd;
    event.joint = at_end->joint;
    event.contact.reset();
    event.cause =
        fmt::format("joint {} comes to the end of its line, `{}`", joint.name, at_end->upper ? "to" : "from");
  } else if (auto slip = slipped_off(run, g)) {
    event.type = EventType::kEnd;
    event.cause = *std::move(slip);
  }
  return event;
}

bool is_same_limit(const Run& run, const RunEvent& a, const RunEvent& b) {
  return is_same_item(a, b) && is_at_same_drivers(run, a, b, kSameLimit);
}

void report_limit(Run& run, const Path& path, RunEvent event) {
  const bool single = path.is_single();
  const double near = kSameLimit * (single ? driver_scale(run, 0) + std::abs(event.driver) : 1);
  const auto is_at = [&](double driver, double share) {
    return std::abs(single ? event.driver - driver : event.share - share) <= near;
  };
  const bool known = std::any_of(run.events.begin(), run.events.end(), [&](const RunEvent& other) {
    return is_same_item(event, other) && is_at(other.driver, other.share);
  });
  const bool at_row_before = run.at.limit_before && is_same_item(event, *run.at.limit_before) &&
                             is_at(run.at.limit_before->driver, 0);
  if (known || at_row_before) {
    return;
  }
  if (is_at(path.to[0], 1)) {
    run.at.limit_here = event;
  }
  run.events.push_back(std::move(event));
}

}  // namespace higherpair
