#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "row_history.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace higherpair {

/// Everything that later rows need from a run that has come to a row.
struct RunPlace {
  Run run;
  RowHistory history;
};

/// Whether either may replace the other (go_on_alike for their runs).
[[nodiscard]] bool go_on_alike(const RunPlace& a, const RunPlace& b);

/// Moves ahead of a run over as few of its rows as the path allows, and gives the state of the run at
/// selected rows, so that the rows after them can be computed before the rows in front of them.
class RowScout {
public:
  /// \param start  a run that has not moved to a row yet
  explicit RowScout(Run start) : place_{std::move(start), {}} {}

  /// The state at a row of the schedule, not before the last one asked for. Undefined once the run is
  /// stopped.
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
