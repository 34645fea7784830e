#pragma once

#include "higherpair/io/tasks.hpp"
#include "table_reader.hpp"

#include <optional>

namespace higherpair::io_detail {

/// The keys `column`, `of` and `at` of a table; other keys are left to the caller, who finishes the table.
/// Whether there is such a column only a run can say. Nothing where a key is missing or wrong.
[[nodiscard]] std::optional<Measure> read_measure(TableReader& table);

}  // namespace higherpair::io_detail
