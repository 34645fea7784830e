#pragma once

#include "higherpair/analysis/status.hpp"
#include "higherpair/io/profile.hpp"
#include "trial.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace higherpair::fire {

/// One row of a run.
struct RowValues {
  RowStatus status = RowStatus::kOk;
  bool rates = true;          ///< whether the rates of all bodies are defined
  std::vector<double> place;  ///< x, y [m] and angle [rad] of all bodies
  std::vector<double> velocity;
  std::vector<double> acceleration;
};

/// An event between rows.
struct Happening {
  std::string type;
  std::string item;       ///< joint or contact; empty: none
  double share = 0;       ///< fraction of the path, or of the time for `step`
  double driver = 0;      ///< coordinate of the first driver [rad or m]
  std::size_t row = 0;    ///< reported on the way to it
  bool is_limit = false;  ///< whether the motion is lost there, or begins again
};

/// A whole run of a profile, as made by `analyze` or `step`.
struct RunRecord {
  std::string not_started;  ///< why it cannot be started; empty: it has been
  std::vector<RowValues> rows;
  std::vector<Happening> events;
};

/// The largest absolute value, and the largest difference of two lists (infinite if any is NaN).
[[nodiscard]] double largest(const std::vector<double>& values);
[[nodiscard]] double difference(const std::vector<double>& a, const std::vector<double>& b);

/// \param timed  as in `step`, otherwise as in `analyze`
[[nodiscard]] RunRecord record_run(const Profile& profile, bool timed, std::int64_t samples);

/// The rows law: the results of a run do not depend on its number of rows. Runs the profile with 7, 61 and
/// 601 rows, and compares first the limit, the events before it and the rows that all runs share up to it,
/// then all that follows. At last it compares rows right before and behind events of a single driver's path
/// that are reached at once with those that are reached by many. The law of a failure names the kind of
/// disagreement.
[[nodiscard]] Failure rows_law(const Profile& profile, bool timed);

}  // namespace higherpair::fire
