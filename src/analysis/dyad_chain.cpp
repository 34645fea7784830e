#include "higherpair/analysis/dyad_chain.hpp"

#include "chain_bounds.hpp"
#include "chain_rows.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/redimension.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace higherpair {
namespace {

using Quantity = ChainColumn::Quantity;

// Coordinates this many times as long as a link leave its direction 1e-13 of rounding: no residual comes near
// 1e-9 of the size then.
constexpr double kFarthestPoint = 1e3;

// Assemblies whose distances from the poses differ by less than this share are as near as each other.
constexpr double kAsNear = 1e-9;

constexpr std::size_t kMostDyads = 6;  // 2^6 assemblies are tried

bool is_chain(const Mechanism& mechanism, const Plan& plan) {
  if (mechanism.drivers.size() != 1 || !mechanism.contacts.empty() || plan.surplus != 0) {
    return false;
  }
  std::size_t dyads = 0;
  for (const Group& group : plan.groups) {
    const auto* driven = std::get_if<DrivenBody>(&group.kind);
    const bool grounded = driven != nullptr && driven->carried.carrier == 0;
    if ((!traits_of(group).two_modes && !grounded) || !group.ended_joints.empty()) {
      return false;
    }
    dyads += traits_of(group).two_modes ? 1 : 0;
  }
  return dyads <= kMostDyads && mechanism.bodies.size() <= kMostChainBodies &&
         plan.groups.size() <= kMostChainGroups;
}

ChainRates rates_for(const std::vector<ChainColumn>& columns) {
  ChainRates rates = ChainRates::kNone;
  for (const ChainColumn& column : columns) {
    rates = std::max(rates, column.quantity >= Quantity::kAx   ? ChainRates::kAccelerations
                            : column.quantity >= Quantity::kVx ? ChainRates::kVelocities
                                                               : ChainRates::kNone);
  }
  return rates;
}

ChainSchedule schedule_of(std::span<const DriverMotion> rows) {
  ChainSchedule schedule;
  const std::size_t filled = (rows.size() + kChainRows - 1) / kChainRows * kChainRows;
  for (std::size_t k = 0; k < filled; ++k) {
    const DriverMotion& row = rows[std::min(k, rows.size() - 1)];
    schedule.position.push_back(row.position);
    schedule.cosine.push_back(std::cos(row.position));
    schedule.sine.push_back(std::sin(row.position));
    schedule.velocity.push_back(row.velocity);
    schedule.acceleration.push_back(row.acceleration);
  }
  return schedule;
}

double longest_step(std::span<const DriverMotion> rows) {
  double step = 0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    step = std::max(step, std::abs(rows[k].position - rows[k - 1].position));
  }
  return step;
}

// Where the angles of all bodies come from; those of riders from their carriers.
std::vector<ChainAngle> angles_of(const Plan& plan, std::size_t bodies) {
  std::vector<ChainAngle> angles(bodies);
  const auto at = [&](int body) -> ChainAngle& { return angles[static_cast<std::size_t>(body)]; };
  const auto turns = [&](int body) { at(body) = {ChainAngle::Source::kRotation, body, 0, 0}; };
  const auto rides = [&](const std::optional<Rider>& rider) {
    if (rider) {
      at(rider->body) = at(rider->carrier);
      at(rider->body).offset += rider->relative_angle;
    }
  };
  for (const Group& group : plan.groups) {
    if (const auto* driven = std::get_if<DrivenBody>(&group.kind)) {
      const CarriedBody& carried = driven->carried;
      at(carried.body) = carried.freedom.turns
                             ? ChainAngle{ChainAngle::Source::kDriver, carried.body, carried.sign, 0}
                             : ChainAngle{ChainAngle::Source::kFixed, carried.body, 0, carried.freedom.theta};
    } else if (const auto* rrr = std::get_if<RrrDyad>(&group.kind)) {
      turns(rrr->link_a);
      turns(rrr->link_b);
    } else if (const auto* rrp = std::get_if<RrpDyad>(&group.kind)) {
      turns(rrp->link);
      rides(rrp->slider);
    } else if (const auto* rpr = std::get_if<RprDyad>(&group.kind)) {
      turns(rpr->link);
      rides(rpr->slider);
    }
  }
  return angles;
}

