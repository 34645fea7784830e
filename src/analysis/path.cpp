#include "path.hpp"

#include "crossing.hpp"
#include "events.hpp"
#include "higherpair/contact/finder.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "limit_events.hpp"
#include "overlap.hpp"
#include "root_between.hpp"
#include "step.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kMaxTurn = kPi / 18;    // of a driver in one inner step [rad]
constexpr double kMaxSlide = 1.0 / 6;    // of a driver in one inner step, of the size
constexpr double kSmallestStep = 1e-14;  // of the driver's scale
constexpr int kHalvingsToLimit = 4;
constexpr double kShortOfLimit = 1e-6;  // of the driver's scale: as near as this a limit is reached
constexpr double kShareToLimit = 0.9;   // of the way to it in one step
constexpr double kMostSteps = 2e5;      // inner steps besides those that the way takes at least

double largest_step(const Run& run, const Path& path) {
  double parts = 1;
  for (std::size_t i = 0; i < path.from.size(); ++i) {
    const Joint& joint = run.mechanism.joints[static_cast<std::size_t>(run.mechanism.drivers[i].joint)];
    const double largest = joint.type == JointType::kRevolute ? kMaxTurn : kMaxSlide * driver_scale(run, i);
    parts = std::max(parts, std::abs(path.to[i] - path.from[i]) / largest);
  }
  return std::abs(path.length) / parts;
}

// The root of the group's slack between s and s + h, if its sign changes there.
std::optional<double> locate_limit(Run& run, const Path& path, std::size_t g, double s, double h) {
  const double here = slack_after(run, path, g, s, 0);
  const double there = slack_after(run, path, g, s, h);
  const auto slack = [&](double x) { return slack_after(run, path, g, s, x); };
  const auto x = root_between(slack, here, h, there);
  return x ? std::optional(s + *x) : std::nullopt;
}

void accept(Run& run) {
  std::swap(run.state, run.trial);
}

bool lose(Run& run, const Path& path, double s) {
  if (has_coupled_bodies(run.plan)) {
    path.positions(s, run.drivers);
    set_path(run.lost_way, path.from, run.drivers);
    run.state = run.way_start;
  }
  run.held = false;
  run.drivers = path.to;
  return false;
}

// Coupled bodies come back where the drivers come back: what can be assembled beyond a limit need not be
// their branch.
bool come_back(Run& run, const std::vector<double>& drivers) {
  double beyond = 0;
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    const double limit = run.lost_way.to[i];
    beyond += (drivers[i] - limit) * (limit - run.lost_way.from[i]);
  }
  if (!(beyond < 0)) {
    return false;
  }
  Path way;
  set_path(way, run.lost_way.from, drivers);
  if (!way.is_single()) {
    way.motions(0, run.trial_motions);
    set_rates(run, run.trial_motions, run.state);
  }
  renew_overlaps(run);
  run.held = true;
  return follow(run, way);
}

}  // namespace

void name_item(const Run& run, std::size_t g, RunEvent& event) {
  const Group& group = run.plan.groups[g];
  if (!group.contacts.empty()) {
    event.contact = group.contacts.front();
  } else if (!group.joints.empty()) {
    event.joint = group.joints.front();
  }
}

void set_place(RunEvent& event, const Path& path, double s) {
  event.driver = driver_at(path, s);
  event.share = path.length == 0 ? 1 : s / path.length;
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
  path.length = path.is_single() ? to[0] - from[0] : 1;
}

bool follow(Run& run, const Path& path) {
  const double largest = largest_step(run, path);
  const double scale = path.is_single() ? driver_scale(run, 0) : 1;
  const double near = kCrossingReach * unit_of(run, path);
  double s = 0;
  double h = largest;
  int halvings = 0;
  double steps = kMostSteps + 4 * std::abs(path.length) / largest;
  run.between = false;
  if (has_coupled_bodies(run.plan)) {
    run.way_start = run.state;
  }
  while (s != path.length) {
    const double rest = path.length - s;
    if (--steps < 0) {
      add_limit(run, run.plan.groups.size() - 1, path, s);
      return lose(run, path, s);
    }
    const bool last = std::abs(rest) <= h;
    const double step = last ? rest : std::copysign(h, rest);
    const StepResult result = try_step(run, path, s, step);
    const bool lost = result.kind != StepResult::kOk;
    const bool tracked = std::holds_alternative<TrackedPair>(run.plan.groups[result.group].kind);
    if (result.limit && lost && tracked) {
      // What hangs on this contact may come to a limit before: go on to just short of it.
      const double ahead = std::abs(place_of(run, result.group, path, *result.limit) - s);
      if (result.group + 1 < run.plan.groups.size() && ahead > kShortOfLimit * scale) {
        h = std::min(kShareToLimit * ahead, std::abs(step) / 2);
        continue;
      }
    }
    if (result.limit && tracked) {
      add_limit(run, result.group, path, *result.limit);
    }
    if (!lost && !last && is_near_crossing(run, run.trial) && std::abs(step) > 0.02 * scale) {
      // No place to rest at: come down elsewhere.
      h = 0.618 * std::abs(step);
      continue;
    }
    if (last && std::abs(rest) > 2 * near && (lost ? !tracked : is_near_crossing(run, run.trial))) {
      // A place to interpolate from, near enough to be on the same branch surely.
      h = std::abs(rest) - 1.5 * near;
      continue;
    }
    if (!lost) {
      if (last && stop_near_crossing(run, path, s, rest)) {
        return true;
      }
      note_events(run, path, s, step);
      watch_overlaps(run, path, s, step);
      accept(run);
      s = last ? path.length : s + step;
      h = std::min(2 * h, largest);
      continue;
    }
    if (tracked) {
      // The track remembers by itself where it was lost.
      run.state.tracks[result.group] = run.trial.tracks[result.group];
      return lose(run, path, result.limit ? place_of(run, result.group, path, *result.limit) : s);
    }
    if (last && stop_near_crossing(run, path, s, rest, true)) {
      return true;
    }
    h = std::abs(step) / 2;
    if (++halvings >= kHalvingsToLimit) {
      if (const auto limit = locate_limit(run, path, result.group, s, step)) {
        add_limit(run, result.group, path, *limit);
        return lose(run, path, *limit);
      }
    }
    if (h < kSmallestStep * scale * (1 + std::abs(driver_at(path, s)) / scale)) {
      add_limit(run, result.group, path, s);
      return lose(run, path, s);
    }
  }
  run.drivers = path.to;
  return true;
}

bool resume(Run& run, const std::vector<double>& drivers, const std::vector<double>& from) {
  if (has_coupled_bodies(run.plan)) {
    return come_back(run, drivers);
  }
  const StepResult result = place_anew(run, drivers);
  if (result.kind != StepResult::kOk) {
    return false;
  }
  Path way;
  set_path(way, from, drivers);
  accept(run);
  renew_overlaps(run);
  run.held = true;
  run.between = false;
  run.drivers = drivers;
  if (result.limit) {
    add_limit(run, result.group, way, *result.limit);
    return true;
  }
  // Where this stretch begins: the limit on the way back.
  Run back = run;
  back.events.clear();
  Path way_back;
  set_path(way_back, drivers, way.from);
  if (!follow(back, way_back)) {
    for (RunEvent& event : back.events) {
      if (event.type == EventType::kLimitPosition) {
        event.share = 1 - event.share;
        report_limit(run, way, std::move(event));
      }
    }
  }
  return true;
}

}  // namespace higherpair
