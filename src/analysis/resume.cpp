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
#include <utility>

// Beyond a limit at which the motion was lost.

namespace higherpair {
namespace {

constexpr double kProbe = kPi / 144;  // of the driver's scale: where a branch that was lost is looked for
constexpr double kMostProbes = 1e4;

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

// Takes the branch up again at the drivers' positions, if it is there; an event says where the stretch
// begins: at the limit on the way back to `from`.
bool take_up(Run& run, const std::vector<double>& drivers, const std::vector<double>& from) {
  if (!place_anew(run, drivers)) {
    return false;
  }
  const State lost = run.at.state;
  Run back = run;
  std::swap(back.at.state, back.work.trial);
  back.events.clear();
  back.at.held = true;
  back.at.beside.reset();
  back.at.drivers = drivers;
  Path path_back;
  set_path(path_back, drivers, from);
  if (follow(back, path_back) && has_track(run)) {
    return false;  // without a limit on the way back it is a contact that the follower cannot have come to
  }
  std::swap(run.at.state, run.work.trial);
  renew_overlaps(run);
  run.at.held = true;
  run.at.beside.reset();
  run.at.drivers = drivers;
  Path path;
  set_path(path, from, drivers);
  for (RunEvent& event : back.events) {
    // Where a curve ends the motion may have gone on over the edge.
    const bool is_last = &event == &back.events.back();
    if (event.type == EventType::kLimitPosition || (event.type == EventType::kEnd && is_last)) {
      event.share = 1 - event.share;
      report_limit(run, path, std::move(event));
    }
  }
  if (!back.at.held) {
    take_short_way(run, lost, back.at.state);
  }
  return true;
}

// Where a branch that was lost is looked for between `from` and `to`: every kProbe of the driver from the
// limit, so that it is found again at the same place whatever the rows.
std::vector<double> probes(const Run& run, double from, double to) {
  const double step = std::copysign(kProbe * driver_scale(run, 0), to - from);
  const double first = std::max(1.0, std::ceil((from - run.at.lost.at[0]) / step));
  const double last = std::min((to - run.at.lost.at[0]) / step, first + kMostProbes);
  std::vector<double> found;
  for (double k = first; k < last; ++k) {
    found.push_back(run.at.lost.at[0] + k * step);
  }
  return found;
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
    return take_up(run, drivers, from);
  }
  for (const double probe : probes(run, from[0], drivers[0])) {
    if (is_stopped(run)) {
      return false;
    }
    const std::vector<double> at{probe};
    if (take_up(run, at, run.at.lost.at)) {
      Path path;
      set_path(path, at, drivers);
      return follow(run, path) || resume(run, drivers, run.at.lost.at);
    }
  }
  return take_up(run, drivers, run.at.lost.at);
}

}  // namespace higherpair
