#pragma once

#include "higherpair/io/units.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair::io_detail {

/// What a table of two columns is to hold.
struct PointColumns {
  std::array<std::string_view, 2> names;  ///< by which a header may call them
  std::array<Dimension, 2> dimensions;
};

/// Points from a file, with the line of each.
struct PointTable {
  std::vector<std::array<Quantity, 2>> points;
  std::vector<int> lines;
  std::array<int, 2> decimals = {};  ///< the most digits behind the point, by columns
  std::array<double, 2> unit = {};   ///< of a column, in SI units
};

/// Reads a text of two columns, separated by commas, semicolons, tabs or spaces. A first line that does not
/// begin with a number names the columns; they may then be any two of several, with a name before a point,
/// and have units in brackets: "x[deg],s[mm]", "cam.E.x[mm]". Numbers are in the profile's units otherwise.
/// Empty lines and lines that begin with # are left out. The error has a sentence for each of the first
/// mistakes, "line 7: …".
[[nodiscard]] tl::expected<PointTable, std::vector<std::string>> read_points(std::string_view text,
                                                                             const PointColumns& columns,
                                                                             const Units& units);

/// Digits behind the point that a number takes in decimal: 3 for 0.125 and 1.25e-1, 0 for 1250.
[[nodiscard]] int decimals_of(std::string_view number);

}  // namespace higherpair::io_detail
