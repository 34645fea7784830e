#include "higherpair/analysis/dyad_chain.hpp"

#include "chain_bounds.hpp"
#include "chain_columns.hpp"
#include "chain_loads.hpp"
#include "chain_rows.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/mechanism/build.hpp"
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

constexpr std::ptrdiff_t kMostDyads = 6;  // 2^6 assemblies are tried

// Of the size: how far a disc may be from where a Run has put it. The other mode is much farther away.
constexpr double kSameChainPlace = 1e-6;

// A body that starts as far from its pose's angle may be half a turn from it, on either side.
constexpr double kSureTurn = kPi - 1e-6;

// Of the size: a spring shorter than this has a direction made of rounding, or none.
constexpr double kShortestSpring = 1e-6;

// The groups as a chain solves them, into `groups`; each contact may have a body of its own between two
// centres, behind those of the mechanism. False where one of them is not for a chain.
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

// Where a contact of ovals is in the first row; rates in `state` are those for a unit velocity.
OvalRow oval_row(const OvalContact& of, const Contact& contact, const State& state, std::size_t g,
                 double position) {
  const BodyMotion& body = state.bodies[static_cast<std::size_t>(of.touch.body)];
  const ContactMotion& motion = state.contacts[static_cast<std::size_t>(of.touch.contact)];
  const OneFreedom& freedom = of.touch.freedom;
  OvalRow row;
  row.position = position;
  row.turn = body.X_WB.R_WB;
  row.n_W = contact.first.body == of.touch.known ? motion.at.n_W : Vector2d(-motion.at.n_W);
  row.phi_dot = motion.rates.phi_dot;
  row.gap_q = state.groups[g].sine;
  row.gap_q_rate = state.groups[g].sine_rate;
  row.rate = body.omega;
  row.second_rate = body.alpha;
  if (!freedom.turns) {
    row.slide = (body.X_WB * freedom.p_BO - freedom.p_WO).dot(freedom.direction_W);
    row.rate = body.v_WB.dot(freedom.direction_W);
    row.second_rate = body.a_WB.dot(freedom.direction_W);
  }
  return row;
}

double largest_coordinate(const Mechanism& mechanism, std::span<const ChainGroup> groups) {
  double largest = 0;
  for (const Body& body : mechanism.bodies) {
    for (const NamedPoint& point : body.points) {
      largest = std::max({largest, std::abs(point.p_B.x()), std::abs(point.p_B.y())});
    }
  }
  for (const ChainGroup& group : groups) {
    if (const auto* ovals = std::get_if<OvalContact>(&group.kind)) {
      largest = std::max({largest, ovals->on_known.center_B.cwiseAbs().maxCoeff(), ovals->on_known.along,
                          ovals->on_body.center_B.cwiseAbs().maxCoeff(), ovals->on_body.along});
    } else if (const auto* rrr = std::get_if<RrrDyad>(&group.kind); rrr != nullptr && group.discs) {
      largest = std::max(
          {largest, rrr->length_a, rrr->A.p_B.cwiseAbs().maxCoeff(), rrr->b_pC.cwiseAbs().maxCoeff()});
    } else if (const auto* rrp = std::get_if<RrpDyad>(&group.kind); rrp != nullptr && group.discs) {
      largest = std::max(
          {largest, rrp->length, rrp->A.p_B.cwiseAbs().maxCoeff(), rrp->slider->p_B.cwiseAbs().maxCoeff()});
    }
  }
  return largest;
}

