#include "limit_ahead.hpp"

#include "group_kinds.hpp"
#include "group_solver.hpp"
#include "higherpair/contact/step_length.hpp"
#include "limit_events.hpp"
#include "reduction.hpp"
#include "step.hpp"
#include "tolerances.hpp"

#include <cmath>
#include <limits>

namespace higherpair {
namespace {

constexpr double kShareToLimit = 0.5;   // of what is left to a limit: the next step
constexpr double kNearLimit = 1e-6;     // of the driver's scale: nearer, rates may be too inexact to go on
constexpr double kFarAway = 100;        // of the size: a body that is farther may be on its way to infinity
constexpr double kBesideLimit = 1e-12;  // of the driver's scale: as near before a limit a row needs no step

// A row at a limit: in run.work.trial, with positions only; run.at.state remains short of it.
void stop_at_limit(Run& run, const Path& path, std::size_t g, Reduction& reduction,
                   const Reduction::Point& limit, double s) {
  reduction.place(limit);
  run.work.trial.groups[g].sine = 0;
  run.work.trial.groups[g].sine_rate = 0;
  for (std::size_t later = g + 1; later < run.plan().groups.size(); ++later) {
    run.work.trial.groups[later].mode = run.at.state.groups[later].mode;
    (void)place_group(model_of(run), later, run.at.state, limit.ahead, path.to, run.work.trial);
  }
  run.at.beside = run.work.trial;
  path.positions(s, run.at.drivers);
}

// How much of the path is left to where a group's bodies are at infinity; infinite if they are not far away
// yet. What is left to the power of -p, p a multiple of 1/2, is how far they are; p + 1 that of their speed,
// which knows nothing of where the distance is measured from.
double left_to_infinity(const Run& run, std::size_t g) {
  double farthest = kFarAway * run.plan().size;
  double left = std::numeric_limits<double>::infinity();
  for (const int index : run.plan().groups[g].bodies) {
    const BodyMotion& body = body_in(run.at.state, index);
    const double distance = body.X_WB.p_WB.norm();
    if (distance > farthest) {
      farthest = distance;
      const double speed = body.v_WB.norm();
      const double per_speed = body.v_WB.dot(body.a_WB) / (speed * speed);
      const double p = std::round(2 / (distance * std::abs(per_speed) / speed - 1)) / 2;
      left = (p + 1) / per_speed;
    }
  }
  return left;
}

}  // namespace

double LimitAhead::longest_step(double s) const {
  return limit_ ? kShareToLimit * std::abs(limit_->s - s) : std::numeric_limits<double>::infinity();
}

bool LimitAhead::is_within(double share, double s) const {
  return limit_ && std::abs(limit_->s - s) <= share * scale_;
}

bool LimitAhead::is_near(double s) const {
  return is_within(kNearLimit, s);
}

bool LimitAhead::is_on_path() const {
  return (path_.length - limit_->s) * path_.length >= 0;
}

bool LimitAhead::look_for(std::size_t g, double s, double h) {
  if (limit_ && limit_->group == g) {
    return false;
  }
  Reduction reduction(run_, path_, g, s);
  const auto found = reduction.limit_ahead(h);
  if (!found) {
    return false;
  }
  const double at = s + found->ahead;
  if (std::abs(path_.length - at) <= kOnLimit * (scale_ + std::abs(driver_at(path_, at)))) {
    report_limit(run_, path_, limit_event(run_, g, path_, path_.length));
    stop_at_limit(run_, path_, g, reduction, *found, s);
    return true;
  }
  if (!limit_ || std::abs(at - s) < std::abs(limit_->s - s)) {
    limit_ = PathLimit{g, at};
  }
  return false;
}

bool LimitAhead::rests_before(double s) {
  if (std::abs(limit_->s - path_.length) > kBesideLimit * scale_ ||
      !solve_at(run_, path_, s, path_.length - s)) {
    return false;
  }
  run_.at.beside = run_.work.trial;
  path_.positions(s, run_.at.drivers);
  return true;
}

PathLimit LimitAhead::assumed(std::size_t g, double s) const {
  const double left = left_to_infinity(run_, g);
  const bool runs_off = std::abs(left) <= kNearLimit * scale_ && left * path_.length > 0;
  const double shortest = shortest_step(scale_, driver_at(path_, s));
  return {g, s + (runs_off ? left : std::copysign(shortest, path_.length))};
}

}  // namespace higherpair
