#pragma once

#include "fit_data.hpp"
#include "front/design/design_numbers.hpp"

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

struct FitCandidate;

/// Values of the measured columns for a mechanism with given numbers: one row for each measured row, one
/// column for each of FitData::columns, in their units; NaN where undefined.
using FitTable = Eigen::MatrixXd;

/// Runs candidates of a fit through the measured rows.
class FitMotion {
public:
  /// \param data  must outlive this \param branch  on which all candidates are assembled
  FitMotion(const FitData& data, int branch);

  /// None where the candidate cannot be started. \param variables  the numbers of the profile \param offsets
  /// readings of `where` less the true values
  [[nodiscard]] std::optional<FitTable> table(std::span<const double> variables,
                                              std::span<const double> offsets) const;

  /// Derivatives of the table by the variables, then by the free offsets; NaN where the table is. None where
  /// they cannot be computed.
  [[nodiscard]] std::optional<std::vector<FitTable>> derivatives(std::span<const double> variables,
                                                                 std::span<const double> offsets) const;

  /// Chooses how derivatives() works: by implicit differentiation if this agrees with finite differences at
  /// this candidate, else by fourth-order differences.
  void choose_derivatives(std::span<const double> variables, std::span<const double> offsets);
  [[nodiscard]] bool is_exact() const { return exact_; }

  [[nodiscard]] const DesignNumbers& numbers() const { return numbers_; }
  [[nodiscard]] int branch() const { return branch_; }
  /// Typical size of a change of a variable.
  [[nodiscard]] double scale(std::size_t variable) const { return numbers_.scale(variable); }

private:
  [[nodiscard]] std::optional<FitCandidate> start(std::span<const double> variables,
                                                  std::span<const double> offsets) const;
  [[nodiscard]] std::optional<std::vector<FitTable>> exact_derivatives(std::span<const double> variables,
                                                                       std::span<const double> offsets) const;
  [[nodiscard]] std::optional<std::vector<FitTable>> differences(std::span<const double> variables,
                                                                 std::span<const double> offsets) const;

  const FitData& data_;
  DesignTask ranges_;  // the variables, each with finite bounds
  DesignNumbers numbers_;
  int branch_;
  bool exact_ = true;
};

}  // namespace higherpair
