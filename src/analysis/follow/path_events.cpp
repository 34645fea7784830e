#include "path_events.hpp"

#include "analysis/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {

bool is_same_item(const RunEvent& a, const RunEvent& b) {
  return a.type == b.type && a.joint == b.joint && a.contact == b.contact;
}

bool is_at_same_drivers(const Run& run, const RunEvent& a, const RunEvent& b, double near) {
  const auto is_near = [&](double at, double other, std::size_t driver) {
    return std::abs(at - other) <= near * (driver_scale(run, driver) + std::abs(at));
  };
  bool all = is_near(a.driver, b.driver, 0);
  for (std::size_t i = 0; i < a.further_drivers.size(); ++i) {
    all = all && is_near(a.further_drivers[i], b.further_drivers[i], i + 1);
  }
  return all;
}

void name_item(const Run& run, std::size_t g, RunEvent& event) {
  const Group& group = run.plan().groups[g];
  if (!group.contacts.empty()) {
    event.contact = group.contacts.front();
  } else if (!group.joints.empty()) {
    event.joint = group.joints.front();
  }
}

void place_event(RunEvent& event, const Path& path, double s) {
  std::vector<DriverMotion> drivers;
  path.motions(s, drivers);
  event.driver = drivers.front().position;
  event.further_drivers.clear();
  for (std::size_t i = 1; i < drivers.size(); ++i) {
    event.further_drivers.push_back(drivers[i].position);
  }
  event.share = share_at(path, s);
}

RunEvent event_at(EventType type, const Path& path, double s, std::string_view cause) {
  RunEvent event;
  event.type = type;
  event.cause = cause;
  place_event(event, path, std::clamp(s, std::min(path.length, 0.0), std::max(path.length, 0.0)));
  return event;
}

RunEvent& report_contact(Run& run, EventType type, const Path& path, double s, std::size_t contact,
                         std::string_view cause) {
  run.events.push_back(event_at(type, path, s, cause));
  run.events.back().contact = static_cast<int>(contact);
  return run.events.back();
}

void set_jump(RunEvent& event, const Path& path, EventJump jump) {
  const double s = path.length * (event.share - path.share_from) / (path.share_to - path.share_from);
  std::vector<DriverMotion> drivers;
  path.motions(s, drivers);
  const auto moves = [](const DriverMotion& driver) { return driver.velocity != 0; };
  const auto first = std::find_if(drivers.begin(), drivers.end(), moves);
  const double pace = first == drivers.end() ? 1 : first->velocity;  // per unit of s
  jump.driver = first == drivers.end() ? 0 : static_cast<int>(first - drivers.begin());
  const double none = kRateRounding * std::max(std::abs(jump.before), std::abs(jump.after));
  for (double* rate : {&jump.before, &jump.after}) {
    *rate = std::abs(*rate) <= none ? 0 : *rate / (jump.order == 1 ? pace : pace * pace);
  }
  event.jump = std::move(jump);
}

}  // namespace higherpair
