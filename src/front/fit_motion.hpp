#pragma once

#include "design_numbers.hpp"
#include "fit_data.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

struct FitCandidate;

/// Values of the measured columns that a mechanism with given numbers has in the measured rows: one row for
/// each of the table, one column for each of FitData::columns, in their units; NaN where undefined.
using FitTable = Eigen::MatrixXd;

/// Runs candidates of a fit through the measured rows.
class FitMotion {
public:
  /// \param data  outlives this \param branch  on which all candidates are assembled
  FitMotion(const FitData& data, int branch);

  /// None where the candidate cannot be started. \param variables  the numbers of the profile \param offsets
  /// what `where` shows more than is there
  [[nodiscard]] std::optional<FitTable> table(std::span<const double> variables,
                                              std::span<const double> offsets) const;

  /// Derivatives of the table by the variables, then by the offsets that are free; NaN where the table is.
  /// None where they cannot be made.
  [[nodiscard]] std::optional<std::vector<FitTable>> derivatives(std::span<const double> variables,
                                                                 std::span<const double> offsets) const;

  /// Derivatives by implicit differentiation where these agree with differences at this candidate, else by
  /// differences of the fourth order from now on.
  void choose_derivatives(std::span<const double> variables, std::span<const double> offsets);
  [[nodiscard]] bool is_exact() const { return exact_; }

  [[nodiscard]] const DesignNumbers& numbers() const { return numbers_; }
  [[nodiscard]] int branch() const { return branch_; }
  /// By how much a variable is moved to count as moved.
  [[nodiscard]] double scale(std::size_t variable) const { return numbers_.scale(variable); }

private:
  [[nodiscard]] std::optional<FitCandidate> start(std::span<const double> variables,
                                                  std::span<const double> offsets) const;
  [[nodiscard]] std::optional<std::vector<FitTable>> exact_derivatives(std::span<const double> variables,
                                                                       std::span<const double> offsets) const;
  [[nodiscard]] std::optional<std::vector<FitTable>> differences(std::span<const double> variables,
                                                                 std::span<const double> offsets) const;

  const FitData& data_;
  DesignTask ranges_;  // with bounds everywhere
  DesignNumbers numbers_;
  int branch_;
  bool exact_ = true;
};

}  // namespace higherpair
