#include "straight_path.hpp"

#include "analysis/tolerances.hpp"
#include "step.hpp"

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

double share_at(const Path& path, double s) {
  return std::lerp(path.share_from, path.share_to, path.length == 0 ? 1 : s / path.length);
}

RunEvent event_at(EventType type, const Path& path, double s, std::string_view cause) {
  RunEvent event;
  event.type = type;
  std::vector<double> drivers;
  path.positions(std::clamp(s, std::min(path.length, 0.0), std::max(path.length, 0.0)), drivers);
  event.driver = drivers.front();
  event.further_drivers.assign(drivers.begin() + 1, drivers.end());
  event.share = share_at(path, s);
  event.cause = cause;
  return event;
}

RunEvent& report_contact(Run& run, EventType type, const Path& path, double s, std::size_t contact,
                         std::string_view cause) {
  run.events.push_back(event_at(type, path, s, cause));
  run.events.back().contact = static_cast<int>(contact);
  return run.events.back();
}

void set_jump(RunEvent& event, const Path& path, EventJump jump) {
  double pace = 1;  // of that driver, per unit of s
  for (std::size_t i = 0; !path.is_single() && i < path.from.size(); ++i) {
    if (path.from[i] != path.to[i]) {
      jump.driver = static_cast<int>(i);
      pace = path.to[i] - path.from[i];
      break;
    }
  }
  const double none = kRateRounding * std::max(std::abs(jump.before), std::abs(jump.after));
  for (double* rate : {&jump.before, &jump.after}) {
    *rate = std::abs(*rate) <= none ? 0 : *rate / (jump.order == 1 ? pace : pace * pace);
  }
  event.jump = std::move(jump);
}

double driver_at(const Path& path, double s) {
  return path.is_single() ? path.from[0] + s : path.from[0] + s * (path.to[0] - path.from[0]);
}

void Path::positions(double s, std::vector<double>& out) const {
  out.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    out[i] = s == length ? to[i] : from[i] + s * (is_single() ? 1 : to[i] - from[i]);
  }
}

void Path::motions(double s, std::vector<DriverMotion>& out) const {
  out.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double rate = is_single() ? 1 : to[i] - from[i];
    out[i] = {s == length ? to[i] : from[i] + s * rate, rate, 0};
  }
}

void set_path(Path& path, const std::vector<double>& from, const std::vector<double>& to) {
  path.from.resize(from.size());
  path.to.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {  // a few numbers: a loop costs less than copying blocks
    path.from[i] = from[i];
    path.to[i] = to[i];
  }
  path.length = path.is_single() ? to[0] - from[0] : from == to ? 0 : 1;
  path.share_from = 0;
  path.share_to = 1;
}

}  // namespace higherpair
