#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/front/motion.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/profile.hpp"
#include "row_history.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// What the columns of a row are computed from: a run that has moved to the row.
struct RowSource {
  const Run& run;
  const std::vector<DriverState>& drivers;  ///< for each of Mechanism::drivers
  double time = 0;                          ///< in the profile's unit
  const Reactions* reactions = nullptr;     ///< not null where there are columns of forces
  bool opens = false;                       ///< a contact would have to pull in a row that is otherwise `ok`
  const RowHistory* history = nullptr;      ///< including this row; null: arcs of contacts are left undefined

  [[nodiscard]] RowStatus status() const { return opens ? RowStatus::kContactOpen : run.row.status; }
};

/// Writes a value if it has one.
inline void put(const std::optional<double>& value, double* out) {
  if (value) {
    *out = *value;
  }
}

/// A column to be added: its values come in SI units and are scaled.
struct NewColumn {
  std::string name;
  Dimension dimension;
  bool in_profile_units = false;  ///< values come as the table shows them
  std::span<const std::string_view> words = {};
};

/// The columns of a table. Columns that are computed together form a block; a block is computed only if one
/// of its columns was chosen.
class ColumnSet {
public:
  /// Writes a value for each column of the block into `out`, which is filled with NaN before.
  using Fill = std::function<void(const RowSource&, double* out)>;

  ColumnSet(const Units& units, std::vector<std::string> globs);

  /// Appends a block of columns.
  /// \param anywhere  whether it is filled even in rows that cannot be assembled
  void add(const std::vector<NewColumn>& columns, Fill fill, bool anywhere = false);

  /// Call after the last `add`. Fails where two columns have the same name, and for a glob that matches no
  /// column.
  [[nodiscard]] tl::expected<void, Diagnostic> finish(const std::string& source);

  /// The chosen columns, in the order in which they were added.
  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }

  /// Dimension of a chosen column.
  [[nodiscard]] const Dimension& dimension(std::size_t column) const { return dimensions_[column]; }

  /// Computes the values of the chosen columns in a row.
  void fill(const RowSource& source, std::vector<double>& values);

private:
  struct Block {
    Fill fill;
    bool anywhere = false;
    std::size_t begin = 0;  // position of its columns in the buffer
    std::size_t end = 0;
    bool chosen = false;
  };
  struct Place {
    std::size_t slot = 0;  // position in the buffer
    Scaling scale;
  };

  Units units_;
  std::vector<std::string> globs_;
  std::vector<bool> glob_matches_;
  std::vector<std::string> names_;  // of all columns, chosen or not
  std::vector<Block> blocks_;
  std::vector<Column> columns_;
  std::vector<Place> places_;  // of the chosen columns
  std::vector<Dimension> dimensions_;
  std::vector<double> buffer_;
};

/// Appends the cells of a row of CSV to `out`, without a line end.
void append_csv_cells(std::span<const Column> columns, std::span<const double> values, std::string& out);

/// Index of the column of this name; columns.size() if there is none.
[[nodiscard]] std::size_t column_slot(const std::vector<Column>& columns, std::string_view name);

/// A name that occurs twice; null if there is none.
[[nodiscard]] const std::string* repeated(const std::vector<std::string>& names);

/// Appends a cell of text, in quotes where necessary.
void append_csv_text(std::string_view text, std::string& out);

/// Whether the glob matches the name: `*` is any text, `?` any character.
[[nodiscard]] bool matches(std::string_view glob, std::string_view name);

/// Motion: time, drivers, bodies and their points, joints, contacts.
void add_motion_columns(ColumnSet& set, const Profile& profile, const Units& units, bool in_time);
/// The reactions of joints and contacts, and the effort of the drivers.
void add_force_columns(ColumnSet& set, const Mechanism& mechanism);
/// Status and residual.
void add_status_columns(ColumnSet& set);
/// The third time derivatives of bodies and points; for each contact the jerk of the joint on which it moves
/// a body, and the same with every contact replaced by its equivalent linkage.
void add_jerk_columns(ColumnSet& set, const Profile& profile, const Plan& plan);
/// The kth derivatives of bodies and points, k = 3 … order.
void add_derivative_columns(ColumnSet& set, const Mechanism& mechanism, int order);

}  // namespace higherpair
