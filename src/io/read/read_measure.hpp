#pragma once

#include "higherpair/io/tasks.hpp"
#include "io/document/table_reader.hpp"
#include "number_unit.hpp"

#include <optional>

namespace higherpair::io_detail {

/// \param place  the unit of `at`
/// Reads the keys `column`, `of` and `at` of a table; the caller reads the other keys and finishes the table.
/// Whether the column exists is known only once the mechanism is run. None if a key is missing or wrong.
[[nodiscard]] std::optional<Measure> read_measure(TableReader& table, const NumberUnit& place);

}  // namespace higherpair::io_detail
