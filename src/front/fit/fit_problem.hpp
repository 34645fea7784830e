#pragma once

#include "fit_measurement.hpp"
#include "fit_motion.hpp"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// Residuals, measured less fitted, of all measured values present, row by row.
class FitProblem {
public:
  FitProblem(const FitData& data, const FitMotion& motion);

  [[nodiscard]] const FitData& data() const { return data_; }
  [[nodiscard]] const FitMotion& motion() const { return motion_; }
  [[nodiscard]] const std::vector<FitUnknown>& unknowns() const { return measurement_.unknowns(); }
  [[nodiscard]] Eigen::Index size() const { return eigen_index(unknowns().size()); }
  /// Row and column of each residual.
  struct Value {
    std::size_t row = 0;
    std::size_t column = 0;
  };
  [[nodiscard]] const std::vector<Value>& values() const { return values_; }

  /// The profile's numbers; for these, the unknowns of the measurement by least squares where the problem is
  /// linear or nearly so.
  [[nodiscard]] Eigen::VectorXd start() const;
  /// The same for other numbers of the profile; none where the mechanism cannot be run with them.
  [[nodiscard]] std::optional<Eigen::VectorXd> start_from(std::span<const double> variables) const;
  [[nodiscard]] Eigen::VectorXd low() const { return low_; }
  [[nodiscard]] Eigen::VectorXd high() const { return high_; }

  /// In the units of the columns. Where the candidate has no value the residual is the spread of the column.
  /// None where the candidate cannot be started. \param missing  set to the number of these values
  [[nodiscard]] std::optional<Eigen::VectorXd> residuals(const Eigen::VectorXd& x,
                                                         int* missing = nullptr) const;
  /// Derivatives of the residuals by x; those of a column by a number that changes it by nothing but rounding
  /// are 0.
  [[nodiscard]] std::optional<Eigen::MatrixXd> jacobian(const Eigen::VectorXd& x) const;

  /// Largest deviation of the measured values of a column from their mean; > 0.
  [[nodiscard]] double spread(std::size_t column) const { return spreads_[column]; }
  /// 1/spread of the column of each residual.
  [[nodiscard]] const Eigen::VectorXd& spread_scales() const { return spread_scales_; }
  /// The sum of the squares of residuals, each divided by the spread of its column.
  [[nodiscard]] double squares(const Eigen::VectorXd& residuals) const {
    return residuals.cwiseProduct(spread_scales_).squaredNorm();
  }
  /// Largest absolute value of a column.
  [[nodiscard]] double largest(std::size_t column) const { return largest_[column]; }

  /// Measured angles of a column with whole turns added or subtracted so that they are near the motion for
  /// `x`: instruments count within one turn, tables continuously. Unchanged where this does not bring all
  /// values within a quarter turn of the motion.
  [[nodiscard]] std::vector<double> unwrapped(std::size_t column, const Eigen::VectorXd& x) const;

private:
  /// These numbers of the profile, and unknowns of the measurement that change nothing.
  [[nodiscard]] Eigen::VectorXd unmeasured(std::span<const double> variables) const;
  [[nodiscard]] Eigen::VectorXd residuals_of(const FitTable& fitted, int* missing) const;
  void clear_rounding(Eigen::MatrixXd& J) const;

  const FitData& data_;
  const FitMotion& motion_;
  FitMeasurement measurement_;
  std::vector<Value> values_;
  Eigen::VectorXd low_, high_;
  std::vector<double> spreads_, largest_;
  Eigen::VectorXd spread_scales_;
};

}  // namespace higherpair
