#include "design_slope_run.hpp"

#include "front/columns/path_columns.hpp"
#include "higherpair/analysis/displaced.hpp"
#include "higherpair/io/row_path.hpp"

#include <utility>

namespace higherpair {

std::optional<SlopeRun> SlopeRun::start(const DesignSetup& setup, const DesignCandidate& candidate,
                                        int branch, const std::vector<MechanismDerivative>& derivatives) {
  auto run = start_on_branch(make_run_model(*candidate.mechanism, candidate.plan),
                             candidate.schedule.first_positions(), branch);
  if (!run) return std::nullopt;
  SlopeRun started(setup, candidate.schedule, *std::move(run));
  const std::vector<double> fixed(candidate.schedule.driver_count(), 0.0);
  for (const MechanismDerivative& derivative : derivatives) {
    auto by = Sensitivity::at_start(started.run_, derivative, fixed);
    if (!by) return std::nullopt;
    started.by_.push_back(*std::move(by));
  }
  return started;
}

void SlopeRun::go_to(std::size_t row) {
  for (; next_ <= row; ++next_) {
    const auto k = static_cast<std::int64_t>(next_);
    motions_ = drivers_in(*schedule_, k);
    move_to_row(run_, *schedule_, k, motions_);
  }
}

SlopeRun SlopeRun::beside(double driver) const {
  SlopeRun other = *this;
  other.motions_ = {{driver, 1, 0}};
  move_to(other.run_, other.motions_);
  return other;
}

std::vector<RowSensitivity> SlopeRun::sensitivities(RatesAsked rates) const {
  std::vector<RowSensitivity> all;
  const std::vector<DriverMotion> fixed(motions_.size());
  for (const Sensitivity& by : by_) {
    auto of_row = by.of_row(run_, motions_, fixed, rates);
    if (!of_row) return {};
    all.push_back(*std::move(of_row));
  }
  return all;
}

double SlopeRun::slope_of(std::size_t variable, const RowSensitivity& of_row,
                          const std::function<double(const Run& displaced)>& number) const {
  return derivative_along(run_, by_[variable], of_row,
                          [&](const Run& displaced, double /*h*/) { return std::vector{number(displaced)}; })
      .front();
}

std::vector<double> SlopeRun::table_slopes(Model::Data& like, std::size_t variable,
                                           const RowSensitivity& of_row) const {
  std::vector<DriverState> drivers;
  for (std::size_t i = 0; i < schedule_->driver_count(); ++i) {
    drivers.push_back(schedule_->state(static_cast<std::int64_t>(next_ - 1), i));
  }
  const double time = schedule_->time(static_cast<std::int64_t>(next_ - 1));
  return derivative_along(run_, by_[variable], of_row, [&](const Run& run, double /*h*/) {
    return columns_of_run(like, setup_->settings, run, drivers, time);
  });
}

}  // namespace higherpair
