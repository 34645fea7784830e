#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/front/model.hpp"

#include <atomic>
#include <optional>
#include <vector>

namespace higherpair {

/// Where a picture of one position is taken.
struct Reached {
  Run run;
  double driver = 0;           ///< position of the (first) driver, in its unit
  std::optional<Event> limit;  ///< the limit position at which it is, where it could not go on
  std::vector<Event> passed;   ///< else what lies on the way and keeps the path from being good
};

/// Settings of a run of which only the position of the (first) driver is asked for.
[[nodiscard]] RunSettings driver_alone(const Model& model, double tolerance, const std::atomic<bool>* stop);

/// Moves the driver from its first position to `at`, or to the limit position before it. With several drivers
/// the row of their run in which the first one is nearest to `at`, of those that have a position.
/// \param settings  as driver_alone gives them
[[nodiscard]] Result<Reached> reach(const Model& model, const RunSettings& settings, double at);

/// An error unless bodies have a place in one of the rows.
[[nodiscard]] std::optional<Error> nothing_to_draw(const Model& model, const std::vector<MotionRow>& rows);

}  // namespace higherpair
