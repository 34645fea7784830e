#pragma once

#include "analysis/groups/group_solver.hpp"
#include "inputs.hpp"

#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace higherpair {

/// Lets a state of a run be used for other positions; restores it at the end of the scope unless `commit` was
/// called.
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

  /// The state to be restored.
  [[nodiscard]] const State& kept() const { return kept_; }
  /// Keeps the state as it is.
  void commit() { committed_ = true; }

private:
  State& state_;
  State kept_;
  bool committed_ = false;
};

[[nodiscard]] inline Planned model_of(const Run& run) {
  return {run.mechanism(), run.plan()};
}

/// Tries a step of `h` from run.at.state, which is at s, into run.work.trial. \returns the first group that
/// does not continue its motion smoothly, straight through change points (run.work.crossings)
[[nodiscard]] std::optional<std::size_t> try_step(Run& run, const Path& path, double s, double h);

/// Sets the rates of a state that is at s of the path.
void set_rates_on(Run& run, const Path& path, double s, State& state);

/// Sets the rates of run.at.state, which may be those of another path, at the beginning of this one.
void begin_path(Run& run, const Path& path);

/// The first group whose motion from run.at.state over `h` to run.work.trial, whose rates are set, is not
/// smooth.
[[nodiscard]] std::optional<std::size_t> broken_off(const Run& run, double h);

/// How fast the fastest body moves, per unit of the path: turns, or distances relative to the size.
[[nodiscard]] double fastest_body(const Run& run, const State& state);

/// Places all groups and sets their rates in run.work.trial, `x` beyond run.at.state, which is at s; in the
/// modes of run.at.state and without comparing with a prediction.
[[nodiscard]] bool solve_at(Run& run, const Path& path, double s, double x);

/// Leaves a row at a singular position: run.at.beside becomes run.work.trial, which is there, and
/// run.at.inputs those at s, where run.at.state is, short of it.
void rest_beside(Run& run, const Path& path, double s);

/// f(run.work.trial), a T or an optional T, as solve_at() solves it `x` beyond run.at.state; none where it
/// cannot. The state is restored.
template <class T, class F>
[[nodiscard]] std::optional<T> with_trial(Run& run, const Path& path, double s, double x, const F& f) {
  const StateAside aside(run.work.trial);
  return solve_at(run, path, s, x) ? std::optional<T>(f(run.work.trial)) : std::nullopt;
}

/// Returns change(), and restores run.work.trial unless it is true.
template <class F>
[[nodiscard]] bool change_trial(Run& run, const F& change) {
  StateAside aside(run.work.trial);
  const bool changed = change();
  if (changed) {
    aside.commit();
  }
  return changed;
}

/// As solve_at(), but with contacts searched from their places in run.at.state, as try_step does, so that
/// those that have left their spans can be recognised.
[[nodiscard]] bool solve_from_spans(Run& run, const Path& path, double s, double x);

/// The same as `solve_at`, but from `from` at s instead of run.at.state.
[[nodiscard]] bool solve_from(Run& run, const State& from, const Path& path, double s, double x);

/// Places all groups at s, near `from` and in its modes, and makes the result run.at.state; false, with
/// run.at.state unchanged, where that is not possible.
[[nodiscard]] bool settle(Run& run, const Path& path, double s, const State& from);

/// The same as `solve_at` for the groups before `end` only, which are interpolated next to their change
/// points.
[[nodiscard]] bool solve_before(Run& run, const Path& path, std::size_t end, double s, double x);

/// How much of a mechanism can be placed at a position of its drivers.
struct Placeable {
  bool complete = false;
  std::size_t conditions = 0;  ///< number of conditions met before the first failure; each group has two: its
                               ///< reach and the ends of its joints
  double room = 0;             ///< of the first condition that fails: < 0; -inf if it is unknown by how much

  /// Whether less can be placed, or the same but missing by more.
  [[nodiscard]] bool operator<(const Placeable& other) const {
    return std::tie(complete, conditions, room) < std::tie(other.complete, other.conditions, other.room);
  }
};

/// Places all groups at these inputs in run.work.trial in the modes of run.at.state, however far that is;
/// rates are those of set_unit_motions().
[[nodiscard]] Placeable place_anew(Run& run, const std::vector<double>& inputs);

}  // namespace higherpair
