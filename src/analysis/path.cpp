#include "path.hpp"

#include "crossing.hpp"
#include "events.hpp"
#include "higherpair/contact/finder.hpp"
#include "higherpair/contact/step_agreement.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "limit_events.hpp"
#include "overlap.hpp"
#include "root_between.hpp"
#include "short_way.hpp"
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
constexpr double kLongStep = 0.02;      // of the driver's scale: one that may as well end elsewhere
constexpr double kMostSteps = 2e5;      // inner steps besides those that the way takes at least

// Of how many inner steps a path is at least.
double parts_of(const Run& run, const Path& path) {
  double parts = 1;
  for (std::size_t i = 0; i < path.from.size(); ++i) {
    const Joint& joint = run.mechanism.joints[static_cast<std::size_t>(run.mechanism.drivers[i].joint)];
    const double largest = joint.type == JointType::kRevolute ? kMaxTurn : kMaxSlide * driver_scale(run, i);
    parts = std::max(parts, std::abs(path.to[i] - path.from[i]) / largest);
  }
  return parts;
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

// A way along a path, in steps that agree with their predictions.
class Way {
public:
  Way(Run& run, const Path& path) : Way(run, path, parts_of(run, path)) {
    run.between = false;
    if (run.plan.couples) {
      run.way_start = run.state;
    }
  }

  bool follow() {
    while (s_ != path_.length) {
      if (is_stopped(run_)) {
        return lose(s_) == Outcome::kArrived;
      }
      const Outcome outcome = next();
      if (outcome != Outcome::kGoesOn) {
        return outcome == Outcome::kArrived;
      }
    }
    run_.drivers = path_.to;
    return true;
  }

private:
  enum class Outcome { kGoesOn, kArrived, kLost };

  Way(Run& run, const Path& path, double parts)
      : run_(run),
        path_(path),
        largest_(std::abs(path.length) / parts),
        scale_(path.is_single() ? driver_scale(run, 0) : 1),
        near_(kCrossingReach * (path.is_single() ? scale_ : unit_of(run, path))),
        h_(largest_),
        steps_left_(kMostSteps + 4 * parts) {}

  Outcome next() {
    rest_ = path_.length - s_;
    if (--steps_left_ < 0) {
      add_limit(run_, run_.plan.groups.size() - 1, path_, s_);
      return lose(s_);
    }
    last_ = std::abs(rest_) <= kAlmostThere * h_;
    step_ = last_ ? rest_ : std::copysign(h_, rest_);
    const StepResult result = try_step(run_, path_, s_, step_);
    near_crossing_ = result.kind == StepResult::kOk && is_near_crossing(run_, run_.trial);
    if (const auto shorter = better_length(result)) {
      longest_ = std::max(longest_, h_);
      h_ = *shorter;
      return Outcome::kGoesOn;
    }
    if (result.limit && is_tracked(result.group)) {
      add_limit(run_, result.group, path_, *result.limit);
    }
    return result.kind == StepResult::kOk ? take() : refuse(result);
  }

  [[nodiscard]] bool is_tracked(std::size_t g) const {
    return std::holds_alternative<TrackedPair>(run_.plan.groups[g].kind);
  }

  // Of a step that should end elsewhere, though it need not have failed.
  [[nodiscard]] std::optional<double> better_length(const StepResult& result) const {
    const bool lost = result.kind != StepResult::kOk;
    const bool tracked = is_tracked(result.group);
    if (lost && tracked && result.limit && result.group + 1 < run_.plan.groups.size()) {
      // What hangs on this contact may come to a limit before: go on to just short of it.
      const double ahead = std::abs(place_of(run_, result.group, path_, *result.limit) - s_);
      if (ahead > kShortOfLimit * scale_) {
        return std::min(kShareToLimit * ahead, std::abs(step_) / 2);
      }
    }
    if (near_crossing_ && !last_ && std::abs(step_) > kLongStep * scale_) {
      // No place to rest at: come down elsewhere.
      return 0.618 * std::abs(step_);
    }
    if (last_ && std::abs(rest_) > 2 * near_ && (near_crossing_ || (lost && !tracked))) {
      // A place to interpolate from, near enough to be on the same branch surely.
      return std::abs(rest_) - 1.5 * near_;
    }
    return std::nullopt;
  }

  Outcome take() {
    if (last_ && near_crossing_ && stop_near_crossing(run_, path_, s_, rest_)) {
      return Outcome::kArrived;
    }
    note_events(run_, path_, s_, step_);
    watch_overlaps(run_, path_, s_, step_);
    accept(run_);
    s_ = last_ ? path_.length : s_ + step_;
    h_ = std::max(longest_, std::min(2 * h_, largest_));
    longest_ = 0;
    return Outcome::kGoesOn;
  }

  Outcome refuse(const StepResult& result) {
    if (is_tracked(result.group)) {
      // The track remembers by itself where it was lost.
      run_.state.tracks[result.group] = run_.trial.tracks[result.group];
      return lose(result.limit ? place_of(run_, result.group, path_, *result.limit) : s_);
    }
    if (last_ && stop_near_crossing(run_, path_, s_, rest_)) {
      return Outcome::kArrived;
    }
    h_ = std::abs(step_) / 2;
    longest_ = 0;
    if (++halvings_ >= kHalvingsToLimit) {
      if (const auto limit = locate_limit(run_, path_, result.group, s_, step_)) {
        add_limit(run_, result.group, path_, *limit);
        return lose(*limit);
      }
    }
    if (h_ < kSmallestStep * scale_ * (1 + std::abs(driver_at(path_, s_)) / scale_)) {
      add_limit(run_, result.group, path_, s_);
      return lose(s_);
    }
    return Outcome::kGoesOn;
  }

  Outcome lose(double limit) {
    if (run_.plan.couples) {
      run_.lost_way.from = path_.from;
      path_.positions(limit, run_.lost_way.to);
      run_.state = run_.way_start;
    }
    run_.held = false;
    run_.drivers = path_.to;
    return Outcome::kLost;
  }

  Run& run_;
  const Path& path_;
  double largest_;              // step
  double scale_;                // of the driver
  double near_;                 // how far from a crossing places are interpolated from
  double s_ = 0;                // where run.state stands
  double rest_ = 0;             // from there
  double step_ = 0;             // that is tried
  bool last_ = false;           // it leads to the end
  bool near_crossing_ = false;  // it could be taken and leads next to where branches may cross
  double h_;                    // largest step that may be tried
  double longest_ = 0;  // where a step was shortened though it need not have failed: what it was before
  int halvings_ = 0;
  double steps_left_;
};

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
  return Way(run, path).follow();
}

bool resume(Run& run, const std::vector<double>& drivers, const std::vector<double>& from) {
  if (run.plan.couples) {
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
  const State lost = run.trial;
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
    take_short_way(run, lost, back.state);
  }
  return true;
}

}  // namespace higherpair
