#pragma once

#include "group_solver.hpp"
#include "higherpair/analysis/run.hpp"

#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace higherpair {

/// Lets a state of a run serve for other positions; at the end of the scope it is again what it was, unless
/// `commit` was called.
class StateAside {
public:
  explicit StateAside(State& state) : state_(state), kept_(state) {}
  StateAside(const StateAside&) = delete;
  StateAside& operator=(const StateAside&) = delete;
  ~StateAside() {
    if (!committed_) {
      std::swap(state_, kept_);
    }
  }

  /// What the state was.
  [[nodiscard]] const State& kept() const { return kept_; }
  /// Leaves the state as it is now.
  void commit() { committed_ = true; }

private:
  State& state_;
  State kept_;
  bool committed_ = false;
};

[[nodiscard]] inline Planned model_of(const Run& run) {
  return {run.mechanism(), run.plan()};
}

/// The drivers at their positions: a single one moves by one unit, several rest.
void set_unit_motions(const std::vector<double>& positions, std::vector<DriverMotion>& motions);

struct StepResult {
  enum Kind { kOk, kLost, kDisagrees } kind = kOk;
  std::size_t group = 0;  ///< which failed
};

/// Tries a step of `h` from run.at.state, which is at s, into run.work.trial; kOk only where every group
/// continues its motion smoothly, straight on through change points (run.work.crossings).
[[nodiscard]] StepResult try_step(Run& run, const Path& path, double s, double h);

/// The first group that run.work.trial, whose rates are set, does not show as a smooth continuation of
/// run.at.state over `h`.
[[nodiscard]] std::optional<std::size_t> broken_off(const Run& run, double h);

/// What counts as one unit of a driver's coordinate: a radian, or the size of the mechanism.
[[nodiscard]] double driver_scale(const Run& run, std::size_t driver);

/// The driver that moves most between two positions, in its unit.
[[nodiscard]] std::size_t leading_driver(const Run& run, const std::vector<double>& from,
                                         const std::vector<double>& to);

/// How far that one moves, in its unit.
[[nodiscard]] double way_between(const Run& run, const std::vector<double>& from,
                                 const std::vector<double>& to);

/// One unit of the drivers in the path's coordinate.
[[nodiscard]] double unit_of(const Run& run, const Path& path);

/// The largest of the drivers' coordinates at s, in the path's coordinate: what a rounding of these is a
/// rounding of.
[[nodiscard]] double size_at(const Run& run, const Path& path, double s);

/// Places all groups and sets their rates in run.work.trial, `x` beyond run.at.state, which is at s; in
/// the modes of run.at.state and without asking whether they agree with a prediction.
[[nodiscard]] bool solve_at(Run& run, const Path& path, double s, double x);

/// The same with the contacts looked for from their places in run.at.state on, as try_step does, so that it
/// shows which have left their spans.
[[nodiscard]] bool solve_from_spans(Run& run, const Path& path, double s, double x);

/// `solve_at` from another state at s than run.at.state.
[[nodiscard]] bool solve_from(Run& run, const State& from, const Path& path, double s, double x);

/// Places all groups at s in the modes of `from` and near it, and makes that run.at.state; false, and
/// run.at.state as it was, where that is not possible.
[[nodiscard]] bool settle(Run& run, const Path& path, double s, const State& from);

/// The same as `solve_at` for the groups before `end` only.
[[nodiscard]] bool solve_before(Run& run, const Path& path, std::size_t end, double s, double x);

/// How much of a mechanism can be placed at a position of its drivers.
struct Placeable {
  bool complete = false;
  std::size_t conditions =
      0;            ///< that can be met one after the other: of each group its reach and its joints' ends
  double room = 0;  ///< of the first that cannot: < 0; -inf: by how much it fails is not known

  /// Whether less of it can be placed, or as much with more lacking.
  [[nodiscard]] bool operator<(const Placeable& other) const {
    return std::tie(complete, conditions, room) < std::tie(other.complete, other.conditions, other.room);
  }
};

/// Places all groups at the drivers' positions in run.work.trial in the modes of run.at.state, however far
/// that is; rates are per unit of a single driver.
[[nodiscard]] Placeable place_anew(Run& run, const std::vector<double>& drivers);

}  // namespace higherpair
