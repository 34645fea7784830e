#pragma once

#include "group_solver.hpp"
#include "higherpair/analysis/run.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace higherpair {

/// While it exists, run.work.trial serves for other positions within a step; then it is again what it was.
class TrialAside {
public:
  explicit TrialAside(Run& run) : run_(run), kept_(run.work.trial) {}
  TrialAside(const TrialAside&) = delete;
  TrialAside& operator=(const TrialAside&) = delete;
  ~TrialAside() { std::swap(run_.work.trial, kept_); }

  /// What run.work.trial was.
  [[nodiscard]] const State& state() const { return kept_; }

private:
  Run& run_;
  State kept_;
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

/// One unit of the drivers in the path's coordinate.
[[nodiscard]] double unit_of(const Run& run, const Path& path);

/// Places all groups and sets their rates in run.work.trial, `x` beyond run.at.state, which is at s; in
/// the modes of run.at.state and without asking whether they agree with a prediction.
[[nodiscard]] bool solve_at(Run& run, const Path& path, double s, double x);

/// The same for the groups before `end` only.
[[nodiscard]] bool solve_before(Run& run, const Path& path, std::size_t end, double s, double x);

/// Places all groups at the drivers' positions in run.work.trial in the modes of run.at.state, however far
/// that is; rates are per unit of a single driver.
[[nodiscard]] bool place_anew(Run& run, const std::vector<double>& drivers);

}  // namespace higherpair
