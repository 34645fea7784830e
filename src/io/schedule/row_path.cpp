#include "higherpair/io/row_path.hpp"

#include "io/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace higherpair {
namespace {

// Whether all drivers go on from row k as they came to it.
bool is_straight_at(const std::vector<std::vector<DriverMotion>>& rows, std::size_t k) {
  for (std::size_t i = 0; i < rows[k].size(); ++i) {
    const double before = rows[k][i].position - rows[k - 1][i].position;
    const double after = rows[k + 1][i].position - rows[k][i].position;
    if (std::abs(after - before) > kSameStep * std::abs(before)) {
      return false;
    }
  }
  return true;
}

// The path parameter for positions given one by one: the distance that the driver has travelled, or with
// several drivers the number of rows. Knots are where a driver turns back, or several do not go on straight.
RowPath path_through(const DriverSchedule& schedule) {
  const auto last = static_cast<std::size_t>(schedule.size() - 1);
  std::vector<std::vector<DriverMotion>> rows;
  std::vector<double> travelled{0};
  RowPath result;
  result.path.knots = {0};
  for (std::size_t k = 0; k <= last; ++k) {
    rows.push_back(drivers_in(schedule, static_cast<std::int64_t>(k)));
  }
  double sense = 0;
  for (std::size_t k = 1; k <= last; ++k) {
    const double step = rows[k][0].position - rows[k - 1][0].position;
    const bool single = schedule.driver_count() == 1;
    const bool is_knot = single ? step * sense < 0 : k > 1 && !is_straight_at(rows, k - 1);
    if (is_knot && travelled.back() > result.path.knots.back()) {
      result.path.knots.push_back(travelled.back());
    }
    sense = step != 0 ? step : sense;
    travelled.push_back(travelled.back() + (single ? std::abs(step) : 1));
  }
  if (travelled.back() > result.path.knots.back()) {
    result.path.knots.push_back(travelled.back());
  }
  result.row = [travelled, last](double at) {
    const auto after = std::lower_bound(travelled.begin() + 1, travelled.end(), at);
    if (after == travelled.end()) {
      return static_cast<double>(last);
    }
    const double share = *after > after[-1] ? (at - after[-1]) / (*after - after[-1]) : 1;
    return static_cast<double>(after - travelled.begin() - 1) + share;
  };
  result.path.motion = [rows, row = result.row](double at, std::vector<DriverMotion>& drivers) {
    const double place = row(at);
    const auto k = static_cast<std::size_t>(place);
    const std::size_t next = std::min(k + 1, rows.size() - 1);
    straight_path(rows[k], rows[next]).motion(place - static_cast<double>(k), drivers);
  };
  return result;
}

// With a schedule in time the path parameter is the time [s].
RowPath path_in_time(const DriverSchedule& schedule) {
  RowPath result;
  result.path.curve = schedule.curve();
  result.path.knots = schedule.knots();
  result.path.motion = [schedule](double t, std::vector<DriverMotion>& drivers) {
    drivers.resize(schedule.driver_count());
    for (std::size_t i = 0; i < drivers.size(); ++i) {
      drivers[i] = schedule.at_time(t, i);
    }
  };
  result.row = [schedule](double t) {
    std::int64_t low = 0, high = schedule.size() - 1;
    while (high - low > 1) {
      const std::int64_t middle = low + (high - low) / 2;
      (schedule.time_si(middle) < t ? low : high) = middle;
    }
    const double step = schedule.time_si(high) - schedule.time_si(low);
    return static_cast<double>(low) + (step > 0 ? (t - schedule.time_si(low)) / step : 0);
  };
  return result;
}

}  // namespace

std::vector<DriverMotion> drivers_in(const DriverSchedule& schedule, std::int64_t row) {
  std::vector<DriverMotion> drivers;
  for (std::size_t i = 0; i < schedule.driver_count(); ++i) {
    drivers.push_back(schedule.state(row, i).si);
  }
  return drivers;
}

std::vector<double> positions_in(const DriverSchedule& schedule, std::int64_t row) {
  std::vector<double> positions;
  for (std::size_t i = 0; i < schedule.driver_count(); ++i) {
    positions.push_back(schedule.state(row, i).si.position);
  }
  return positions;
}

void move_to_row(Run& run, const DriverSchedule& schedule, std::int64_t row,
                 const std::vector<DriverMotion>& at_row) {
  move_to_row(run, schedule, row, at_row, [](double /*from*/, double /*to*/) {});
}

RowPath path_of(const DriverSchedule& schedule) {
  if (schedule.is_timed()) {
    return path_in_time(schedule);
  }
  if (schedule.is_listed()) {
    return path_through(schedule);
  }
  const std::int64_t last = schedule.size() - 1;
  RowPath result{
      straight_path(drivers_in(schedule, 0), drivers_in(schedule, last), static_cast<double>(last)),
      [](double at) { return at; }};
  if (last == 0) {
    result.path.knots = {0};
  }
  return result;
}

}  // namespace higherpair
