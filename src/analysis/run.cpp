#include "higherpair/analysis/run.hpp"

#include "analysis/boundaries/overlap.hpp"
#include "analysis/boundaries/span_ends.hpp"
#include "analysis/follow/events.hpp"
#include "analysis/follow/limit_events.hpp"
#include "analysis/follow/path.hpp"
#include "analysis/follow/residual.hpp"
#include "analysis/follow/resume.hpp"
#include "analysis/follow/step.hpp"
#include "analysis/groups/group_solver.hpp"
#include "analysis/start/assembly.hpp"
#include "analysis/start/singular_start.hpp"
#include "analysis/start/start_failures.hpp"
#include "higherpair/analysis/branch_run.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/mobility_text.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace higherpair {
namespace {

// With one driver, the rates of the row are those for a unit velocity, scaled.
void scale_rates(const State& state, const DriverMotion& driver, MotionRow& row) {
  const double v = driver.velocity;
  const double a = driver.acceleration;
  for (std::size_t i = 1; i < row.bodies.size(); ++i) {  // ground is fixed
    const BodyMotion& unit = state.bodies[i];
    BodyMotion& body = row.bodies[i];
    body = unit;
    body.a_WB = v * v * unit.a_WB + a * unit.v_WB;
    body.alpha = v * v * unit.alpha + a * unit.omega;
    body.v_WB = v * unit.v_WB;
    body.omega = v * unit.omega;
  }
  for (std::size_t i = 0; i < row.contacts.size(); ++i) {
    row.contacts[i] = state.contacts[i];
    ContactRates& rates = row.contacts[i].rates;
    rates.sliding *= v;
    rates.phi_dot *= v;
    rates.along1 *= v;
    rates.along2 *= v;
    rates.normal_acceleration *= v * v;
  }
}

bool depends_on_unknown_rates(const Run& run, const Group& group, const MotionRow& row) {
  bool unknown = false;
  for_each_joined_body(run.mechanism(), group, [&](int body) { unknown = unknown || !row.has_rates[body]; });
  return unknown;
}

// Marks the bodies whose rates a singular group leaves undefined: its own, and all that depend on them.
void mark_rates(const Run& run, MotionRow& row) {
  if (!row.all_rates) {
    std::fill(row.has_rates.begin(), row.has_rates.end(), true);
  }
  bool singular = false;
  for (std::size_t g = 0; g < run.plan().groups.size(); ++g) {
    const Group& group = run.plan().groups[g];
    const GroupState& state = run.at.shown().groups[g];
    const bool here = !(std::abs(state.sine) > state.noise);
    if (here || (singular && depends_on_unknown_rates(run, group, row))) {
      for (const int body : group.bodies) {
        row.has_rates[body] = false;
      }
    }
    singular = singular || here;
  }
  row.all_rates = !singular;
  row.status = singular ? RowStatus::kSingular : RowStatus::kOk;
}

// What rounding leaves of the residual where a body is far away, as near a pole; 0 where none is.
double rounding_of_far_positions(const Run& run) {
  double farthest = 0;
  for (const BodyMotion& body : run.row.bodies) {
    farthest = std::max(farthest, body.X_WB.p_WB.norm());
  }
  return farthest > kFarAway * run.plan().size ? kRoundingOfPosition * farthest : 0;
}

void fill_row(Run& run, const std::vector<DriverMotion>& drivers) {
  MotionRow& row = run.row;
  if (drivers.size() == 1) {
    scale_rates(run.at.shown(), drivers.front(), row);
  } else {
    run.work.trial = run.at.shown();
    set_rates(run, drivers, run.work.trial);
    row.bodies = run.work.trial.bodies;
    row.contacts = run.work.trial.contacts;
  }
  mark_rates(run, row);
  set_local_curves(run);
  for (std::size_t i = 0; i < run.at.watches.size(); ++i) {
    row.arcs_hold[i] = !run.at.watches[i].interrupted;
    row.status = run.at.watches[i].overlaps ? RowStatus::kOverlap : row.status;
  }
  row.residual = residual_of(run);
  const bool within = row.residual <= run.tolerance * run.plan().size ||
                      (std::isfinite(row.residual) && row.residual <= rounding_of_far_positions(run));
  if (!within) {
    row.status = RowStatus::kNotConverged;
  }
}

// Whether the bodies of a coupled group may be underdetermined although the number of conditions is right.
// Where the conditions have lost their rank they may be dependent everywhere and leave a freedom that no
// driver determines.
bool may_be_free(const Run& run) {
  for (std::size_t g = 0; g < run.plan().groups.size(); ++g) {
    if (traits_of(run.plan().groups[g]).coupled && !(std::abs(run.at.state.groups[g].sine) > kSurelyPlaced)) {
      return true;
    }
  }
  return false;
}

// A group whose limit the row is at: one with a contact so far out that its gap consists of rounding.
std::optional<std::size_t> group_at_infinity(const Run& run) {
  if (run.row.status != RowStatus::kNotConverged) {
    return std::nullopt;
  }
  for (std::size_t g = 0; g < run.plan().groups.size(); ++g) {
    for (const int index : run.plan().groups[g].contacts) {
      const ContactMotion& contact = run.row.contacts[index];
      const double rounding = std::numeric_limits<double>::epsilon() * contact.at.p_W().norm();
      if (contact.touches && rounding > kRoundingOfGap * run.plan().size) {
        return g;
      }
    }
  }
  return std::nullopt;
}

// Prepares an assembled run for moving. \returns a contact that is at a limit, from where the continuation is
// not determined
std::optional<int> set_out(Run& run) {
  const std::vector<double>& drivers = run.at.inputs;
  set_unit_motions(run, drivers, run.work.motions);
  set_rates(run, run.work.motions, run.at.state);
  run.at.outputs = output_joints(run.mechanism());
  run.at.watches = watched_contacts(run.mechanism());
  run.work.trial = run.at.state;
  run.at.targets = drivers;
  run.work.row_before = drivers;
  set_path(run, run.work.path, drivers, drivers);
  if (const auto contact = leave_singular_start(run)) {
    return contact;
  }
  renew_overlaps(run);
  run.row.bodies = run.at.state.bodies;
  run.row.contacts = run.at.state.contacts;
  run.row.arcs_hold.assign(run.mechanism().contacts.size(), true);
  run.row.has_rates.assign(run.at.state.bodies.size(), true);
  return std::nullopt;
}

// Whether the position at which a run starts meets its conditions and their rates.
bool starts_right(Run run) {
  std::vector<DriverMotion> start;
  set_unit_motions(run, run.at.inputs, start);
  move_to(run, start);
  return run.row.status != RowStatus::kNotConverged;
}

// Next to a change point there are positions that violate surplus conditions least but do not meet them, and
// poses that are a little off lead there. Beside it they lead to the mechanism, from where it moves to its
// start. None if it is not right then either.
std::optional<Run> started_from_beside(const Run& run) {
  std::vector<DriverMotion> start;
  set_unit_motions(run, run.at.inputs, start);
  const double reach = kCrossingReach * driver_scale(run, 0);
  for (const double side : {reach, -reach}) {
    Run beside = planned_run(run.model, {run.at.inputs[0] + side});
    beside.tolerance = run.tolerance;
    if (assemble(beside) || set_out(beside)) {
      continue;
    }
    move_to(beside, start);
    if (beside.row.status == RowStatus::kOk) {
      beside.events.clear();
      beside.at.outputs = output_joints(run.mechanism());
      return beside;
    }
  }
  return std::nullopt;
}

// Sets the shares of all events. Without a curve the coordinate of a single driver determines the share,
// whatever path the event was found on; what rounding puts beyond a row is at the row. A stretch beyond a
// limit that is found late begins before the row before: its share is negative. A limit at infinity may be
// behind the row.
void set_shares(Run& run) {
  const double from = run.work.row_before[0];
  const double to = run.at.targets[0];
  const double length = to - from;
  const bool by_driver = run.at.targets.size() == 1 && !run.at.curve && length != 0;
  const double near =
      kSameLimit * (by_driver ? (driver_scale(run, 0) + std::abs(from)) / std::abs(length) : 1);
  for (RunEvent& event : run.events) {
    if (by_driver) {
      event.share = (event.driver - from) / length;
    }
    const bool is_behind = run.at.lost.is_beyond_row && event.driver == run.at.lost.event.driver;
    if (event.share < -near || is_behind) {
      continue;
    }
    event.share = std::clamp(event.share, 0.0, 1.0);
    if (by_driver) {
      event.driver = std::clamp(event.driver, std::min(from, to), std::max(from, to));
    }
  }
}

// Moves a run from work.row_before to at.targets. \param drivers  there
void move_to_targets(Run& run, const std::vector<DriverMotion>& drivers) {
  run.events.clear();
  run.smooth_joints.clear();
  if (run.at.limit_here || run.at.limit_before) {
    run.at.limit_before = std::exchange(run.at.limit_here, std::nullopt);
  }
  // The row before is asked for again, and run.at.state is short of it.
  bool reached = run.at.on_branch && run.at.beside && run.at.targets == run.work.row_before;
  if (reached) {
    // The row is in run.at.beside.
  } else if (!run.at.on_branch) {
    reached = resume(run, run.at.targets, run.work.row_before);
  } else if (run.at.targets == run.at.inputs) {
    run.at.beside.reset();
    reached = true;
  } else {
    set_part(run, run.work.path, run.at.inputs, run.at.targets);
    // The branch may exist again at the end of a path on which it is lost.
    reached = follow(run, run.work.path) || resume(run, run.at.targets, run.at.lost.at);
  }
  set_shares(run);
  if (reached) {
    fill_row(run, drivers);
    if (const auto g = group_at_infinity(run)) {
      set_path(run, run.work.path, run.at.inputs, run.at.targets);
      report_limit(run, run.work.path, limit_event(run, *g, run.work.path, run.work.path.length));
      run.row.status = RowStatus::kNotAssemblable;
    }
  } else {
    run.row.status = RowStatus::kNotAssemblable;
    run.row.residual = 0;
  }
}

// A driver position, within two turns of the start, at which a rolling pair is in the same position as at u.
// About two pivots only circles about their centres and equal ellipses about their foci roll through a whole
// turn, and after any number of turns they are as they were; so is a circle on a line that slides, after
// turns of its own.
double within_two_turns(const ContactPair& pair, const ContactPosition& start, double u) {
  const double turn = pair.motion1.turns                    ? 2 * kPi
                      : pair.motion2.turns && start.dq != 0 ? 2 * kPi / std::abs(start.dq)
                                                            : kInf;
  const double moved = u - start.u;
  return std::abs(moved) > 2 * turn ? start.u + std::fmod(moved, turn) : u;
}

}  // namespace

