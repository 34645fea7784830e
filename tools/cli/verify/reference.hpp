#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair::cli {

/// A mechanism whose motion is known: a profile (`title` gives its name, `description` the source) and a CSV
/// table of the correct values. Its header is that of the program's tables, those of `step` if there is a
/// column `time`. Columns may be left out, rows may not. Words and empty fields have to agree; the residual
/// is not compared. All rows have to be `ok`, unless the table has a column `status`.
struct Reference {
  std::string_view name;
  std::string_view profile;
  std::string_view table;
};

/// The references built into the program: the files in tools/cli/verify.
[[nodiscard]] std::span<const Reference> shipped_references();

/// The row of a column with the largest error.
struct ColumnCheck {
  std::string column;  ///< with its unit, as in the header
  double key = 0;      ///< driver position or time of the row
  double value = 0;
  double expected = 0;
  double error = 0;  ///< |value - expected| over the column's scale: its largest |expected|, or a
                     ///< millionth of the largest of that unit (1 if all are 0)
};

struct Verdict {
  std::string title;
  std::string source;
  std::string failure;  ///< why nothing could be compared; empty otherwise
  std::vector<ColumnCheck> columns;
  double seconds = 0;  ///< from the profile's text to the last row

  /// The column with the largest error. \pre there are columns
  [[nodiscard]] const ColumnCheck& worst() const;
  /// Whether everything was compared and no error exceeds `bound`.
  [[nodiscard]] bool holds(double bound) const;
};

/// Runs a reference as a user's file would be run, and compares every cell of its table.
[[nodiscard]] Verdict verify(const Reference& reference);

}  // namespace higherpair::cli
