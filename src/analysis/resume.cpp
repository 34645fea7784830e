#include "resume.hpp"

#include "higherpair/geometry/vector.hpp"
#include "limit_events.hpp"
#include "overlap.hpp"
#include "path.hpp"
#include "short_way.hpp"
#include "step.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

// Beyond a limit at which the motion was lost.

namespace higherpair {
namespace {

constexpr double kProbe = kPi / 144;  // of the driver's scale: where a branch that was lost is looked for
constexpr int kFirstProbes = 4;       // before the first of these, each four times as far from the limit
constexpr double kMostProbes = 1e4;
constexpr double kGoldenShare = 0.3819660112501051;
constexpr double kShortestStretch = 1e-9;  // of the driver's scale
constexpr double kNearestBegin = 1e-12;  // of the driver's scale: beside a limit, for the first step from it

bool has_track(const Run& run) {
  return std::any_of(run.at.state.tracks.begin(), run.at.state.tracks.end(),
                     [](const PairTrack& track) { return std::holds_alternative<ContactTrack>(track); });
}

// Whether the drivers are at the limit, to within half of what a row there may be off, or back from it, as
// seen from where the motion came.
bool has_come_back(const Run& run, const std::vector<double>& drivers) {
  double beyond = 0;
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    const double ahead = run.at.lost.at[i] - run.at.lost.from[i];
    const double near = kOnLimit / 2 * (driver_scale(run, i) + std::abs(drivers[i]));
    beyond += (drivers[i] - run.at.lost.at[i]) * ahead - near * std::abs(ahead);
  }
  return beyond <= 0;
}

// Back from the limit the motion goes on from where it was lost.
bool come_back(Run& run, const std::vector<double>& drivers) {
  Path path;
  set_path(path, run.at.lost.from, drivers);
  if (!path.is_single()) {
    path.motions(0, run.work.motions);
    set_rates(run, run.work.motions, run.at.state);
  }
  renew_overlaps(run);
  run.at.held = true;
  report_limit(run, path, run.at.lost.event);
  return follow(run, path);
}

// The branch at a position of the drivers, if it is there, followed back on the way to `from`: to where this
// stretch of it begins. run.work.trial is then at that position.
std::optional<Run> found_again(Run& run, const std::vector<double>& at, const std::vector<double>& from) {
  if (!place_anew(run, at).complete) {
    return std::nullopt;
  }
  Run back = run;
  std::swap(back.at.state, back.work.trial);
  back.events.clear();
  back.at.held = true;
  back.at.beside.reset();
  back.at.drivers = at;
  Path path;
  set_path(path, at, from);
  if (follow(back, path) && has_track(run)) {
    return std::nullopt;  // without a limit on the way it is a contact that the follower cannot have come to
  }
  return back;
}

// Goes on from a state of that stretch; an event says where it begins, on the way from `from` to `to`.
void go_on_from(Run& run, const Run& back, const State& state, const std::vector<double>& drivers,
                const std::vector<double>& from, const std::vector<double>& to) {
  const State lost = std::exchange(run.at.state, state);
  renew_overlaps(run);
  run.at.held = true;
  run.at.beside.reset();
  run.at.drivers = drivers;
  Path path;
  set_path(path, from, to);
  for (const RunEvent& event : back.events) {
    // Where a curve ends the motion may have gone on over the edge.
    const bool is_last = &event == &back.events.back();
    if (event.type == EventType::kLimitPosition || (event.type == EventType::kEnd && is_last)) {
      RunEvent begin = event;
      begin.share = 1 - event.share;
      report_limit(run, path, std::move(begin));
    }
  }
  if (!back.at.held) {
    take_short_way(run, lost, back.at.state);
  }
}

bool follow_to(Run& run, const std::vector<double>& drivers,
               double first_step = std::numeric_limits<double>::infinity()) {
  Path path;
  set_path(path, run.at.drivers, drivers);
  return follow(run, path, first_step);
}

// Takes up the stretch that holds `at` where it begins, if that is before the drivers' positions, and goes on
// to these; whether it arrives there.
std::optional<bool> take_up(Run& run, const std::vector<double>& at, const std::vector<double>& drivers) {
  const std::vector<double> lost_at = run.at.lost.at;
  const double ahead = at[0] - lost_at[0];
  const auto back = found_again(run, at, lost_at);
  const std::vector<double> begin = back && !back->at.held ? back->at.lost.from : lost_at;
  if (!back || (drivers[0] - begin[0]) * ahead < 0) {
    return std::nullopt;
  }
  const State found = run.work.trial;
  const Standing before = run.at;
  const std::size_t events = run.events.size();
  go_on_from(run, *back, back->at.state, begin, lost_at, drivers);
  const double to_limit = back->at.held ? std::numeric_limits<double>::infinity()
                                        : std::max(std::abs(back->at.lost.at[0] - begin[0]),
                                                   kNearestBegin * driver_scale(run, 0));
  if (follow_to(run, drivers, to_limit)) {
    return true;
  }
  if ((run.at.lost.at[0] - at[0]) * ahead >= 0) {
    return false;
  }
  // From its very begin it cannot be followed.
  run.at = before;
  run.events.resize(events);
  if ((drivers[0] - at[0]) * ahead < 0) {
    return std::nullopt;
  }
  go_on_from(run, *back, found, at, lost_at, drivers);
  return follow_to(run, drivers);
}

// Positions of the driver at which a branch that was lost is looked for: the limit, close behind it, and then
// every kProbe. They are the same whatever the rows, so that what is found at them is.
class Probes {
public:
  Probes(const Run& run, double to)
      : limit_(run.at.lost.at[0]), step_(std::copysign(kProbe * driver_scale(run, 0), to - limit_)) {}

