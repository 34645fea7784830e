#include "path_columns.hpp"

#include "front/tolerances.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/io/coordinate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {

std::optional<std::int64_t> PathPlace::on_row() const {
  const double nearest = std::round(row);
  return std::abs(row - nearest) < kOnRow ? std::optional(static_cast<std::int64_t>(nearest)) : std::nullopt;
}

DriverPlaces::DriverPlaces(const Profile& profile, DriverSchedule schedule)
    : schedule_(std::move(schedule)), time_from_si_(from_si(dimension::kTime, profile.units)) {
  for (std::size_t i = 0; i < profile.programs.size(); ++i) {
    const Dimension of = driver_dimension(profile.mechanism, i);
    Scales scales;
    scales.position = of;
    scales.law = profile.programs[i].law;
    int order = 0;
    for (Scaling& scale : scales.from_si) scale = from_si(rate_of(of, order++), profile.units);
    for (Scaling& scale : scales.higher_to_si) scale = to_si(rate_of(of, order++), profile.units);
    drivers_.push_back(std::move(scales));
  }
}

std::vector<DriverState> DriverPlaces::at(const PathPlace& place) const {
  std::vector<DriverState> states;
  for (std::size_t i = 0; i < drivers_.size(); ++i) {
    states.push_back(state_at(place, i));
  }
  return states;
}

std::vector<DriverState> DriverPlaces::at_time(double time) const {
  constexpr double kBetweenRows = 0.5;
  return at({kBetweenRows, time});
}

DriverState DriverPlaces::state_at(const PathPlace& place, std::size_t driver) const {
  if (const auto row = place.on_row()) {
    return schedule_.state(std::min(*row, schedule_.size() - 1), driver);
  }
  const Scales& scales = drivers_[driver];
  DriverState state;
  if (schedule_.is_timed()) {
    state.si = schedule_.at_time(place.at, driver);
    for (std::size_t k = 0; scales.law && k < state.higher_si.size(); ++k) {
      state.higher_si[k] =
          scales.higher_to_si[k].apply(scales.law->derivative(static_cast<int>(k) + 3, time(place)));
    }
  } else {
    const auto row = std::min(static_cast<std::int64_t>(place.row), schedule_.size() - 1);
    const double share = place.row - static_cast<double>(row);
    const DriverMotion from = schedule_.state(row, driver).si;
    const DriverMotion to = schedule_.state(std::min(row + 1, schedule_.size() - 1), driver).si;
    state.si = {std::lerp(from.position, to.position, share), std::lerp(from.velocity, to.velocity, share),
                std::lerp(from.acceleration, to.acceleration, share)};
  }
  state.profile = {scales.from_si[0].apply(state.si.position), scales.from_si[1].apply(state.si.velocity),
                   scales.from_si[2].apply(state.si.acceleration)};
  return state;
}

double DriverPlaces::time(const PathPlace& place) const {
  if (!schedule_.is_timed()) {
    return 0;
  }
  const auto row = place.on_row();
  return row ? schedule_.time(std::min(*row, schedule_.size() - 1)) : time_from_si_.apply(place.at);
}

std::vector<DriverMotion> motions_of(const std::vector<DriverState>& drivers) {
  std::vector<DriverMotion> motions;
  for (const DriverState& driver : drivers) {
    motions.push_back(driver.si);
  }
  return motions;
}

double largest_rate(const DriverSchedule& schedule, const Run& start) {
  double rate = 0;
  for (std::size_t i = 0; i < schedule.driver_count(); ++i) {
    const bool turns = driver_turns(start.mechanism(), i);
    rate = std::max(rate, schedule.greatest_speed(i) / (turns ? 1 : start.plan().size));
  }
  return rate;
}

PathColumns::PathColumns(const Analysis& analysis, RunSettings settings)
    : data_(analysis.impl().model),
      settings_(std::move(settings)),
      start_(analysis.impl().run),
      drivers_(data_->profile, analysis.impl().schedule),
      rate_(largest_rate(drivers_.schedule(), start_)),
      path_(path_of(analysis.impl().schedule)),
      columns_(analysis.impl().columns) {
  if (settings_.forces) dynamics_.emplace(start_);
}

double PathColumns::parameter_of(std::int64_t row) const {
  const DriverSchedule& schedule = drivers_.schedule();
  if (schedule.is_timed()) {
    return schedule.time_si(row);
  }
  if (!schedule.is_listed()) {
    return static_cast<double>(row);
  }
  double low = path_.path.knots.front(), high = path_.path.knots.back();
  while (high - low > kPlaceOnPath * std::abs(high)) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (path_.row(middle) < static_cast<double>(row) ? low : high) = middle;
  }
  return high;
}

void PathColumns::values(const Run& run, const PathPlace& place, std::vector<double>& values) {
  const std::vector<DriverState> states = drivers_.at(place);
  const Reactions* reactions = dynamics_ ? &dynamics_->solve(run) : nullptr;
  columns_.fill({run, states, drivers_.time(place), reactions, false}, values);
}

std::vector<double> values_of(ColumnSet& columns, bool forces, const Run& run,
                              const std::vector<DriverState>& drivers, double time) {
  std::optional<InverseDynamics> dynamics;
  if (forces) dynamics.emplace(run);
  std::vector<double> values;
  columns.fill({run, drivers, time, dynamics ? &dynamics->solve(run) : nullptr, false}, values);
  return values;
}

std::vector<double> columns_of_run(Model::Data& like, const RunSettings& settings, const Run& run,
                                   const std::vector<DriverState>& drivers, double time) {
  like.profile.mechanism = run.mechanism();
  ColumnSet columns = columns_of(like, settings, like.profile.units).value();
  return values_of(columns, settings.forces, run, drivers, time);
}

const Run& PathWalk::go_to(const PathPlace& place) {
  const std::vector<double>& knots = columns_->path().path.knots;
  const auto row_at = [&](std::int64_t row) { return PathPlace{static_cast<double>(row), 0}; };
  for (;;) {
    const bool knot = next_knot_ < knots.size() && columns_->path().row(knots[next_knot_]) < place.row;
    const bool row = static_cast<double>(next_row_) < place.row;
    if (!knot && !row) break;
    const double knot_row = knot ? columns_->path().row(knots[next_knot_]) : place.row;
    if (row && static_cast<double>(next_row_) <= knot_row) {
      move(row_at(next_row_++));
    } else {
      move({knot_row, knots[next_knot_++]});
    }
  }
  if (place.on_row() == next_row_) ++next_row_;
  move(place);
  return run_;
}

void PathWalk::move(const PathPlace& place) {
  move_to(run_, motions_of(columns_->drivers().at(place)));
}

}  // namespace higherpair