// Angles of a body that turns from row to row by less than half a turn, from those in (-π, π]; the first is
// the one nearest to its pose's.
void unwind(const ChainAngle& angle, double posed, std::span<double> values) {
  double before = values.front();
  double turns = nearest_turn(before, posed) - before;
  for (double& value : values) {
    const double rise = value - before;
    before = value;
    if (std::abs(rise) > kPi) {
      turns -= std::copysign(2 * kPi, rise);
    }
    value = (value + turns) + angle.offset;
  }
}

double largest_coordinate(const Mechanism& mechanism) {
  double largest = 0;
  for (const Body& body : mechanism.bodies) {
    for (const NamedPoint& point : body.points) {
      largest = std::max({largest, std::abs(point.p_B.x()), std::abs(point.p_B.y())});
    }
  }
  return largest;
}

double shortest_link(const Plan& plan) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Group& group : plan.groups) {
    if (const auto* rrr = std::get_if<RrrDyad>(&group.kind)) {
      shortest = std::min({shortest, rrr->length_a, rrr->length_b});
    } else if (const auto* rrp = std::get_if<RrpDyad>(&group.kind)) {
      shortest = std::min(shortest, rrp->length);
    } else if (std::holds_alternative<RprDyad>(group.kind)) {
      shortest = std::min(shortest, plan.size);
    }
  }
  return shortest;
}

}  // namespace

struct DyadChain::Impl {
  Plan plan;  // of the mechanism solved last
  ChainSchedule schedule;
  double step = 0;  // the longest between two rows
  std::size_t rows = 0;
  ChainRates rates = ChainRates::kNone;
  std::vector<ChainTask> tasks;
  bool needs_size = false;                // for dyads whose sine is a length
  std::vector<ChainBody<double>> posed;   // the poses
  std::vector<double> posed_angles;       // in them
  std::vector<ChainBody<double>> bodies;  // in the first row
  std::vector<double> modes;              // of the assembly that is tried
  std::vector<double> best_modes;         // of the nearest one so far
  double best_cost = 0;
  double next_cost = 0;  // of the nearest of the others
  std::vector<ChainWatch<double>> watches;
  std::vector<MotionBound> bounds;

  void take_poses(const Mechanism& mechanism);
  [[nodiscard]] bool redimension(const Mechanism& mechanism);
  [[nodiscard]] double cost_of(const Mechanism& mechanism, const Group& group) const;
  void try_modes(const Mechanism& mechanism, std::size_t g, double cost);
  [[nodiscard]] bool assemble(const Mechanism& mechanism);
};

void DyadChain::Impl::take_poses(const Mechanism& mechanism) {
  for (std::size_t i = 1; i < posed.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    posed[i].p_WB = body.guess_p_WB;
    if (posed_angles[i] != body.guess_theta) {
      posed_angles[i] = body.guess_theta;
      posed[i].R_WB = Rotation<double>::from_angle(body.guess_theta);
    }
  }
}

bool DyadChain::Impl::redimension(const Mechanism& mechanism) {
  if (needs_size) {
    plan.size = size_of(mechanism);
  }
  redimension_groups(plan, mechanism);
  const bool same_kinds = std::none_of(plan.groups.begin(), plan.groups.end(), [](const Group& group) {
    return std::holds_alternative<CoupledBodies>(group.kind);
  });
  return same_kinds && largest_coordinate(mechanism) <= kFarthestPoint * shortest_link(plan);
}

// Squared distances of the joint points of a group's bodies from their places in the poses.
double DyadChain::Impl::cost_of(const Mechanism& mechanism, const Group& group) const {
  double cost = 0;
  for (const int index : group.joints) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
    for (const PointRef& ref : {joint.first, joint.second}) {
      const auto body = static_cast<std::size_t>(ref.body);
      const Vector2d& p_B = point_of(mechanism, ref);
      const Vector2d here = chain_point<ChainRates::kNone>(bodies[body], p_B).p_W;
      const Vector2d there = chain_point<ChainRates::kNone>(posed[body], p_B).p_W;
      cost += (here - there).squaredNorm();
    }
  }
  return cost;
}