RunModel make_run_model(Mechanism mechanism, Plan plan) {
  return {std::make_shared<const Mechanism>(std::move(mechanism)),
          std::make_shared<const Plan>(std::move(plan))};
}

tl::expected<Run, StartFailure> start_run(const Mechanism& mechanism, const std::vector<double>& drivers,
                                          double tolerance) {
  return planned_model(mechanism).and_then(
      [&](RunModel model) { return start_run(std::move(model), drivers, tolerance); });
}

tl::expected<Run, StartFailure> start_run(RunModel model, const std::vector<double>& drivers,
                                          double tolerance) {
  Run run = planned_run(std::move(model), drivers);
  const Mechanism& mechanism = run.mechanism();
  run.tolerance = tolerance;
  if (auto objection = surplus_objection(mechanism, run.plan(), drivers)) {
    return tl::unexpected(StartFailure{*objection, std::nullopt});
  }
  auto failure = assemble(run);
  if (failure ? run.plan().couples : may_be_free(run)) {
    if (auto objection = driver_objection(mechanism, drivers)) {
      return tl::unexpected(StartFailure{*objection, std::nullopt});
    }
  }
  if (failure) {
    return tl::unexpected(std::move(*failure));
  }
  if (const auto contact = set_out(run)) {
    const std::string& name = mechanism.contacts[*contact].name;
    return tl::unexpected(StartFailure{"contacts." + name + ": " + kTouchesAtLimit, std::nullopt});
  }
  if (run.plan().couples && drivers.size() == 1 && mechanism.contacts.empty() && !starts_right(run)) {
    return started_from_beside(run).value_or(std::move(run));
  }
  return run;
}

