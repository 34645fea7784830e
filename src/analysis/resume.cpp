#include "resume.hpp"

#include "higherpair/geometry/vector.hpp"
#include "limit_events.hpp"
#include "outlook.hpp"
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
constexpr double kNearestBegin = 1e-12;  // of the driver's scale: beside a limit, for the first step from it

// Stretches that meet at poles, one behind the other, before it is rounding that makes and ends them.
constexpr int kMostPoles = 16;
constexpr double kTooNearLimit = 1e-6;  // GroupState::sine there, of its lever
constexpr double kInside = 1e-3;        // of the driver's scale: from where a limit with a row is come to

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

// Whether a group is so near to its limit that its place is known to half its digits only. Beside a limit
// that is hardly one (a pressure angle of 90 degrees where the law stands still) rounding alone makes and
// ends such places by the thousand.
bool is_beside_limit(const State& state) {
  return std::any_of(state.groups.begin(), state.groups.end(), [](const GroupState& group) {
    return std::abs(group.sine) <= kTooNearLimit * group.lever;
  });
}

// The branch at a position of the drivers, where run.work.trial has been placed, followed back on the way to
// `from`: to where this stretch of it begins. Only a row may be at the limit itself.
std::optional<Run> followed_back(const Run& run, const std::vector<double>& at,
                                 const std::vector<double>& from, bool is_row) {
  if (!is_row && is_beside_limit(run.work.trial)) {
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

// The same, if the branch is there.
std::optional<Run> found_again(Run& run, const std::vector<double>& at, const std::vector<double>& from,
                               bool is_row) {
  return place_anew(run, at).complete ? followed_back(run, at, from, is_row) : std::nullopt;
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

// For a row beside the limit where a stretch begins: placed there, a position has half its digits only. It is
// taken from the limit as it is solved for on the way from within the stretch, where run.at.state then
// remains.
bool come_to_begin(Run& run, const std::vector<double>& at, double ahead) {
  const std::vector<double> within = {at[0] + std::copysign(kInside * driver_scale(run, 0), ahead)};
  const auto inside = found_again(run, within, at, false);
  if (!inside || !inside->at.held || !inside->at.beside) {
    return false;
  }
  const State lost = run.at.state;
  const State& begin = *inside->at.beside;
  go_on_from(run, *inside, begin, inside->at.drivers, run.at.lost.at, at);
  take_short_way(run, lost, begin);
  run.at.beside = std::exchange(run.at.state, inside->at.state);
  take_short_way(run, lost, begin);
  return true;
}

bool follow_to(Run& run, const std::vector<double>& drivers,
               double first_step = std::numeric_limits<double>::infinity()) {
  Path path;
  set_path(path, run.at.drivers, drivers);
  return follow(run, path, first_step);
}

// Takes up the stretch that holds `at` where it begins, if that is before the drivers' positions, and goes on
// to these; whether it arrives there. `poles` says how many other stretches may be looked for before it.
std::optional<bool> take_up(Run& run, const std::vector<double>& at, const std::vector<double>& drivers,
                            int poles = kMostPoles) {
  const std::vector<double> lost_at = run.at.lost.at;
  const double ahead = at[0] - lost_at[0];
  if (!place_anew(run, at).complete) {
    return std::nullopt;
  }
  const bool is_row = at == drivers;
  if (is_row && is_beside_limit(run.work.trial)) {
    if (come_to_begin(run, at, ahead)) {
      return true;
    }
    (void)place_anew(run, at);
  }
  const auto back = followed_back(run, at, lost_at, is_row);
  const std::vector<double> begin = back && !back->at.held ? back->at.lost.from : lost_at;
  const State found = run.work.trial;
  if (back && !back->at.held) {
    // At a pole another stretch ends where this one begins.
    const double across = 2 * back->at.lost.at[0] - begin[0];
    const bool is_new = poles > 0 && (across - lost_at[0]) * ahead > 0 && (across - begin[0]) * ahead < 0;
    if (const auto arrives = is_new ? take_up(run, {across}, drivers, poles - 1) : std::nullopt) {
      return arrives;
    }
  }
  if (!back || (drivers[0] - begin[0]) * ahead < 0) {
    return std::nullopt;
  }
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

// Goes on where the branch is found first behind `from`, up to the positions of the only driver.
bool resume_ahead(Run& run, const std::vector<double>& drivers, const std::vector<double>& from) {
  const Probes probes(run, drivers[0]);
  const double first = probes.first_from(from[0]);
  const double beyond = std::min(probes.first_from(drivers[0]), first + kMostProbes);
  const auto outlook = [&](double k) {
    return outlook_at(run, probes.at(k), probes.at(k + 1) - probes.at(k));
  };
  std::optional<Outlook> before;
  for (double k = first; k <= beyond && !is_stopped(run); ++k) {
    const Outlook here = outlook(k);
    std::optional<double> at;
    if (here.placing.complete) {
      at = here.x;
    } else if (std::isfinite(here.placing.room)) {
      // What a contact lacks has no number, and beside its limit it takes long to see that it cannot be
      // placed.
      at = placed_between(run, before ? *before : outlook(k - 1), here);
    }
    if (const auto arrives = at ? take_up(run, {*at}, drivers) : std::nullopt) {
      return *arrives || resume(run, drivers, run.at.lost.at);
    }
    before = here;
  }
  const auto arrives = is_stopped(run) ? std::nullopt : take_up(run, drivers, drivers);
  return arrives && (*arrives || resume(run, drivers, run.at.lost.at));
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
    const auto back = found_again(run, drivers, from, true);
    if (back) {
      go_on_from(run, *back, State(run.work.trial), drivers, from, drivers);
    }
    return back.has_value();
  }
  return resume_ahead(run, drivers, from);
}

}  // namespace higherpair
