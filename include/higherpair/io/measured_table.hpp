#pragma once

#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/units.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// A column of a table that was measured.
struct MeasuredColumn {
  std::string name;                   ///< "slider.x"
  std::string unit;                   ///< of the header, "mm" in `slider.x[mm]`; empty: it has none
  std::vector<double> values;         ///< one for each row, as written; NaN: missing
  Place place;                        ///< of the header
  std::optional<Diagnostic> mistake;  ///< the first field that is no number, if there is one
};

/// A table of numbers with a line that names the columns.
struct MeasuredTable {
  std::string source;                   ///< its name in messages
  std::vector<MeasuredColumn> columns;  ///< all of one length
  std::vector<int> lines;               ///< of the rows, from 1; if empty, the rows are counted
};

/// Reads a text of columns separated by commas, semicolons, tabs or spaces. The first line names them, each
/// with a unit in brackets or without. Missing values are empty fields, `nan`, `na` or `null`. Empty lines
/// and lines that begin with # are left out. A field that is not a number invalidates its column only. Fails
/// for a missing header, no rows, a row with a different number of fields, a repeated name, and more than
/// 5000 columns.
/// \param names  of the columns, for a text without a header; empty: it must have one
[[nodiscard]] Result<MeasuredTable> read_measured_text(std::string_view text, const std::string& source,
                                                       const std::vector<std::string>& names = {});
/// The same for a file.
[[nodiscard]] Result<MeasuredTable> read_measured_file(const std::string& path,
                                                       const std::vector<std::string>& names = {});

/// The factor from the unit of a header to the unit of a table's column; the error is the end of a sentence
/// about the header ("kg is a mass, expected a length, such as mm").
/// \param unit  of a column in these units, "deg/s^2"
[[nodiscard]] tl::expected<double, std::string> factor_between(const std::string& header,
                                                               const std::string& unit, const Units& units);

}  // namespace higherpair