double shortest_link(std::span<const ChainGroup> groups, double size) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const ChainGroup& group : groups) {
    if (const auto* rrr = std::get_if<RrrDyad>(&group.kind)) {
      shortest = std::min({shortest, rrr->length_a, rrr->length_b});
    } else if (const auto* rrp = std::get_if<RrpDyad>(&group.kind)) {
      shortest = std::min(shortest, rrp->length);
    } else if (!std::holds_alternative<DrivenBody>(group.kind)) {
      shortest = std::min(shortest, size);
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
  ChainRates rates = ChainRates::kNone;  // that the columns want
  std::vector<ChainTask> tasks;  // those asked for; behind them the forces of contacts that must not pull
  std::size_t asked = 0;
  std::vector<ChainGroup> groups;  // of the plan
  std::vector<ChainAngle> angles;  // of the bodies
  std::vector<ChainTurning> turnings;
  std::optional<ChainStatics> statics;    // where forces are wanted
  bool needs_size = false;                // for dyads whose sine is a length, contacts, springs
  std::vector<OvalRow> ovals;             // of the groups: contacts in the first row
  std::vector<ChainBody<double>> posed;   // the poses
  std::vector<double> posed_angles;       // in them
  std::vector<ChainBody<double>> bodies;  // in the first row
  std::vector<double> modes;              // of the assembly that is tried
  std::vector<double> best_modes;         // of the nearest one so far
  double best_cost = 0;
  double next_cost = 0;  // of the nearest of the others
  std::vector<ChainWatch<double>> watches;
  std::vector<MotionBound> bounds;
  std::vector<char> placed;  // the bodies of which columns want more than their turning

  void take_poses(const Mechanism& mechanism);
  [[nodiscard]] bool redimension(const Mechanism& mechanism);
  [[nodiscard]] double cost_of(const Mechanism& mechanism, const Group& group) const;
  void try_modes(const Mechanism& mechanism, std::size_t g, double cost);
  [[nodiscard]] bool assemble(const Mechanism& mechanism);
  [[nodiscard]] bool assemble_by_run(const Mechanism& mechanism);
  [[nodiscard]] bool take_modes(const Run& run);
  [[nodiscard]] bool take_mode_of_disc(const Run& run, std::size_t g);
  void place_as(const Run& run, const Group& group);
  [[nodiscard]] bool knows_angles() const;
  [[nodiscard]] bool knows_forces() const;
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
  return take_groups(mechanism, plan, groups) &&
         (!statics || take_statics(mechanism, plan, groups, angles, *statics)) &&
         largest_coordinate(mechanism, groups) <= kFarthestPoint * shortest_link(groups, plan.size);
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
  const ChainGroup& group = groups[g];
  for (const double mode : {1.0, -1.0}) {
    ChainWatch<double> watch;
    modes[g] = mode;
    solve_group<ChainRates::kNone>(group, mode, driver, bodies.data(), watch);
    const bool dyad = group.two_modes;
    const double limit = std::holds_alternative<RprDyad>(group.kind) ? 0 : 1;
    if (!dyad || watch.margin < limit) {
      try_modes(mechanism, g + 1, cost + cost_of(mechanism, plan.groups[g]));
    }
    if (!dyad) {
      return;
    }
  }
}

// Finds best_modes. Where assemblies are as near as each other, rounding decides: that of a Run.
bool DyadChain::Impl::assemble(const Mechanism& mechanism) {
  if (!mechanism.contacts.empty()) {
    return assemble_by_run(mechanism);
  }
  best_cost = next_cost = std::numeric_limits<double>::infinity();
  try_modes(mechanism, 0, 0);
  if (best_cost < next_cost * (1 - kAsNear)) {
    return true;
  }
  return assemble_by_run(mechanism);
}

// What start_run finds: contacts are looked for in ways of their own.
bool DyadChain::Impl::assemble_by_run(const Mechanism& mechanism) {
  plan.size = size_of(mechanism);
  const auto nobody = std::shared_ptr<void>();  // owns what outlives the run
  const auto run = start_run(
      {std::shared_ptr<const Mechanism>(nobody, &mechanism), std::shared_ptr<const Plan>(nobody, &plan)},
      {schedule.position[0]});
  return run && take_modes(*run);
}

bool DyadChain::Impl::take_modes(const Run& run) {
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const PairTrack& track = run.at.state.tracks[g];
    if (!std::holds_alternative<std::monostate>(track) && !std::holds_alternative<ContactTrack>(track)) {
      return false;
    }
    if (const auto* contact = std::get_if<OvalContact>(&groups[g].kind)) {
      ovals[g] =
          oval_row(*contact, run.mechanism().contacts[static_cast<std::size_t>(contact->touch.contact)],
                   run.at.state, g, schedule.position[0]);
    }
    best_modes[g] = run.at.state.groups[g].mode;
    if (groups[g].discs && !take_mode_of_disc(run, g)) {
      return false;
    }
    place_as(run, plan.groups[g]);
  }
  return true;
}

// The mode in which the dyad puts the disc where the run has it.
bool DyadChain::Impl::take_mode_of_disc(const Run& run, std::size_t g) {
  const auto disc = static_cast<std::size_t>(groups[g].discs->body);
  const Pose<double>& X_WB = run.at.state.bodies[disc].X_WB;
  const ChainDriver<double> driver{schedule.position[0], {schedule.cosine[0], schedule.sine[0]}};
  for (const double mode : {1.0, -1.0}) {
    ChainWatch<double> watch;
    solve_group<ChainRates::kNone>(groups[g], mode, driver, bodies.data(), watch);
    const Rotation<double> turned = bodies[disc].R_WB * X_WB.R_WB.inverse();
    if ((bodies[disc].p_WB - X_WB.p_WB).norm() <= kSameChainPlace * plan.size && turned.cos > 0 &&
        std::abs(turned.sin) <= kSameChainPlace) {
      best_modes[g] = mode;
      return true;
    }
  }
  return false;
}

