#pragma once

#include "higherpair/analysis/jerk.hpp"
#include "higherpair/io/motion_table.hpp"

namespace higherpair {

/// The columns of jerk, beside those of the motion table, in the profile's units:
///   B.jx B.jy B.jerk        each moving body B: third time derivatives of its frame's origin and angle
///   B.P.jx B.P.jy           each point P of a moving body
///   K.jerk K.jerk_linkage   each contact K: third time derivative of the coordinate of the joint on which it
///                           moves a body, and what it would be if every contact were replaced by its
///                           equivalent link, frozen at this instant. Empty where the contact does not move a
///                           body on one joint by itself.
/// The drivers' accelerations are constant. Cells are empty where the jerk is not defined.
class JerkTable {
public:
  /// The profile must outlive the table.
  /// \param plan  of its mechanism
  JerkTable(const Profile& profile, const Plan& plan);

  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }

  /// The cells of run.row, one for each column, behind those of the motion table; valid until the next call.
  [[nodiscard]] const std::vector<Cell>& behind(const std::vector<Cell>& cells, const Run& run);

private:
  void add_names(const Profile& profile);
  void add_body(const Run& run, const JerkRow& jerks, std::size_t index);
  void vector(const std::optional<Vector2d>& v);
  void number(const Scaling& scale, const std::optional<double>& value);

  std::vector<std::optional<int>> joints_;  ///< of each contact: on which it moves a body
  Scaling linear_;
  Scaling angular_;
  std::vector<Column> columns_;
  std::vector<Cell> cells_;
};

}  // namespace higherpair
