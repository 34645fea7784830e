#include "limit_events.hpp"

#include "analysis/boundaries/span_ends.hpp"
#include "analysis/tolerances.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "joint_ends.hpp"
#include "path_events.hpp"
#include "step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

// The contact of a group at whose place both curves have the same curvature. At such a limit the bodies come
// to rest against each other at finite speeds, while the contact runs along them ever faster.
std::optional<int> conforming_contact(const Run& run, std::size_t g) {
  for (const int index : run.plan().groups[g].contacts) {
    const ContactMotion& motion = run.at.state.contacts[index];
    if (!motion.touches || motion.at.rho1 == 0 || motion.at.rho2 == 0) {
      continue;
    }
    const double kappa1 = 1 / motion.at.rho1, kappa2 = 1 / motion.at.rho2;
    const double largest = std::max(std::abs(kappa1), std::abs(kappa2));
    if (largest > 0 && std::abs(kappa1 + kappa2) <= kConforms * std::max(largest, 1 / run.plan().size)) {
      return index;
    }
  }
  return std::nullopt;
}

void set_end(RunEvent& event, ContactEnd end) {
  event.type = EventType::kEnd;
  event.contact = static_cast<int>(end.contact);
  event.cause = std::move(end.cause);
}

}  // namespace

RunEvent limit_event(const Run& run, std::size_t g, const Path& path, double s) {
  RunEvent event = event_at(EventType::kLimitPosition, path, s, limit_cause(run.plan().groups[g]));
  name_item(run, g, event);
  if (auto end = end_reached(run, g)) {
    set_end(event, *std::move(end));
  } else if (const auto at_end = joint_at_end(model_of(run), g, run.at.state)) {
    const Joint& joint = run.mechanism().joints[at_end->joint];
    event.type = EventType::kEnd;
    event.joint = at_end->joint;
    event.contact.reset();
    event.cause =
        fmt::format("joint {} comes to the end of its line, `{}`", joint.name, at_end->upper ? "to" : "from");
  } else if (const auto conforming = conforming_contact(run, g)) {
    event.contact = conforming;
    event.cause = "both curves have the same curvature at the contact here, and " + event.cause;
  } else if (auto slip = slipped_off(run, g)) {
    set_end(event, *std::move(slip));
  }
  return event;
}

void report_limit(Run& run, const Path& path, RunEvent event) {
  const bool single = path.is_single() && !path.curve;
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
