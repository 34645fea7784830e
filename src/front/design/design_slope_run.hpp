#pragma once

#include "design_runs.hpp"
#include "higherpair/analysis/sensitivity.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace higherpair {

/// A run of one candidate together with its derivatives by each variable.
class SlopeRun {
public:
  /// None where the run cannot be started on the branch, or cannot be differentiated there. \param setup,
  /// candidate  must outlive this \param derivatives  of the mechanism by each variable
  [[nodiscard]] static std::optional<SlopeRun> start(const DesignSetup& setup,
                                                     const DesignCandidate& candidate, int branch,
                                                     const std::vector<MechanismDerivative>& derivatives);

  /// Moves to a row, which must not be before the last one.
  void go_to(std::size_t row);
  /// A copy moved from the current row to a position of the only driver.
  [[nodiscard]] SlopeRun beside(double driver) const;

  /// One for each variable; empty where the row cannot be differentiated by one of them.
  [[nodiscard]] std::vector<RowSensitivity> sensitivities(RatesAsked rates) const;
  /// The derivative of a number that is a function of a run in its row.
  [[nodiscard]] double slope_of(std::size_t variable, const RowSensitivity& of_row,
                                const std::function<double(const Run& displaced)>& number) const;
  /// Derivatives of the columns of the table. \param like  its mechanism is overwritten
  [[nodiscard]] std::vector<double> table_slopes(Model::Data& like, std::size_t variable,
                                                 const RowSensitivity& of_row) const;

  [[nodiscard]] const Run& run() const { return run_; }
  [[nodiscard]] const Sensitivity& by(std::size_t variable) const { return by_[variable]; }

private:
  SlopeRun(const DesignSetup& setup, const DriverSchedule& schedule, Run run)
      : setup_(&setup), schedule_(&schedule), run_(std::move(run)) {}

  const DesignSetup* setup_;
  const DriverSchedule* schedule_;
  Run run_;
  std::vector<Sensitivity> by_;
  std::vector<DriverMotion> motions_;
  std::size_t next_ = 0;  // number of the next row
};

}  // namespace higherpair
