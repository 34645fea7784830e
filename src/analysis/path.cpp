#include "path.hpp"

#include "crossing.hpp"
#include "events.hpp"
#include "higherpair/contact/finder.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "overlap.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

namespace higherpair {
namespace {

constexpr double kMaxTurn = kPi / 18;  // of a driver in one inner step [rad]
constexpr double kMaxSlide = 1.0 / 6;  // of a driver in one inner step, of the size
constexpr double kAgreement = 0.25;    // of the change of a step: distance between prediction and solution
constexpr double kCrossingAgreement = 0.03;  // the same where the branch is to change
constexpr double kSmallestStep = 1e-14;      // of the driver's scale
constexpr int kHalvingsToLimit = 4;

// Groups that keep to their branch by themselves.
bool is_safe(const Group& group) {
  return std::holds_alternative<DrivenBody>(group.kind) || std::holds_alternative<TrackedPair>(group.kind) ||
         std::holds_alternative<IdleBody>(group.kind);
}

double largest_step(const Run& run, const Path& path) {
  double parts = 1;
  for (std::size_t i = 0; i < path.from.size(); ++i) {
    const double scale = driver_scale(run, i);
    const double largest = scale == 1 ? kMaxTurn : kMaxSlide * scale;
    parts = std::max(parts, std::abs(path.to[i] - path.from[i]) / largest);
  }
  return std::abs(path.length) / parts;
}

// How far the bodies of a group have moved, and how far from where their rates said; angles, and lengths by
// the size.
struct Agreement {
  double change = 0;
  double mismatch = 0;

