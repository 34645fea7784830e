#pragma once

#include "higherpair/front/motion.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace higherpair {

/// The rows before which a column jumps, in ascending order: an event between that row and the one before
/// ends a branch or changes a contact, and the value changes by much more than in the neighbouring steps. No
/// line may join these rows in a plot.
/// \param values    of the rows that are plotted
/// \param index_of  their row, or the next one after it, for a row of the run
[[nodiscard]] std::vector<std::size_t> jumps_of(std::span<const double> values,
                                                const std::vector<Event>& events,
                                                const std::function<std::size_t(std::int64_t)>& index_of);

}  // namespace higherpair
