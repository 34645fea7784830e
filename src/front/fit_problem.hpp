#pragma once

#include "fit_measurement.hpp"
#include "fit_motion.hpp"

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// Residuals, measured less fitted, of all values that are there, row by row.
class FitProblem {
public:
  FitProblem(const FitData& data, const FitMotion& motion);

  [[nodiscard]] const FitData& data() const { return data_; }
  [[nodiscard]] const FitMotion& motion() const { return motion_; }
  [[nodiscard]] const std::vector<FitUnknown>& unknowns() const { return measurement_.unknowns(); }
  [[nodiscard]] Eigen::Index size() const { return place(unknowns().size()); }
  /// One for each residual: its row and column.
  struct Value {
    std::size_t row = 0;
    std::size_t column = 0;
  };
  [[nodiscard]] const std::vector<Value>& values() const { return values_; }

  /// The profile's numbers, and for these what is not known of the measurement by least squares, where it is
  /// linear or nearly so.
  [[nodiscard]] Eigen::VectorXd start() const;
  /// The same for other numbers of the profile; none where they cannot be run.
  [[nodiscard]] std::optional<Eigen::VectorXd> start_from(std::span<const double> variables) const;
  [[nodiscard]] Eigen::VectorXd low() const { return low_; }
  [[nodiscard]] Eigen::VectorXd high() const { return high_; }

  /// In units of columns. A value that the candidate has not is off by the spread of its column. None where
  /// the candidate cannot be started. \param missing  so many
  [[nodiscard]] std::optional<Eigen::VectorXd> residuals(const Eigen::VectorXd& x,
                                                         int* missing = nullptr) const;
  /// Their derivatives by x.
  [[nodiscard]] std::optional<Eigen::MatrixXd> jacobian(const Eigen::VectorXd& x) const;

  /// Largest size of the measured values of a column less their mean; > 0.
  [[nodiscard]] double spread(std::size_t column) const { return spreads_[column]; }
  /// The same of the values themselves.
  [[nodiscard]] double largest(std::size_t column) const { return largest_[column]; }

  /// What is measured of an angle with whole turns taken from it or added, so that it is near the motion of
  /// `x`: instruments count within a turn, tables go on. As it is where that does not bring all values within
  /// a quarter turn of it.
  [[nodiscard]] std::vector<double> unwrapped(std::size_t column, const Eigen::VectorXd& x) const;

private:
  [[nodiscard]] Eigen::VectorXd residuals_of(const FitTable& fitted, int* missing) const;

  const FitData& data_;
  const FitMotion& motion_;
  FitMeasurement measurement_;
  std::vector<Value> values_;
  Eigen::VectorXd low_, high_;
  std::vector<double> spreads_, largest_;
};

}  // namespace higherpair
