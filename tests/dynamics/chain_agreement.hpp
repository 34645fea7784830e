#pragma once

#include "analysis/chain_testing.hpp"
#include "geometry/geometry_testing.hpp"
#include "higherpair/dynamics/contact_forces.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/mechanism/description.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <fmt/core.h>

// Measures how far the rows of a chain, forces included, are from those of a run, without judging it.

namespace higherpair::testing {

/// Largest differences, in units in the last place of the largest number of the same kind in the run: places
/// relative to its size, rates to its fastest body, forces to the largest one at a joint. Angles count as
/// arcs at the mechanism's size.
struct ChainErrors {
  double place = 0, rate = 0, second_rate = 0, force = 0;
};

struct ChainAgreement {
  Outcome outcome = Outcome::kNoChain;
  std::string broken;  ///< what the run found and the chain has missed; empty: nothing
  ChainErrors errors;
};

inline std::vector<ChainColumn> force_columns(const Mechanism& mechanism) {
  using Q = ChainColumn::Quantity;
  std::vector<ChainColumn> columns;
  for (int j = 0; j < static_cast<int>(mechanism.joints.size()); ++j) {
    columns.push_back({j, std::nullopt, Q::kForceX});
    columns.push_back({j, std::nullopt, Q::kForceY});
    if (has_moment(mechanism.joints[j].type)) {
      columns.push_back({j, std::nullopt, Q::kMoment});
    }
  }
  for (int c = 0; c < static_cast<int>(mechanism.contacts.size()); ++c) {
    columns.push_back({c, std::nullopt, Q::kContactForce});
  }
  columns.push_back({0, std::nullopt, Q::kEffort});
  columns.push_back({0, std::nullopt, Q::kEffortByPower});
  return columns;
}

/// NaN where the force is not defined.
inline double force_of(const ChainColumn& column, const Reactions& reactions) {
  using Q = ChainColumn::Quantity;
  if (column.quantity == Q::kContactForce) {
    return reactions.contacts[column.item].force.value_or(NAN);
  }
  const JointReaction& joint = reactions.joints[column.item];
  const DriverEffort& driver = reactions.drivers.front();
  switch (column.quantity) {
    case Q::kForceX:
      return joint.fx.value_or(NAN);
    case Q::kForceY:
      return joint.fy.value_or(NAN);
    case Q::kMoment:
      return joint.moment.value_or(NAN);
    case Q::kEffort:
      return driver.effort.value_or(NAN);
    default:
      return driver.by_power.value_or(NAN);
  }
}

/// Collects the differences and the largest number of one kind of columns.
class KindError {
public:
  void see(double value, double expected, double unit) {
    largest_ = std::max(largest_, std::abs(expected) / unit);
    error_.see((value - expected) / unit);
    error_.see((expected - value) / unit);
  }
  [[nodiscard]] double ulps(double least) const {
    const double scale = std::max(largest_, least);
    return error_.value() == 0 ? 0 : error_.value() / (scale * std::numeric_limits<double>::epsilon());
  }

private:
  Worst error_;
  double largest_ = 0;
};

/// The unit that makes the columns of one kind comparable: lengths with angles, and moments with forces.
inline double unit_of(const ChainColumn& column, const Mechanism& mechanism, double size) {
  using Q = ChainColumn::Quantity;
  const auto driven = static_cast<std::size_t>(mechanism.drivers.front().joint);
  const bool turns = mechanism.joints[driven].type == JointType::kRevolute;
  switch (column.quantity) {
    case Q::kX:
    case Q::kY:
    case Q::kVx:
    case Q::kVy:
    case Q::kAx:
    case Q::kAy:
    case Q::kMoment:
      return size;
    case Q::kEffort:
    case Q::kEffortByPower:
      return turns ? size : 1;
    default:
      return 1;
  }
}

/// Index of the member of ChainErrors that a column belongs to.
inline std::size_t kind_of(const ChainColumn& column) {
  using Q = ChainColumn::Quantity;
  return column.quantity >= Q::kForceX ? 3
         : column.quantity >= Q::kAx   ? 2
         : column.quantity >= Q::kVx   ? 1
                                       : 0;
}

/// What a run that follows the motion finds in contradiction to a proven chain; empty if nothing.
inline std::string objection(const Run& run) {
  if (run.row.status != RowStatus::kOk) {
    return "a row that is not ok";
  }
  for (const RunEvent& event : run.events) {
    if (event.type != EventType::kStrokeEnd) {
      return "an event: " + event.cause;
    }
  }
  return "";
}

/// Whether a contact opens, in a row or between two rows.
inline bool a_contact_opens(const Run& start, const std::vector<DriverMotion>& rows) {
  const DriverPath path = straight_path({rows.front()}, {rows.back()}, static_cast<double>(rows.size() - 1));
  return !start.mechanism().contacts.empty() && !follow_contact_forces(start, path).openings.empty();
}

/// \param rows  along a straight path, if there are contacts and forces are wanted
inline ChainAgreement agreement(const Mechanism& mechanism, const std::vector<DriverMotion>& rows,
                                bool forces) {
  ChainAgreement result;
  const auto plan = make_plan(mechanism);
  std::vector<ChainColumn> columns = all_columns(mechanism);
  if (forces) {
    const auto more = force_columns(mechanism);
    columns.insert(columns.end(), more.begin(), more.end());
  }
  auto chain = plan ? DyadChain::of(mechanism, *plan, rows, columns) : std::nullopt;
  if (!chain) {
    return result;
  }
  result.outcome = chain->solve(mechanism) ? Outcome::kProven : Outcome::kNotProven;
  if (result.outcome == Outcome::kNotProven) {
    return result;
  }
  auto run = start_run(make_run_model(mechanism, *plan), {rows.front().position});
  if (!run) {
    result.broken = "no start: " + run.error().reason;
    return result;
  }
  std::optional<InverseDynamics> dynamics;
  if (forces) {
    dynamics.emplace(*run);
    result.broken = a_contact_opens(*run, rows) ? "a contact that opens" : "";
  }
  std::array<KindError, 4> errors;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    move_to(*run, {rows[k]});
    if (std::string wrong = objection(*run); !wrong.empty()) {
      result.broken = fmt::format("row {}: {}", k, wrong);
      return result;
    }
    const Reactions* reactions = forces ? &dynamics->solve(*run) : nullptr;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const std::size_t kind = kind_of(columns[i]);
      const double expected =
          kind == 3 ? force_of(columns[i], *reactions) : number_of(columns[i], mechanism, run->row);
      errors[kind].see(chain->values(i)[k], expected, unit_of(columns[i], mechanism, plan->size));
    }
  }
  // The driver moves at a rate of about 1, and has rounding of that size even where the bodies it moves are
  // nearly at rest.
  result.errors = {errors[0].ulps(1), errors[1].ulps(1), errors[2].ulps(1), errors[3].ulps(0)};
  return result;
}

