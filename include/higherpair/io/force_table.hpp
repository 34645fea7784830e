#pragma once

#include "higherpair/dynamics/contact_watch.hpp"
#include "higherpair/io/motion_table.hpp"

#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// A motion table with the columns of the reactions, which stand before `status` and `residual`.
class ForceTable {
public:
  /// Fails where two columns would have the same name; the message names it.
  /// \param motion  columns of the motion table of the same profile
  [[nodiscard]] static tl::expected<ForceTable, std::string> make(const Profile& profile,
                                                                  const std::vector<Column>& motion);

  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }

  /// The cells of a row, one for each column; valid until the next call. The status of a row that is `ok`
  /// but in which a contact pulls is `contact_open`.
  /// \param motion  cells of the motion table
  [[nodiscard]] const std::vector<Cell>& cells(const Reactions& reactions, const std::vector<Cell>& motion);

private:
  void add_names(const Profile& profile);
  void add(const Scaling& scale, std::optional<double> value);

  Scaling force_;
  Scaling torque_;
  std::vector<JointType> joints_;   ///< of Mechanism::joints
  std::vector<JointType> drivers_;  ///< of the driven joints
  std::vector<Column> columns_;
  std::vector<Cell> cells_;
};

/// Why and where a contact opens, and what would keep it closed, as a sentence with numbers in the profile's
/// units.
/// \param need  of the same contact; null if nothing presses it
[[nodiscard]] std::string describe(const ContactOpening& opening, const PreloadNeed* need,
                                   const Profile& profile);

}  // namespace higherpair
