#pragma once

#include "higherpair/analysis/derivatives.hpp"
#include "higherpair/analysis/jerk.hpp"
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

/// What the columns of a row are made from: a run that has moved to it.
struct RowSource {
  const Run& run;
  const std::vector<DriverState>& drivers;  ///< of Mechanism::drivers
  double time = 0;                          ///< in the profile's unit
  const Reactions* reactions = nullptr;     ///< where there are columns of forces
  bool opens = false;                       ///< a contact pulls in a row that is `ok` otherwise
  const RowHistory* history = nullptr;      ///< with this row; none: arcs of contacts are left undefined

  [[nodiscard]] RowStatus status() const { return opens ? RowStatus::kContactOpen : run.row.status; }
};

/// Writes a value where there is one.
inline void put(const std::optional<double>& value, double* out) {
  if (value) {
    *out = *value;
  }
}

/// A column as it is added: numbers come in SI units and are scaled.
struct NewColumn {
  std::string name;
  Dimension dimension;
  bool in_profile_units = false;  ///< the number comes as the table shows it
  std::span<const std::string_view> words = {};
};

/// The columns of a table. Those that are worked out together make a block; of the blocks only those are
/// worked out of which a column was chosen.
class ColumnSet {
public:
  /// Writes a number for each column of the block; it finds NaN there.
  using Fill = std::function<void(const RowSource&, double* out)>;

  ColumnSet(const Units& units, std::vector<std::string> globs);

  /// Adds a block of columns behind those that are there.
  /// \param anywhere  whether it is filled also where the row could not be assembled
  void add(const std::vector<NewColumn>& columns, Fill fill, bool anywhere = false);

  /// To be called after the last `add`. Fails where two columns have the same name, and for a glob that no
  /// column matches.
  [[nodiscard]] tl::expected<void, Diagnostic> finish(const std::string& source);

  /// Those chosen, in the order in which they were added.
  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }

  /// Of a chosen column.
  [[nodiscard]] const Dimension& dimension(std::size_t column) const { return dimensions_[column]; }

  /// Their values in a row.
  void fill(const RowSource& source, std::vector<double>& values);

private:
  struct Block {
    Fill fill;
    bool anywhere = false;
    std::size_t begin = 0;  // of its columns in the buffer
    std::size_t end = 0;
    bool chosen = false;
  };
  struct Place {
    std::size_t slot = 0;  // in the buffer
    Scaling scale;
  };

  Units units_;
  std::vector<std::string> globs_;
  std::vector<bool> glob_matches_;
  std::vector<std::string> names_;  // of all columns
  std::vector<Block> blocks_;
  std::vector<Column> columns_;
  std::vector<Place> places_;  // of the chosen ones
  std::vector<Dimension> dimensions_;
  std::vector<double> buffer_;
};

/// The cells of a row of CSV appended to `out`: no line end.
void append_csv_cells(std::span<const Column> columns, std::span<const double> values, std::string& out);
/// A column's name with its unit, as in the header of CSV.
[[nodiscard]] std::string csv_head(const Column& column);

/// Which column has this name; columns.size(): none.
[[nodiscard]] std::size_t column_slot(const std::vector<Column>& columns, std::string_view name);

/// Appends a cell of text, in quotes where it has to be.
void append_csv_text(std::string_view text, std::string& out);

/// Whether a name is one that the glob means: `*` is any text, `?` any character.
[[nodiscard]] bool matches(std::string_view glob, std::string_view name);

/// The motion: time, drivers, bodies and their points, joints, contacts.
void add_motion_columns(ColumnSet& set, const Profile& profile, const Units& units, bool in_time);
/// The reactions of joints and contacts, and the effort of the drivers.
void add_force_columns(ColumnSet& set, const Mechanism& mechanism);
/// Status and residual.
void add_status_columns(ColumnSet& set);
/// The third derivatives of bodies and points; of each contact that of the coordinate of the joint on which
/// it moves a body, and what it would be if every contact were replaced by its equivalent link.
void add_jerk_columns(ColumnSet& set, const Profile& profile, const Plan& plan);
/// The kth derivatives of bodies and points, k = 3 … order.
void add_derivative_columns(ColumnSet& set, const Mechanism& mechanism, int order);

}  // namespace higherpair
