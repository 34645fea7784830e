#include "row_scout.hpp"

#include "higherpair/analysis/go_on_alike.hpp"
#include "higherpair/io/row_path.hpp"

#include <numeric>

namespace higherpair {

bool go_on_alike(const RunPlace& a, const RunPlace& b) {
  return go_on_alike(a.run, b.run) && a.history.is_like(b.history, a.run.plan().size);
}

const RunPlace& RowScout::go_to(const DriverSchedule& schedule, std::int64_t row) {
  if (row_ < 0) {
    step(schedule, 0);
    place_.history.note(place_.run);
  }
  leap(schedule, row);
  return place_;
}

// Moves to a row, halving the interval until nothing between its ends depends on the rows there.
void RowScout::leap(const DriverSchedule& schedule, std::int64_t to) {
  if (row_ >= to || is_stopped(place_.run)) {
    return;
  }
  if (row_ + 1 == to) {
    step(schedule, to);
    place_.history.note(place_.run);
  } else if (!schedule.is_one_way(row_, to) || !leap_at_once(schedule, to)) {
    leap(schedule, std::midpoint(row_, to));
    leap(schedule, to);
  }
}

// Moves in a single step. If rows in between may change the history, undoes it and returns false.
bool RowScout::leap_at_once(const DriverSchedule& schedule, std::int64_t to) {
  Run before = place_.run;
  const std::int64_t row = row_;
  step(schedule, to);
  if (!place_.history.may_change_by(place_.run)) {
    return true;
  }
  place_.run = std::move(before);
  row_ = row;
  return false;
}

// The drivers turn back at most between row `to` and the row before it.
void RowScout::step(const DriverSchedule& schedule, std::int64_t to) {
  motions_ = drivers_in(schedule, to);
  move_to_row(place_.run, schedule, to, motions_);
  row_ = to;
}

}  // namespace higherpair