inline double first_contact_force(const Mechanism& mechanism, const DriverMotion& driver) {
  auto run = start_run(make_run_model(mechanism, *make_plan(mechanism)), {driver.position});
  if (!run) {
    return NAN;
  }
  move_to(*run, {driver});
  return InverseDynamics(*run).solve(*run).contacts.front().force.value_or(NAN);
}

/// Adds a load to the cam's follower, scaled so that the contact force in the first row is the given one (not
/// scaled where that would take an extreme factor).
inline void press_follower(Mechanism& mechanism, const DriverMotion& driver, double force, Random& random) {
  const double before = first_contact_force(mechanism, driver);
  Load load{"press", 2, random.vector(0.5), random.vector(1), 1, LoadFrame::kGround};
  mechanism.loads.push_back(load);
  const double factor = (force - before) / (first_contact_force(mechanism, driver) - before);
  if (std::abs(factor) <= 1e4) {
    mechanism.loads.back().force *= factor;
    mechanism.loads.back().torque *= factor;
  }
}

/// Random masses, loads, springs and dampers of the kinds for which a chain computes forces.
inline void add_random_loads(Mechanism& mechanism, Random& random) {
  mechanism.gravity_W = random.vector(10);
  const auto chance = [&] { return random.between(0, 1) < 0.5; };
  const auto body_count = static_cast<int>(mechanism.bodies.size());
  const auto any_point = [&](int body) {
    const auto& points = mechanism.bodies[body].points;
    return PointRef{body, random.index(static_cast<int>(points.size()))};
  };
  for (int b = 1; b < body_count; ++b) {
    if (random.between(0, 1) < 0.8) {
      mechanism.bodies[b].mass =
          MassProperties{random.between(0.1, 3), random.vector(0.5), random.between(0.01, 0.5)};
    }
    if (chance()) {
      mechanism.loads.push_back({fmt::format("l{}", b), b, random.vector(0.5), random.vector(20),
                                 chance() ? random.between(-5, 5) : 0.0,
                                 chance() ? LoadFrame::kGround : LoadFrame::kBody});
    }
    if (chance()) {
      const int other = (b + 1 + random.index(body_count - 1)) % body_count;
      mechanism.springs.push_back({fmt::format("s{}", b), std::nullopt, any_point(b), any_point(other),
                                   random.between(5, 50), random.between(0, 1), chance() ? 2.5 : 0.0});
    }
  }
  for (int j = 0; j < static_cast<int>(mechanism.joints.size()); ++j) {
    if (chance()) {
      mechanism.springs.push_back({fmt::format("j{}", j),
                                   j,
                                   {},
                                   {},
                                   random.between(5, 50),
                                   random.between(-0.5, 0.5),
                                   chance() ? 1.5 : 0.0});
    }
  }
}

}  // namespace higherpair::testing