// Tries both modes of every dyad from the g-th on, as start_run() does.
void DyadChain::Impl::try_modes(const Mechanism& mechanism, std::size_t g, double cost) {
  if (!(cost < next_cost)) {
    return;
  }
  if (g == plan.groups.size()) {
    next_cost = std::min(next_cost, std::max(cost, best_cost));
    if (cost < best_cost) {
      best_cost = cost;
      best_modes = modes;
    }
    return;
  }
  const ChainDriver<double> driver{schedule.position[0], {schedule.cosine[0], schedule.sine[0]}};
  const Group& group = plan.groups[g];
  for (const double mode : {1.0, -1.0}) {
    ChainWatch<double> watch;
    modes[g] = mode;
    solve_group<ChainRates::kNone>(group, mode, driver, bodies.data(), watch);
    const bool dyad = traits_of(group).two_modes;
    const double limit = std::holds_alternative<RprDyad>(group.kind) ? 0 : 1;
    if (!dyad || watch.margin < limit) {
      try_modes(mechanism, g + 1, cost + cost_of(mechanism, group));
    }
    if (!dyad) {
      return;
    }
  }
}

// Finds best_modes. Where assemblies are as near as each other, rounding decides: that of a Run.
bool DyadChain::Impl::assemble(const Mechanism& mechanism) {
  best_cost = next_cost = std::numeric_limits<double>::infinity();
  try_modes(mechanism, 0, 0);
  if (best_cost < next_cost * (1 - kAsNear)) {
    return true;
  }
  plan.size = size_of(mechanism);
  const auto run = start_run(make_run_model(mechanism, plan), {schedule.position[0]});
  for (std::size_t g = 0; run && g < best_modes.size(); ++g) {
    best_modes[g] = run->at.state.groups[g].mode;
  }
  return run.has_value();
}

DyadChain::DyadChain(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
DyadChain::DyadChain(DyadChain&& other) noexcept = default;
DyadChain& DyadChain::operator=(DyadChain&& other) noexcept = default;
DyadChain::~DyadChain() = default;

std::optional<DyadChain> DyadChain::of(const Mechanism& mechanism, const Plan& plan,
                                       std::span<const DriverMotion> rows, std::vector<ChainColumn> columns) {
  if (!is_chain(mechanism, plan) || rows.empty()) {
    return std::nullopt;
  }
  auto impl = std::make_unique<Impl>();
  const std::size_t bodies = mechanism.bodies.size();
  impl->plan = plan;
  impl->schedule = schedule_of(rows);
  impl->step = longest_step(rows);
  impl->rows = rows.size();
  impl->rates = rates_for(columns);
  for (const ChainColumn& column : columns) {
    impl->tasks.push_back(
        {column, Vector2d::Zero(), {}, std::vector<double>(impl->schedule.position.size())});
  }
  impl->needs_size = std::any_of(plan.groups.begin(), plan.groups.end(), [](const Group& group) {
    return std::holds_alternative<RprDyad>(group.kind);
  });
  impl->posed.resize(bodies);
  impl->posed_angles.resize(bodies);
  impl->bodies.resize(bodies);
  impl->modes.resize(plan.groups.size());
  impl->best_modes.resize(plan.groups.size());
  impl->watches.resize(plan.groups.size());
  impl->bounds.resize(bodies);
  const std::vector<ChainAngle> angles = angles_of(plan, bodies);
  for (ChainTask& task : impl->tasks) {
    task.angle = angles[static_cast<std::size_t>(task.column.body)];
  }
  return DyadChain(std::move(impl));
}

bool DyadChain::solve(const Mechanism& mechanism) {
  Impl& own = *impl_;
  if (!own.redimension(mechanism)) {
    return false;
  }
  own.take_poses(mechanism);
  if (!own.assemble(mechanism)) {
    return false;
  }
  for (ChainTask& task : own.tasks) {
    if (task.column.point) {
      const Body& body = mechanism.bodies[static_cast<std::size_t>(task.column.body)];
      task.p_B = body.points[static_cast<std::size_t>(*task.column.point)].p_B;
    }
  }
  fill_chain_rows(
      {own.plan, own.best_modes, own.schedule, own.rates, own.bodies.size(), own.tasks, own.watches});
  if (!stays_on_branches(own.plan, own.watches, own.step, own.bounds)) {
    return false;
  }
  for (ChainTask& task : own.tasks) {
    if (task.column.quantity == Quantity::kAngle && task.angle.source == ChainAngle::Source::kRotation) {
      unwind(task.angle, own.posed_angles[static_cast<std::size_t>(task.angle.body)],
             std::span(task.values).first(own.rows));
    }
  }
  return true;
}

std::span<const double> DyadChain::values(std::size_t column) const {
  return std::span(impl_->tasks[column].values).first(impl_->rows);
}

}  // namespace higherpair