  [[nodiscard]] bool within(double share) const { return mismatch <= share * change + 1e-9; }
};

Agreement agreement(const Group& group, const State& from, const State& to, double h, double size) {
  Agreement result;
  for (const int index : group.bodies) {
    const BodyMotion& a = from.bodies[static_cast<std::size_t>(index)];
    const BodyMotion& b = to.bodies[static_cast<std::size_t>(index)];
    const double turn = b.theta - a.theta;
    const Vector2d shift = b.X_WB.p_WB - a.X_WB.p_WB;
    result.change += std::abs(turn) + shift.lpNorm<1>() / size;
    result.mismatch += std::abs(turn - h * (a.omega + h / 2 * a.alpha)) +
                       (shift - h * (a.v_WB + h / 2 * a.a_WB)).lpNorm<1>() / size;
  }
  return result;
}

Model model_of(const Run& run) {
  return {run.mechanism, run.plan};
}

// Places groups up to (not including) `end` in run.trial, without asking whether they agree with a
// prediction.
bool place_before(Run& run, std::size_t end, double h, const std::vector<double>& drivers) {
  std::optional<LimitPosition> limit;
  for (std::size_t g = 0; g < end; ++g) {
    run.trial.groups[g].mode = run.state.groups[g].mode;
    if (place_group(model_of(run), g, run.state, h, drivers, run.trial, limit) != GroupStatus::kOk) {
      return false;
    }
  }
  return true;
}

// The slack of a group after a further `h` of the path; NaN where the groups before cannot be placed.
double slack_after(Run& run, const Path& path, std::size_t g, double s, double h) {
  std::vector<double> drivers;
  path.positions(s + h, drivers);
  if (!place_before(run, g, h, drivers)) {
    return NAN;
  }
  for (const int body : run.plan.groups[g].bodies) {
    run.trial.bodies[static_cast<std::size_t>(body)] = run.state.bodies[static_cast<std::size_t>(body)];
  }
  for (const int contact : run.plan.groups[g].contacts) {
    run.trial.contacts[static_cast<std::size_t>(contact)] =
        run.state.contacts[static_cast<std::size_t>(contact)];
  }
  return slack_of(model_of(run), g, run.trial).value_or(NAN);
}

// Whether the slack only touches 0 within the step, so that branches really cross there; without it the links
// would come near to being aligned and part again, or part of the way could not be assembled.
bool really_crosses(Run& run, const Path& path, std::size_t g, double s, double h) {
  const double before = slack_after(run, path, g, s, 0);
  if (!std::isfinite(before)) {
    return true;
  }
  const auto slack = [&](double x) { return slack_after(run, path, g, s, x); };
  std::uintmax_t calls = 100;
  const auto [x, smallest] =
      boost::math::tools::brent_find_minima(slack, std::min(0.0, h), std::max(0.0, h), 52, calls);
  const double after = slack(h);
  return std::abs(smallest) <= 1e-13 * (std::abs(before) + std::abs(after) + run.plan.size * run.plan.size);
}

GroupStatus place_agreeing(Run& run, const Path& path, std::size_t g, double s, double h,
                           const std::vector<double>& drivers, StepResult& result) {
  const Group& group = run.plan.groups[g];
  const GroupState& before = run.state.groups[g];
  GroupState& now = run.trial.groups[g];
  now.mode = before.mode;
  const GroupStatus status = place_group(model_of(run), g, run.state, h, drivers, run.trial, result.limit);
  if (status != GroupStatus::kOk || is_safe(group)) {
    return status;
  }
  const bool crosses = (before.sine + h * before.sine_rate) * before.sine < 0;
  if (!crosses && agreement(group, run.state, run.trial, h, run.plan.size).within(kAgreement)) {
    return GroupStatus::kOk;
  }
  if (crosses && !std::holds_alternative<CoupledBodies>(group.kind)) {
    now.mode = -before.mode;
    if (place_group(model_of(run), g, run.state, h, drivers, run.trial, result.limit) == GroupStatus::kOk &&
        agreement(group, run.state, run.trial, h, run.plan.size).within(kCrossingAgreement)) {
      const State kept = run.trial;
      const bool crossing = really_crosses(run, path, g, s, h);
      run.trial = kept;
      if (crossing) {
        return GroupStatus::kOk;
      }
    }
    now.mode = before.mode;
    if (place_group(model_of(run), g, run.state, h, drivers, run.trial, result.limit) == GroupStatus::kOk &&
        agreement(group, run.state, run.trial, h, run.plan.size).within(kAgreement)) {
      return GroupStatus::kOk;
    }
  }
  return GroupStatus::kNotConverged;
}

void add_limit(Run& run, std::size_t g, double driver) {
  RunEvent event;
  event.type = EventType::kLimitPosition;
  event.driver = driver;
  name_item(run, g, event);
  event.cause =
      event.contact
          ? "the two bodies cannot be kept in contact on this branch beyond this position of the driver"
          : "the links are in line here: beyond this position of the driver they cannot reach each other";
  run.events.push_back(std::move(event));
}

// The root of the group's slack between s and s + h, if its sign changes there.
std::optional<double> locate_limit(Run& run, const Path& path, std::size_t g, double s, double h) {
  const double here = slack_after(run, path, g, s, 0);
  const double there = slack_after(run, path, g, s, h);
  if (!std::isfinite(here) || !std::isfinite(there) || here * there > 0) {
    return std::nullopt;
  }
  if (here == 0) {
    return s;
  }
  const auto slack = [&](double x) { return slack_after(run, path, g, s, x); };
  std::uintmax_t calls = 200;
  const double low = std::min(0.0, h), high = std::max(0.0, h);
  const auto bracket =
      boost::math::tools::toms748_solve(slack, low, high, h > 0 ? here : there, h > 0 ? there : here,
                                        boost::math::tools::eps_tolerance<double>(52), calls);
  return s + (bracket.first + bracket.second) / 2;
}

void accept(Run& run) {
  std::swap(run.state, run.trial);
}

bool lose(Run& run, const Path& path) {
  run.held = false;
  run.drivers = path.to;
  return false;
}

}  // namespace

double driver_scale(const Run& run, std::size_t driver) {
  const Joint& joint = run.mechanism.joints[static_cast<std::size_t>(run.mechanism.drivers[driver].joint)];
  return joint.type == JointType::kRevolute ? 1 : run.plan.size;
}

StepResult try_step(Run& run, const Path& path, double s, double h) {
  StepResult result;
  std::vector<double>& drivers = run.trial_drivers;
  path.positions(s + h, drivers);
  for (std::size_t g = 0; g < run.plan.groups.size(); ++g) {
    const GroupStatus status = place_agreeing(run, path, g, s, h, drivers, result);
    if (status != GroupStatus::kOk) {
      result.group = g;
      result.kind = status == GroupStatus::kOutOfReach ? StepResult::kLost : StepResult::kDisagrees;
      return result;
    }
  }
  path.motions(s + h, run.trial_motions);
  for (std::size_t g = 0; g < run.plan.groups.size(); ++g) {
    set_group_rates(model_of(run), g, run.trial_motions, run.trial);
  }
  return result;
}

void name_item(const Run& run, std::size_t g, RunEvent& event) {
  const Group& group = run.plan.groups[g];
  if (!group.contacts.empty()) {
    event.contact = group.contacts.front();
  } else if (!group.joints.empty()) {
    event.joint = group.joints.front();
  }
}

double driver_at(const Path& path, double s) {
  return path.is_single() ? path.from[0] + s : path.from[0] + s * (path.to[0] - path.from[0]);
}

bool solve_at(Run& run, const Path& path, double s, double x) {
  std::vector<double> drivers;
  path.positions(s + x, drivers);
  if (!place_before(run, run.plan.groups.size(), x, drivers)) {
    return false;
  }
  path.motions(s + x, run.trial_motions);
  for (std::size_t g = 0; g < run.plan.groups.size(); ++g) {
    set_group_rates(model_of(run), g, run.trial_motions, run.trial);
  }
  return true;
}

void Path::positions(double s, std::vector<double>& out) const {
  out.resize(from.size());
  if (s == length) {
    out = to;
    return;
  }
  for (std::size_t i = 0; i < from.size(); ++i) {
    out[i] = from[i] + s * (is_single() ? 1 : to[i] - from[i]);
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
  path.from = from;
  path.to = to;
  path.length = path.is_single() ? to[0] - from[0] : 1;
}

bool follow(Run& run, const Path& path) {
  const double largest = largest_step(run, path);
  const double scale = path.is_single() ? driver_scale(run, 0) : 1;
  double s = 0;
  double h = largest;
  int halvings = 0;
  run.between = false;
  while (s != path.length) {
    const double rest = path.length - s;
    const bool last = std::abs(rest) <= h;
    const double step = last ? rest : std::copysign(h, rest);
    const StepResult result = try_step(run, path, s, step);
    if (result.limit) {
      add_limit(run, result.group, result.limit->u);
    }
    if (result.kind == StepResult::kOk && !last && is_near_crossing(run, run.trial) &&
        std::abs(step) > 0.02 * scale) {
      // No place to rest at: come down elsewhere.
      h = 0.618 * std::abs(step);
      continue;
    }
    if (result.kind == StepResult::kOk) {
      if (last && stop_near_crossing(run, path, s, rest)) {
        run.between = true;
        path.positions(s, run.drivers);
        return true;
      }
      note_events(run, path, s, step);
      watch_overlaps(run, path, s, step);
      accept(run);
      s = last ? path.length : s + step;
      h = std::min(2 * h, largest);
      continue;
    }
    if (std::holds_alternative<TrackedPair>(run.plan.groups[result.group].kind)) {
      // The track remembers by itself where it was lost.
      run.state.tracks[result.group] = run.trial.tracks[result.group];
      return lose(run, path);
    }
    h = std::abs(step) / 2;
    if (++halvings >= kHalvingsToLimit) {
      if (const auto limit = locate_limit(run, path, result.group, s, step)) {
        add_limit(run, result.group, driver_at(path, *limit));
        return lose(run, path);
      }
    }
    if (h < kSmallestStep * scale * (1 + std::abs(driver_at(path, s)) / scale)) {
      add_limit(run, result.group, driver_at(path, s));
      return lose(run, path);
    }
  }
  run.drivers = path.to;
  return true;
}

bool resume(Run& run, const std::vector<double>& drivers) {
  std::optional<LimitPosition> limit;
  std::size_t limited = 0;
  for (std::size_t g = 0; g < run.plan.groups.size(); ++g) {
    const bool known = limit.has_value();
    run.trial.groups[g].mode = run.state.groups[g].mode;
    if (place_group(model_of(run), g, run.state, 0, drivers, run.trial, limit) != GroupStatus::kOk) {
      return false;
    }
    limited = limit && !known ? g : limited;
  }
  run.trial_motions.resize(drivers.size());
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    run.trial_motions[i] = {drivers[i], drivers.size() == 1 ? 1.0 : 0.0, 0};
  }
  for (std::size_t g = 0; g < run.plan.groups.size(); ++g) {
    set_group_rates(model_of(run), g, run.trial_motions, run.trial);
  }
  const std::vector<double> lost_at = run.drivers;
  accept(run);
  run.held = true;
  run.between = false;
  run.drivers = drivers;
  if (limit) {
    add_limit(run, limited, limit->u);
    return true;
  }
  // Where this stretch begins: the limit on the way back.
  Run back = run;
  Path way_back;
  set_path(way_back, drivers, lost_at);
  if (!follow(back, way_back)) {
    run.events.insert(run.events.end(), back.events.begin(), back.events.end());
  }
  return true;
}

}  // namespace higherpair
