#pragma once

#include "higherpair/io/units.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair::io_detail {

/// The two columns expected in a table.
struct PointColumns {
  std::array<std::string_view, 2> names;  ///< that a header may use
  std::array<Dimension, 2> dimensions;
};

/// Points from a file, with the line number of each.
struct PointTable {
  std::vector<std::array<Quantity, 2>> points;
  std::vector<int> lines;
  std::array<int, 2> decimals = {};  ///< largest number of decimals in each column
  std::array<double, 2> unit = {};   ///< of each column, in SI units
};

/// Reads a text of two columns, separated by commas, semicolons, tabs or spaces. A first line that does not
/// begin with a number is a header. It may name more columns than these two, prefix their names by an owner
/// with a point, and give units in brackets: "x[deg],s[mm]", "cam.E.x[mm]". A name without an owner is
/// preferred; of those with an owner only one may fit. Without units numbers are in the profile's units.
/// Empty lines and lines that begin with # are skipped. On failure returns a message for
/// each of the first few mistakes, "line 7: …".
[[nodiscard]] tl::expected<PointTable, std::vector<std::string>> read_points(std::string_view text,
                                                                             const PointColumns& columns,
                                                                             const Units& units);

/// The number of decimals that a number has when written without exponent: 3 for 0.125 and 1.25e-1, 0 for
/// 1250.
[[nodiscard]] int decimals_of(std::string_view number);

}  // namespace higherpair::io_detail