  [[nodiscard]] double at(double k) const {
    return k > kFirstProbes ? limit_ + (k - kFirstProbes) * step_
           : k > 0          ? limit_ + std::pow(4, k - kFirstProbes) / 4 * step_
                            : limit_;
  }
  /// The first one that is not before a position; at least 1.
  [[nodiscard]] double first_from(double driver) const {
    double k = std::max(1.0, std::ceil((driver - limit_) / step_) + kFirstProbes);
    while (k > 1 && (at(k - 1) - driver) * step_ >= 0) {
      --k;
    }
    return k;
  }

private:
  double limit_, step_;
};

// Where the branch can be placed between a and c, if more of it can be at b than at either: nearer and nearer
// to where most of it can (golden section search; W. H. Press et al., Numerical Recipes, 2007, 10.2).
std::optional<double> placed_between(Run& run, double a, double b, double c) {
  const auto placing = [&](double x) { return place_anew(run, {x}); };
  Placing at_a = placing(a), at_b = placing(b), at_c = placing(c);
  if (at_b.complete || at_b < at_a || at_b < at_c || !(at_a < at_b || at_c < at_b)) {
    return at_b.complete ? std::optional(b) : std::nullopt;
  }
  const double shortest = kShortestStretch * driver_scale(run, 0);
  while (std::abs(c - a) > shortest && std::isfinite(at_b.room) && !is_stopped(run)) {
    // A hill lies below its chords through b, drawn on; twice that for one that is no parabola.
    const double skew = std::abs(c - b) / std::abs(b - a);
    const double rise = 2 * std::max((at_b.room - at_a.room) * skew, (at_b.room - at_c.room) / skew);
    if (at_a.conditions == at_b.conditions && at_c.conditions == at_b.conditions && at_b.room + rise < 0) {
      return std::nullopt;
    }
    const bool before = std::abs(b - a) > std::abs(c - b);
    const double x = b + kGoldenShare * ((before ? a : c) - b);
    const Placing at_x = placing(x);
    if (at_x.complete) {
      return x;
    }
    const bool better = at_b < at_x;
    double& side = before == better ? c : a;
    Placing& at_side = before == better ? at_c : at_a;
    side = better ? b : x;
    at_side = better ? at_b : at_x;
    b = better ? x : b;
    at_b = better ? at_x : at_b;
  }
  return std::nullopt;
}

}  // namespace

bool resume(Run& run, const std::vector<double>& drivers, const std::vector<double>& from) {
  if (is_stopped(run)) {
    return false;
  }
  if (has_come_back(run, drivers)) {
    return come_back(run, drivers);
  }
  if (run.plan().couples) {
    return false;  // their branch beyond the limit has no label to ask for
  }
  if (drivers.size() > 1) {
    const auto back = found_again(run, drivers, from);
    if (back) {
      go_on_from(run, *back, State(run.work.trial), drivers, from, drivers);
    }
    return back.has_value();
  }
  const Probes probes(run, drivers[0]);
  const double first = probes.first_from(from[0]);
  const double beyond = std::min(probes.first_from(drivers[0]), first + kMostProbes);
  for (double k = first; k <= beyond && !is_stopped(run); ++k) {
    const auto at = placed_between(run, probes.at(k - 1), probes.at(k), probes.at(k + 1));
    if (const auto arrives = at ? take_up(run, {*at}, drivers) : std::nullopt) {
      return *arrives || resume(run, drivers, run.at.lost.at);
    }
  }
  const auto arrives = is_stopped(run) ? std::nullopt : take_up(run, drivers, drivers);
  return arrives && (*arrives || resume(run, drivers, run.at.lost.at));
}

}  // namespace higherpair
