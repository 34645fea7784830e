#pragma once

#include "fit_data.hpp"
#include "front/design/design_columns.hpp"
#include "higherpair/analysis/sensitivity.hpp"

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// The measured columns that are motions of bodies, of their points or of revolute joints; their derivatives
/// follow from those of the bodies in closed form.
class FitColumns {
public:
  FitColumns(const Mechanism& mechanism, const FitData& data);

  /// All other measured columns, in their order.
  [[nodiscard]] const std::vector<std::size_t>& others() const { return others_; }

  /// Which rates the derivatives of all columns need in a row.
  [[nodiscard]] RatesAsked rates() const;

  /// Derivatives of the columns of bodies, points and joints in a row, in their units.
  /// \param derivative  of the mechanism's numbers \param out  one for each of FitData::columns; those of
  /// others() are left unchanged
  void derivatives(const Run& run, const Mechanism& derivative, const RowSensitivity& of_row,
                   Eigen::Ref<Eigen::RowVectorXd, 0, Eigen::InnerStride<>> out) const;

private:
  struct Motion {
    std::size_t column = 0;
    BodyColumn of;
  };

  std::vector<Motion> motions_;
  std::vector<std::size_t> others_;
};

}  // namespace higherpair
