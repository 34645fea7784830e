#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair::cli {

/// A mechanism whose motion is known: a profile (its `title` names it, its `description` is the source) and
/// the table that is right for it, a CSV whose head is that of the program's own tables, those of `step`
/// where there is a column `time`. Columns may be left out, rows not. Words and empty fields have to be the
/// same, the residual not; rows need not be `ok` only where there is a column `status`.
struct Reference {
  std::string_view name;
  std::string_view profile;
  std::string_view table;
};

/// The references that the program carries: the files of tools/cli/verify, put into it by the build.
[[nodiscard]] std::span<const Reference> shipped_references();

/// One column of a reference where it is worst.
struct ColumnCheck {
  std::string column;  ///< with its unit, as in the head
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
  /// Whether everything was compared and no error is larger than `bound`.
  [[nodiscard]] bool holds(double bound) const;
};

/// Runs a reference the way a user's file runs, and compares every cell of its table.
[[nodiscard]] Verdict verify(const Reference& reference);

}  // namespace higherpair::cli
