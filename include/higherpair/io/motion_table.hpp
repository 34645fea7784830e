#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/contact/details.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/profile.hpp"

#include <array>
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
  /// Fails where two columns would have the same name; the message names it. The profile must outlive the
  /// table.
  [[nodiscard]] static tl::expected<MotionTable, std::string> make(const Profile& profile, bool timed);

  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }

  /// The cells of a row, one for each column; valid until the next call. Rows come in the order of the run:
  /// arcs count from the first one, and are undefined on and after one that could not be assembled.
  /// \param drivers  of Mechanism::drivers
  [[nodiscard]] const std::vector<Cell>& cells(const MotionRow& row, const std::vector<DriverState>& drivers,
                                               double time);

private:
  struct Scale {
    Scaling length, angle, velocity, angular_velocity, acceleration, angular_acceleration;
  };

  void add_names(const Profile& profile);
  void add_body_names(const Body& body, const Units& units);
  void add_contact_names(const Contact& contact, const Units& units);
  void add_body(const MotionRow& row, std::size_t index);
  void add_joint(const MotionRow& row, const Joint& joint);
  void add_contact(const MotionRow& row, std::size_t index);
  void add_arcs(const ContactDetails& details, bool hold, std::size_t index);
  void number(double value);
  void length(std::optional<double> value);
  void optional_angle(std::optional<double> value);
  void vector(const Scaling& scale, const Vector2d& v, bool defined);

  const Mechanism* mechanism_ = nullptr;
  std::vector<std::optional<OneFreedom>> grounded_;  ///< how each body moves on its joint to ground
  std::vector<const Joint*> moved_;                  ///< joints that no driver moves
  bool timed_ = false;
  Scale scale_;
  std::vector<Column> columns_;
  std::vector<Cell> cells_;
  std::vector<std::optional<std::array<double, 2>>> arc_starts_;  ///< of the first row, for each contact
  bool broken_ = false;                                           ///< a row could not be assembled
};

/// The name of a status or of an event as results print it.
[[nodiscard]] std::string_view name_of(RowStatus status);
[[nodiscard]] std::string_view name_of(EventType type);

/// One line of CSV (with its line end) appended to `out`: the header, or a row of cells.
void append_csv_header(const std::vector<Column>& columns, std::string& out);
void append_csv_row(const std::vector<Cell>& cells, std::string& out);

}  // namespace higherpair
