// The motion of the drivers of a schedule in time between its rows.
#include "higherpair/cam/law_series.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "io/tolerances.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

namespace higherpair {
namespace {

// The times strictly between `from` and `to` at which a law turns back, out of those at which its velocity is
// 0.
std::vector<double> where_it_turns(const MotionLaw& law, double from, double to) {
  std::vector<double> turns;
  double last = law(from);
  const std::vector<double> rests = law.zeros(1, from, to);
  for (std::size_t i = 0; i < rests.size(); ++i) {
    const double here = law(rests[i]);
    double next = here;
    for (std::size_t k = i + 1; k <= rests.size() && next == here; ++k) {
      next = law(k < rests.size() ? rests[k] : to);
    }
    if (rests[i] > from && rests[i] < to && (here - last) * (next - here) < 0) {
      turns.push_back(rests[i]);
      last = here;
    }
  }
  return turns;
}

}  // namespace

// Times in the profile's unit, strictly between `from` and `to`.
std::vector<double> DriverSchedule::reversals(const OneDriver& driver, double from, double to) {
  if (driver.law) {
    return where_it_turns(*driver.law, from, to);
  }
  const double t = driver.acceleration == 0 ? from : -driver.velocity / driver.acceleration;
  return t > from && t < to ? std::vector{t} : std::vector<double>{};
}

LawSide DriverSchedule::side_of(std::int64_t row) const {
  return timed_ && row == size_ - 1 && size_ > 1 ? LawSide::kBefore : LawSide::kAfter;
}

DriverMotion DriverSchedule::at_time(double time_si, std::size_t driver) const {
  assert(timed_);
  const OneDriver& one = drivers_[driver];
  if (one.law) {
    const auto s = series_at<2>(*one.law, time_from_si_.apply(time_si));
    return {one.position_to_si.apply(s.c[0]), one.velocity_to_si.apply(s.c[1]),
            one.acceleration_to_si.apply(2 * s.c[2])};
  }
  DriverMotion si{one.position_to_si.apply(one.start), one.velocity_to_si.apply(one.velocity),
                  one.acceleration_to_si.apply(one.acceleration)};
  si.position += time_si * (si.velocity + time_si / 2 * si.acceleration);
  si.velocity += time_si * si.acceleration;
  return si;
}

double DriverSchedule::passing_time(std::int64_t row, double position, double share) const {
  if (row == 0) {
    return time(0);
  }
  const double before = time(row - 1);
  const double after = time(row);
  if (drivers_.size() != 1) {
    return std::lerp(before, after, std::min(share, 1.0));  // one that is found late is before the row before
  }
  const double t = std::lerp(before, after, std::clamp(share, 0.0, 1.0));
  const OneDriver& driver = drivers_.front();
  if (driver.law) {
    // Between two reversals it passes a position once.
    double from = before, to = after;
    for (const double turn : reversals(driver, before, after)) {
      (turn <= t ? from : to) = turn <= t ? turn : std::min(to, turn);
    }
    const auto times = driver.law->places(position, from, to);
    const auto nearest = std::min_element(
        times.begin(), times.end(), [&](double a, double b) { return std::abs(a - t) < std::abs(b - t); });
    return nearest == times.end() ? t : *nearest;
  }
  const double travel = position - driver.start;
  if (driver.acceleration == 0) {
    return driver.velocity == 0 ? t : std::clamp(travel / driver.velocity, before, after);
  }
  // A parabola passes a position twice: take the time within the interval, or else the nearer one.
  const double discriminant = driver.velocity * driver.velocity + 2 * driver.acceleration * travel;
  const double sum = driver.velocity + std::copysign(std::sqrt(std::max(discriminant, 0.0)), driver.velocity);
  const double one = sum == 0 ? 0 : 2 * travel / sum;
  const double other = -sum / driver.acceleration;
  const auto missed = [&](double root) { return std::abs(std::clamp(root, before, after) - root); };
  const auto from_share = [&](double root) { return std::abs(root - t); };
  const bool first =
      missed(one) == missed(other) ? from_share(one) <= from_share(other) : missed(one) < missed(other);
  return std::clamp(first ? one : other, before, after);
}

// The way from one time to another, in the profile's unit.
double DriverSchedule::way(const OneDriver& driver, double from, double to) const {
  std::vector<double> times = reversals(driver, from, to);
  times.push_back(to);
  const auto position = [&](double t) {
    return driver.law ? (*driver.law)(t) : driver.start + t * (driver.velocity + t * driver.acceleration / 2);
  };
  double way = 0;
  double last = position(from);
  for (const double t : times) {
    way += std::abs(position(t) - last);
    last = position(t);
  }
  return way;
}

double DriverSchedule::travel(std::size_t driver) const {
  const OneDriver& one = drivers_[driver];
  const auto si = [&](double way) {
    return std::abs(one.position_to_si.apply(way) - one.position_to_si.apply(0));
  };
  if (timed_) {
    const double length = one.law && one.law->repeats() ? one.law->end() - one.law->begin() : kInf;
    const double rounds = std::floor(duration_ / length);
    const double rest = rounds > 0 ? duration_ - rounds * length : duration_;
    return si((rounds > 0 ? rounds * way(one, 0, length) : 0) + way(one, 0, rest));
  }
  if (one.positions.empty()) {
    return si(size_ == 1 ? 0 : one.end - one.start);
  }
  double sum = 0;
  for (std::size_t k = 1; k < one.positions.size(); ++k) {
    sum += std::abs(one.positions[k] - one.positions[k - 1]);
  }
  return si(sum);
}

double DriverSchedule::greatest_speed(std::size_t driver) const {
  const OneDriver& one = drivers_[driver];
  const auto speed = [&](std::int64_t row) { return std::abs(state(row, driver).si.velocity); };
  double greatest = std::max(speed(0), speed(size_ - 1));
  if (one.law && timed_) {
    const MotionLaw& law = *one.law;
    const double to = std::min(duration_, std::max(law.end(), 0.0) + law.end() - law.begin());
    const LawExtremes velocity = law.extremes(1, 0, to);
    greatest = std::max({greatest, std::abs(one.velocity_to_si.apply(velocity.least)),
                         std::abs(one.velocity_to_si.apply(velocity.greatest))});
  } else if (one.law) {
    for (std::int64_t row = 0; row < size_; ++row) greatest = std::max(greatest, speed(row));
  }
  return greatest;
}

std::vector<DriverSchedule::TurningPoint> DriverSchedule::turning_points(std::int64_t row) const {
  std::vector<TurningPoint> points;
  if (!timed_ || row == 0 || drivers_.size() != 1) {
    return points;
  }
  const OneDriver& driver = drivers_.front();
  const double before = time(row - 1);
  const double after = time(row);
  for (const double t : reversals(driver, before, after)) {
    const auto s = driver.law ? series_at<2>(*driver.law, t) : PowerSeries<double, 2>();
    const double position = driver.law ? s.c[0] : driver.start + t * driver.velocity / 2;
    const double acceleration = driver.law ? 2 * s.c[2] : driver.acceleration;
    points.push_back(
        {{driver.position_to_si.apply(position), 0, driver.acceleration_to_si.apply(acceleration)},
         (t - before) / (after - before)});
  }
  return points;
}

bool DriverSchedule::is_one_way(std::int64_t from, std::int64_t to) const {
  if (drivers_.size() != 1) {
    return false;
  }
  const OneDriver& driver = drivers_.front();
  if (timed_) {
    return reversals(driver, time(from), time(to)).empty();
  }
  if (driver.positions.empty()) {
    return true;
  }
  const auto first = driver.positions.begin() + from;
  const auto end = driver.positions.begin() + to + 1;
  return std::is_sorted(first, end) || std::is_sorted(first, end, std::greater<>());
}

std::vector<DriverSchedule::LawJump> DriverSchedule::law_jumps(std::int64_t row) const {
  std::vector<LawJump> jumps;
  if (!timed_ || row == 0) {
    return jumps;
  }
  const double near = kSameTime * duration_;
  const double from = time(row - 1) + near;
  const double to = row == size_ - 1 ? duration_ - near : time(row) + near;
  for (std::size_t i = 0; i < drivers_.size(); ++i) {
    const std::optional<MotionLaw>& law = drivers_[i].law;
    if (!law) {
      continue;
    }
    const double length = law->end() - law->begin();
    const double first = law->repeats() ? std::floor((from - law->begin()) / length) : 0;
    const double last = law->repeats() ? std::floor((to - law->begin()) / length) : 0;
    for (double turn = first; turn <= last; ++turn) {
      for (const LawJoin& join : law->joins()) {
        const double t = join.x + turn * length;
        const bool jumps_here = join.jumps(1) || join.jumps(2);
        const bool again = law->repeats() && join.x == law->end();  // the beginning of the next repetition
        if (jumps_here && !again && t > from && t <= to) {
          jumps.push_back({i, t, (*law)(t), join});
        }
      }
    }
  }
  std::stable_sort(jumps.begin(), jumps.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return jumps;
}

std::vector<double> DriverSchedule::breaks() const {
  std::vector<double> times;
  for (const OneDriver& driver : drivers_) {
    const auto turns = reversals(driver, 0, duration_);
    times.insert(times.end(), turns.begin(), turns.end());
    if (driver.law) {
      const auto breaks = driver.law->breaks(0, duration_);
      times.insert(times.end(), breaks.begin(), breaks.end());
    }
  }
  std::sort(times.begin(), times.end());
  std::vector<double> apart;
  const double near = kSameTime * duration_;
  for (const double t : times) {
    if (t > near && t < duration_ - near && (apart.empty() || t > apart.back() + near)) {
      apart.push_back(t);
    }
  }
  for (double& t : apart) {
    t = time_to_si_.apply(t);
  }
  return apart;
}

std::vector<double> DriverSchedule::knots() const {
  std::vector<double> times = breaks();
  times.insert(times.begin(), 0);
  if (const double end = time_si(size_ - 1); end > 0) {
    times.push_back(end);
  }
  return times;
}

std::shared_ptr<const DriverCurve> DriverSchedule::make_curve() const {
  DriverCurve curve;
  for (std::size_t i = 0; i < driver_count(); ++i) {
    curve.greatest_speeds.push_back(greatest_speed(i));
  }
  const auto& speeds = curve.greatest_speeds;
  if (size_ == 1 || std::all_of(speeds.begin(), speeds.end(), [](double speed) { return speed == 0; })) {
    return nullptr;
  }
  curve.breaks = knots();
  curve.motion = [schedule = *this](std::size_t driver, double time) {
    return schedule.at_time(time, driver);
  };
  return std::make_shared<const DriverCurve>(std::move(curve));
}

}  // namespace higherpair