void DyadChain::Impl::place_as(const Run& run, const Group& group) {
  for (const int body : group.bodies) {
    const auto i = static_cast<std::size_t>(body);
    bodies[i].R_WB = run.at.state.bodies[i].X_WB.R_WB;
    bodies[i].p_WB = run.at.state.bodies[i].X_WB.p_WB;
  }
}

// Whether there are no two angles in the first row that are as near to a body's pose as each other.
bool DyadChain::Impl::knows_angles() const {
  return std::all_of(turnings.begin(), turnings.end(), [](const ChainTurning& turning) {
    return std::abs(turning.first_angle - turning.posed_angle) <= kSureTurn;
  });
}

// Whether springs have directions, and contacts press on the whole way.
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
    if (column.quantity == Quantity::kPressure && !has_pressure(mechanism, impl->groups, column.body)) {
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
  impl->asked = columns.size();
  for (std::size_t c = 0; impl->statics && c < mechanism.contacts.size(); ++c) {
    if (!mechanism.contacts[c].both_sides) {
      columns.push_back({static_cast<int>(c), std::nullopt, Quantity::kContactForce});
    }
  }
  for (const ChainColumn& column : columns) {
    ChainTask& task = impl->tasks.emplace_back();
    task.column = column;
    task.values.resize(impl->schedule.position.size());
  }
  impl->needs_size = !mechanism.contacts.empty() || !mechanism.springs.empty() ||
                     std::any_of(plan.groups.begin(), plan.groups.end(), [](const Group& group) {
                       return std::holds_alternative<RprDyad>(group.kind);
                     });
  impl->ovals.resize(plan.groups.size());
  impl->posed.resize(mechanism.bodies.size());
  impl->posed_angles.resize(mechanism.bodies.size());
  impl->bodies.resize(bodies);
  impl->modes.resize(plan.groups.size());
  impl->best_modes.resize(plan.groups.size());
  impl->watches.resize(plan.groups.size());
  impl->bounds.resize(bodies);
  impl->placed = placed_bodies(impl->groups, columns, bodies);
  for (ChainTask& task : impl->tasks) {
    if (task.column.quantity == Quantity::kAngle) {
      task.angle = impl->angles[static_cast<std::size_t>(task.column.body)];
    }
  }
  for (std::size_t i = 0; impl->statics && i < impl->statics->loads.pin_springs.size(); ++i) {
    const ChainLoads::PinSpring& spring = impl->statics->loads.pin_springs[i];
    for (const int turning : {spring.first.turning, spring.second.turning}) {
      if (turning >= 0) {
        impl->turnings[static_cast<std::size_t>(turning)].sprung = true;
      }
    }
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
    if (task.column.quantity == Quantity::kPressure) {
      task.touch = *touch_in(own.groups, task.column.body);
    } else if (task.column.point) {
      const Body& body = mechanism.bodies[static_cast<std::size_t>(task.column.body)];
      task.p_B = body.points[static_cast<std::size_t>(*task.column.point)].p_B;
    }
  }
  for (ChainTurning& turning : own.turnings) {
    const auto body = static_cast<std::size_t>(turning.body);
    turning.posed_angle =
        body < own.posed_angles.size() ? own.posed_angles[body] : 0;  // 0: of links of contacts
    turning.first_angle = turning.posed_angle;
  }
  const ChainRates rates = has_ovals(own.groups) ? ChainRates::kAccelerations : own.rates;
  fill_chain_rows({own.groups, own.best_modes, own.schedule, rates, own.placed, own.plan.size, own.tasks,
                   own.turnings, own.watches, own.ovals, own.statics ? &*own.statics : nullptr});
  if (!stays_on_branches(own.groups, own.watches, own.step, own.plan.size, own.bounds) ||
      !own.knows_angles() || (own.statics && !own.knows_forces())) {
    return false;
  }
  return true;
}

std::span<const double> DyadChain::values(std::size_t column) const {
  return std::span(impl_->tasks[column].values).first(impl_->rows);
}

}  // namespace higherpair
