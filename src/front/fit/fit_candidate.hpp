#pragma once

#include "fit_data.hpp"
#include "front/analysis_impl.hpp"
#include "front/columns/path_columns.hpp"
#include "higherpair/dynamics/reactions.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace higherpair {

/// A mechanism with given numbers at its first position, and the positions of its drivers in each measured
/// row.
struct FitCandidate {
  std::shared_ptr<const Model::Data> data;
  Run run;
  ColumnSet columns;
  std::optional<InverseDynamics> dynamics;
  std::vector<std::vector<DriverState>> rows;
  std::vector<double> times;       ///< in the profile's unit
  std::vector<std::size_t> slots;  ///< of FitData::columns among the candidate's columns
};

/// None where it cannot be started. \param numbers  of the candidate \param branch  on which it is assembled
/// \param offsets  readings of FitData::where less the true values
[[nodiscard]] std::optional<FitCandidate> fit_candidate(const FitData& data,
                                                        std::shared_ptr<const Model::Data> numbers,
                                                        int branch, std::span<const double> offsets);

/// Moves it through all rows and calls f(row, motions of the drivers, values of all columns).
template <class F>
void for_each_row(FitCandidate& candidate, F f) {
  std::vector<double> values;
  for (std::size_t k = 0; k < candidate.rows.size(); ++k) {
    const std::vector<DriverMotion> motions = motions_of(candidate.rows[k]);
    move_to(candidate.run, motions);
    const Reactions* reactions = candidate.dynamics ? &candidate.dynamics->solve(candidate.run) : nullptr;
    candidate.columns.fill({candidate.run, candidate.rows[k], candidate.times[k], reactions, false}, values);
    f(k, motions, values);
  }
}

}  // namespace higherpair
