#pragma once

#include "higherpair/analysis/derivatives.hpp"
#include "higherpair/io/motion_table.hpp"

namespace higherpair {

/// Columns of higher derivatives, beside those of the motion table, in the profile's units; for k = 3 … order
///   B.dkx B.dky B.dkangle   each moving body B: kth time derivatives of its frame's origin and angle
///   B.P.dkx B.P.dky         each point P of a moving body
/// The drivers' accelerations are constant. Cells are empty where the derivatives are not defined.
class DerivativeTable {
public:
  /// The profile must outlive the table.
  /// \param order  3 … kHighestDerivative
  DerivativeTable(const Profile& profile, int order);

  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }

  /// The cells of run.row, one for each column, behind `cells`; valid until the next call.
  [[nodiscard]] const std::vector<Cell>& behind(const std::vector<Cell>& cells, const Run& run,
                                                const std::vector<DriverMotion>& drivers);

private:
  void number(const Scaling& scale, double value);

  const Mechanism* mechanism_;
  int order_;
  std::vector<Scaling> linear_;  ///< of each order from 3
  std::vector<Scaling> angular_;
  std::vector<Column> columns_;
  std::vector<Cell> cells_;
};

}  // namespace higherpair
