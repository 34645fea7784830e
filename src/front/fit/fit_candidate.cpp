#include "fit_candidate.hpp"

#include "higherpair/analysis/branch_run.hpp"

#include <algorithm>
#include <utility>

namespace higherpair {
namespace {

// The drivers in every row of the table, with offsets subtracted.
std::optional<std::vector<std::vector<DriverState>>> driver_rows(const FitData& data, const Profile& profile,
                                                                 std::span<const double> offsets) {
  const std::size_t count = data.rows();
  std::vector<std::vector<DriverState>> rows(count, std::vector<DriverState>(profile.programs.size()));
  Profile other = profile;
  if (data.in_time()) {
    double last = 0;
    for (const double time : data.where[0].values) last = std::max(last, time - offsets[0]);
    for (DriverProgram& program : other.programs) program.duration = last;
    auto schedule = DriverSchedule::step(other, 2);
    if (!schedule) return std::nullopt;
    const DriverPlaces places(other, *std::move(schedule));
    const Scaling to_seconds = to_si(dimension::kTime, profile.units);
    for (std::size_t k = 0; k < count; ++k) {
      rows[k] = places.at_time(to_seconds.apply(data.where[0].values[k] - offsets[0]));
    }
    return rows;
  }
  for (std::size_t i = 0; i < other.programs.size(); ++i) {
    other.programs[i].positions.clear();
    for (const double position : data.where[i].values)
      other.programs[i].positions.push_back(position - offsets[i]);
  }
  const auto schedule = DriverSchedule::analyze(other);
  if (!schedule) return std::nullopt;
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < rows[k].size(); ++i) {
      rows[k][i] = schedule->state(static_cast<std::int64_t>(k), i);
    }
  }
  return rows;
}

std::vector<double> first_positions(const Model::Data& data) {
  // Those of the profile's own first row, also for a run in time.
  const auto schedule = first_schedule(data);
  return schedule ? schedule->first_positions() : std::vector<double>();
}

}  // namespace

std::optional<FitCandidate> fit_candidate(const FitData& data, std::shared_ptr<const Model::Data> numbers,
                                          int branch, std::span<const double> offsets) {
  if (!numbers || !numbers->plan) return std::nullopt;
  auto rows = driver_rows(data, numbers->profile, offsets);
  const std::vector<double> first = first_positions(*numbers);
  if (!rows || first.empty()) return std::nullopt;
  auto run = start_on_branch(run_model(*numbers), first, branch);
  if (!run) return std::nullopt;
  auto columns = columns_of(*numbers, data.settings, numbers->profile.units);
  if (!columns) return std::nullopt;
  FitCandidate candidate{
      std::move(numbers), *std::move(run), *std::move(columns), std::nullopt, *std::move(rows), {}, {}};
  if (data.settings.forces) candidate.dynamics.emplace(candidate.run);
  for (std::size_t k = 0; k < data.rows(); ++k) {
    candidate.times.push_back(data.in_time() ? data.where[0].values[k] - offsets[0] : 0);
  }
  for (const FitColumn& column : data.columns) {
    candidate.slots.push_back(column_slot(candidate.columns.columns(), column.name));
  }
  return candidate;
}

}  // namespace higherpair
