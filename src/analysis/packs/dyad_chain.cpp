#include "higherpair/analysis/dyad_chain.hpp"

#include "analysis/tolerances.hpp"
#include "chain_assembly.hpp"
#include "chain_bounds.hpp"
#include "chain_columns.hpp"
#include "chain_loads.hpp"
#include "chain_rows.hpp"
#include "higherpair/mechanism/description.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/redimension.hpp"
#include "higherpair/numeric/overload.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

using Quantity = ChainColumn::Quantity;

constexpr std::ptrdiff_t kMostDyads = 6;  // 2^6 assemblies are tried

// Converts the groups of a plan into those of a chain. Each contact may add a link between two centres, whose
// index follows those of the mechanism's bodies. False if a chain cannot solve one of the groups.
bool take_groups(const Mechanism& mechanism, const Plan& plan, std::vector<ChainGroup>& groups) {
  groups.clear();
  int link = static_cast<int>(mechanism.bodies.size());
  for (const Group& group : plan.groups) {
    auto made = chain_group(mechanism, group, link);
    if (!made) {
      return false;
    }
    link += group.contacts.empty() ? 0 : 1;
    groups.push_back(*std::move(made));
  }
  return true;
}

bool is_chain(const Mechanism& mechanism, const Plan& plan, const std::vector<ChainGroup>& groups) {
  const auto dyads =
      std::count_if(groups.begin(), groups.end(), [](const ChainGroup& group) { return group.two_modes; });
  return mechanism.drivers.size() == 1 && plan.surplus == 0 && dyads <= kMostDyads &&
         mechanism.bodies.size() + mechanism.contacts.size() <= kMostChainBodies &&
         groups.size() <= kMostChainGroups;
}

bool has_ovals(const std::vector<ChainGroup>& groups) {
  return std::any_of(groups.begin(), groups.end(),
                     [](const ChainGroup& group) { return std::holds_alternative<OvalContact>(group.kind); });
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

double largest_coordinate(const Mechanism& mechanism, std::span<const ChainGroup> groups) {
  double largest = 0;
  for (const Body& body : mechanism.bodies) {
    for (const NamedPoint& point : body.points) {
      largest = std::max({largest, std::abs(point.p_B.x()), std::abs(point.p_B.y())});
    }
  }
  for (const ChainGroup& group : groups) {
    if (const OvalContact* contact = contact_of(group)) {
      largest = std::max({largest, contact->on_known.center_B.cwiseAbs().maxCoeff(),
                          contact->on_body.center_B.cwiseAbs().maxCoeff(),
                          contact->on_known.along + contact->on_body.along});
    }
  }
  return largest;
}

double shortest_link(std::span<const ChainGroup> groups, double size) {
  const Overload length{[](const RrrDyad& dyad) { return std::min(dyad.length_a, dyad.length_b); },
                        [](const RrpDyad& dyad) { return dyad.length; },
                        [](const DrivenBody&) { return kInf; }, [&](const auto&) { return size; }};
  double shortest = kInf;
  for (const ChainGroup& group : groups) {
    shortest = std::min(shortest, std::visit(length, group.kind));
  }
  return shortest;
}

}  // namespace

struct DyadChain::Impl {
  Plan plan;  // of the mechanism solved last
  ChainSchedule schedule;
  double step = 0;  // the longest between two rows
  std::size_t rows = 0;
  ChainRates rates = ChainRates::kNone;  // rates that the columns need
  std::vector<ChainTask> tasks;  // those asked for, followed by the forces of contacts that must not pull
  std::size_t asked = 0;
  std::vector<ChainGroup> groups;  // of the plan
  std::vector<ChainAngle> angles;  // of the bodies
  std::vector<ChainTurning> turnings;
  std::optional<ChainStatics> statics;  // set if forces are asked for
  bool needs_size = false;  // size is needed for dyads whose sine is a length, for contacts and for springs
  ChainAssembly assembly;
  std::vector<ChainWatch<double>> watches;
  std::vector<MotionBound> bounds;
  std::vector<char> placed;  // bodies whose positions are needed: see placed_bodies()

  [[nodiscard]] bool redimension(const Mechanism& mechanism);
  void ask(std::vector<ChainColumn> columns, const Mechanism& mechanism);
  void mark_sprung();
  [[nodiscard]] bool knows_angles() const;
  [[nodiscard]] bool knows_forces() const;
};

bool DyadChain::Impl::redimension(const Mechanism& mechanism) {
  if (needs_size) {
    plan.size = size_of(mechanism);
  }
  redimension_groups(plan, mechanism);
  return take_groups(mechanism, plan, groups) &&
         (!statics || take_statics(mechanism, plan, groups, angles, *statics)) &&
         largest_coordinate(mechanism, groups) <= kFarthestPoint * shortest_link(groups, plan.size);
}

// Makes a task for every column, and one for the force of every contact that must not pull.
void DyadChain::Impl::ask(std::vector<ChainColumn> columns, const Mechanism& mechanism) {
  asked = columns.size();
  for (std::size_t c = 0; statics && c < mechanism.contacts.size(); ++c) {
    if (!mechanism.contacts[c].both_sides) {
      columns.push_back({static_cast<int>(c), std::nullopt, Quantity::kContactForce});
    }
  }
  for (const ChainColumn& column : columns) {
    ChainTask& task = tasks.emplace_back();
    task.column = column;
    task.values.resize(schedule.position.size());
    if (column.quantity == Quantity::kAngle) {
      task.angle = angles[column.item];
    }
  }
  placed = placed_bodies(groups, columns, angles.size());
}