std::optional<Run> start_on_branch(RunModel model, const std::vector<double>& drivers, int branch) {
  Run run = planned_run(std::move(model), drivers);
  if (!assemble_on(run, branch) || set_out(run)) {
    return std::nullopt;
  }
  return run;
}

void move_to(Run& run, const std::vector<DriverMotion>& drivers) {
  if (run.at.curve) {
    leave_curve(run);
  }
  std::swap(run.work.row_before, run.at.targets);
  run.at.targets.resize(drivers.size());
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    run.at.targets[i] = drivers[i].position;
  }
  move_to_targets(run, drivers);
}

void move_along(Run& run, const std::shared_ptr<const DriverCurve>& curve, double from, double to,
                const std::vector<DriverMotion>& drivers) {
  if (run.at.curve != curve && !enter_curve(run, curve, from)) {
    move_to(run, drivers);
    return;
  }
  std::swap(run.work.row_before, run.at.targets);
  run.at.targets = {to};
  move_to_targets(run, drivers);
}

std::optional<Slip> find_slip(const Run& run, const std::vector<double>& positions) {
  for (std::size_t g = 0; g < run.plan().groups.size(); ++g) {
    const auto* tracked = std::get_if<TrackedPair>(&run.plan().groups[g].kind);
    const auto* start = std::get_if<RollingTrack>(&run.at.state.tracks[g]);
    if (tracked == nullptr || start == nullptr) {
      continue;
    }
    RollingTrack track = *start;
    for (const double position : positions) {
      if (is_stopped(run)) {
        return std::nullopt;
      }
      const double u = within_two_turns(tracked->pair, start->at, tracked->driver_sign * position);
      const RollingResult result = roll_to(track, u);
      // A large angle or slide is known only to within its rounding.
      const double known = kRollingUlps * std::numeric_limits<double>::epsilon() * std::abs(u);
      const double size = run.plan().size;
      const double largest = run.tolerance * size + known * (tracked->pair.motion1.turns ? size : 1);
      if (!result.converged || !(result.mismatch <= largest) || !(std::abs(track.at.sliding) <= largest)) {
        return Slip{tracked->driver_sign * track.at.u, track.at.sliding, tracked->contact};
      }
    }
  }
  return std::nullopt;
}

}  // namespace higherpair
