#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "row_history.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace higherpair {

/// All that later rows take from a run that has come to a row.
struct RunPlace {
  Run run;
  RowHistory history;
};

/// Whether either may take the place of the other (go_on_alike of their runs).
[[nodiscard]] bool go_on_alike(const RunPlace& a, const RunPlace& b);

/// Goes ahead of a run over few of its rows, as few as its path allows, and knows how the run is at others:
/// so the rows behind them can be worked out before those in front of them.
class RowScout {
public:
  /// \param start  a run that has moved to no row yet
  explicit RowScout(Run start) : place_{std::move(start), {}} {}

  /// The run at a row of the schedule, not before the last one asked for. Means nothing once it is stopped.
  const RunPlace& go_to(const DriverSchedule& schedule, std::int64_t row);

private:
  void leap(const DriverSchedule& schedule, std::int64_t to);
  bool leap_at_once(const DriverSchedule& schedule, std::int64_t to);
  void step(const DriverSchedule& schedule, std::int64_t to);

  RunPlace place_;
  std::int64_t row_ = -1;
  std::vector<DriverMotion> motions_;
};

}  // namespace higherpair
