#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/front/model.hpp"

#include <atomic>
#include <optional>
#include <vector>

namespace higherpair {

/// The position at which a picture is taken.
struct Reached {
  Run run;
  double driver = 0;           ///< position of the (first) driver, in its unit
  std::optional<Event> limit;  ///< the limit position reached instead, where it could not go on
  std::vector<Event> passed;   ///< otherwise the events on the path that make it bad
};

/// Settings of a run that outputs only the position of the (first) driver.
[[nodiscard]] RunSettings driver_alone(const Model& model, double tolerance, const std::atomic<bool>* stop);

/// Moves the driver from its first position to `at`, or to the limit position before it. With several
/// drivers: the row of their run in which the first driver is nearest to `at`, among those that could be
/// assembled.
/// \param settings  from driver_alone
[[nodiscard]] Result<Reached> reach(const Model& model, const RunSettings& settings, double at);

/// An error unless some body has a position in one of the rows.
[[nodiscard]] std::optional<Error> nothing_to_draw(const Model& model, const std::vector<MotionRow>& rows);

}  // namespace higherpair
