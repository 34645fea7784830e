#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/profile.hpp"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

struct Column {
  std::string name;
  std::string unit;  ///< without brackets; empty for a text column
};

/// A value of a table: a number in the profile's units, a word, or undefined.
using Cell = std::variant<std::monostate, double, std::string_view>;

/// The motion table of a profile: what its columns are, and the cells of each row in the profile's units.
class MotionTable {
public:
  /// Fails where two columns would have the same name; the message names both.
  [[nodiscard]] static tl::expected<MotionTable, std::string> make(const Profile& profile, const Plan& plan,
                                                                   bool timed);

  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }

  /// The cells of a row, one for each column; valid until the next call.
  [[nodiscard]] const std::vector<Cell>& cells(const Run& run, const MotionRow& row,
                                               const DriverState& driver, double time);

private:
  struct Scale {
    Scaling length, angle, velocity, angular_velocity, acceleration, angular_acceleration;
  };

  void add_names(const Profile& profile, const Plan& plan);
  void add_bodies(const Run& run, const MotionRow& row);
  void add_joints(const Run& run, const MotionRow& row);
  void add_contact(const Run& run, const MotionRow& row);
  void number(double value);
  void length(std::optional<double> value);

  bool timed_ = false;
  Scale scale_;
  std::vector<Column> columns_;
  std::vector<Cell> cells_;
  std::optional<std::array<double, 2>> arc_start_;  ///< of the first row
};

/// The name of a status as results print it.
[[nodiscard]] std::string_view name_of(RowStatus status);

/// One line of CSV (with its line end) appended to `out`: the header, or a row of cells.
void append_csv_header(const std::vector<Column>& columns, std::string& out);
void append_csv_row(const std::vector<Cell>& cells, std::string& out);

}  // namespace higherpair