// Marks the turnings that torsion springs need, whether or not a column asks for them.
void DyadChain::Impl::mark_sprung() {
  for (std::size_t i = 0; statics && i < statics->loads.pin_springs.size(); ++i) {
    const ChainLoads::PinSpring& spring = statics->loads.pin_springs[i];
    for (const int turning : {spring.first.turning, spring.second.turning}) {
      if (turning >= 0) {
        turnings[turning].sprung = true;
      }
    }
  }
}

// Whether the angles in the first row are unambiguous: no two are equally near to that of a body's pose.
bool DyadChain::Impl::knows_angles() const {
  return std::all_of(turnings.begin(), turnings.end(), [](const ChainTurning& turning) {
    return std::abs(turning.first_angle - turning.posed_angle) <= kSureTurn;
  });
}

// Whether all springs have directions and all contacts press along the whole path.
bool DyadChain::Impl::knows_forces() const {
  const auto presses = [&](const ChainTask& task) {
    return presses_throughout(std::span(task.values).first(rows));
  };
  return statics->shortest2 >= std::pow(kShortestSpring * plan.size, 2) &&
         std::all_of(tasks.begin() + static_cast<std::ptrdiff_t>(asked), tasks.end(), presses);
}

DyadChain::DyadChain(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
DyadChain::DyadChain(DyadChain&& other) noexcept = default;
DyadChain& DyadChain::operator=(DyadChain&& other) noexcept = default;
DyadChain::~DyadChain() = default;

std::optional<DyadChain> DyadChain::of(const Mechanism& mechanism, const Plan& plan,
                                       std::span<const DriverMotion> rows, std::vector<ChainColumn> columns) {
  auto impl = std::make_unique<Impl>();
  if (rows.empty() || !take_groups(mechanism, plan, impl->groups) ||
      !is_chain(mechanism, plan, impl->groups)) {
    return std::nullopt;
  }
  for (const ChainColumn& column : columns) {
    if (column.quantity == Quantity::kPressure && !has_pressure(mechanism, impl->groups, column.item)) {
      return std::nullopt;
    }
  }
  const std::size_t bodies = mechanism.bodies.size() + mechanism.contacts.size();
  impl->angles = angles_of(impl->groups, bodies, impl->turnings);
  impl->plan = plan;
  impl->schedule = schedule_of(rows);
  impl->step = longest_step(rows);
  impl->rows = rows.size();
  impl->rates = rates_for(columns);
  if (std::any_of(columns.begin(), columns.end(),
                  [](const ChainColumn& column) { return is_force(column.quantity); }) &&
      !take_statics(mechanism, plan, impl->groups, impl->angles, impl->statics.emplace())) {
    return std::nullopt;
  }
  impl->needs_size = !mechanism.contacts.empty() || !mechanism.springs.empty() ||
                     std::any_of(plan.groups.begin(), plan.groups.end(),
                                 [](const Group& group) { return traits_of(group).long_sine; });
  impl->assembly = ChainAssembly(mechanism.bodies.size(), bodies, plan.groups.size());
  impl->watches.resize(plan.groups.size());
  impl->bounds.resize(bodies);
  impl->ask(std::move(columns), mechanism);
  impl->mark_sprung();
  return DyadChain(std::move(impl));
}

bool DyadChain::solve(const Mechanism& mechanism) {
  Impl& own = *impl_;
  if (!own.redimension(mechanism)) {
    return false;
  }
  const ChainDriver<double> first{own.schedule.position[0], {own.schedule.cosine[0], own.schedule.sine[0]}};
  if (!own.assembly.find({mechanism, own.plan, own.groups, first})) {
    return false;
  }
  for (ChainTask& task : own.tasks) {
    if (task.column.quantity == Quantity::kPressure) {
      task.touch = *touch_in(own.groups, task.column.item);
    } else if (task.column.point) {
      const Body& body = mechanism.bodies[task.column.item];
      task.p_B = body.points[*task.column.point].p_B;
    }
  }
  for (ChainTurning& turning : own.turnings) {
    turning.posed_angle = turning.first_angle =
        own.assembly.posed_angle(static_cast<std::size_t>(turning.body));
  }
  const ChainRates rates = has_ovals(own.groups) ? ChainRates::kAccelerations : own.rates;
  fill_chain_rows({own.groups, own.assembly.modes(), own.schedule, rates, own.placed, own.plan.size,
                   own.tasks, own.turnings, own.watches, own.assembly.ovals(),
                   own.statics ? &*own.statics : nullptr});
  return stays_on_branches(own.groups, own.watches, own.step, own.plan.size, own.bounds) &&
         own.knows_angles() && (!own.statics || own.knows_forces());
}

std::span<const double> DyadChain::values(std::size_t column) const {
  return std::span(impl_->tasks[column].values).first(impl_->rows);
}

}  // namespace higherpair
