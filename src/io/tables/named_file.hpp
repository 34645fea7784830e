#pragma once

#include "io/document/table_reader.hpp"
#include "point_table.hpp"

#include <optional>
#include <string>

namespace higherpair::io_detail {

/// The text of a file named in a profile; reports why it cannot be read.
/// \param what  what the file should be, such as "table", for messages
[[nodiscard]] std::optional<std::string> read_named_file(TableReader& table, const Item& item,
                                                         const std::string& what);
/// Reports a mistake on a line of such a file.
void report_in_file(TableReader& table, const Item& item, int line, const std::string& message);

/// The key `units` of a file, which must be a unit of length.
[[nodiscard]] std::optional<Unit> read_file_unit(TableReader& table);

/// The points of such a file (see read_points); reports its mistakes.
[[nodiscard]] std::optional<PointTable> read_point_file(TableReader& table, const Item& item,
                                                        const PointColumns& columns, const Units& units);
/// The same for points in the plane; the table may give their unit of length by `units`.
[[nodiscard]] std::optional<PointTable> read_place_file(TableReader& table, const Item& item);

}  // namespace higherpair::io_detail
