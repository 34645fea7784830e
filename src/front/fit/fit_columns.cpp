#include "fit_columns.hpp"

#include "higherpair/mechanism/joint_motion.hpp"
#include "numeric/eigen_index.hpp"

#include <algorithm>

namespace higherpair {

FitColumns::FitColumns(const Mechanism& mechanism, const FitData& data) {
  for (std::size_t c = 0; c < data.columns.size(); ++c) {
    if (const auto of = body_column(mechanism, data.model.units(), data.columns[c].name)) {
      motions_.push_back({c, *of});
    } else {
      others_.push_back(c);
    }
  }
}

RatesAsked FitColumns::rates() const {
  const bool positions =
      others_.empty() && std::all_of(motions_.begin(), motions_.end(),
                                     [](const Motion& motion) { return order_of(motion.of) == 0; });
  return positions ? RatesAsked::kNone : RatesAsked::kAll;
}

void FitColumns::derivatives(const Run& run, const Mechanism& derivative, const RowSensitivity& of_row,
                             Eigen::Ref<Eigen::RowVectorXd, 0, Eigen::InnerStride<>> out) const {
  for (const Motion& motion : motions_) {
    out(eigen_index(motion.column)) = column_slope(motion.of, run, derivative, of_row);
  }
}

}  // namespace higherpair
