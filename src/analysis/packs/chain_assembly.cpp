#include "chain_assembly.hpp"

#include "analysis/tolerances.hpp"
#include "higherpair/mechanism/description.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace higherpair {
namespace {

// The contact of ovals in the first row; rates in `state` are those for a unit velocity.
OvalRow oval_row(const OvalContact& of, const Contact& contact, const State& state, std::size_t g,
                 double position) {
  const BodyMotion& body = state.bodies[of.touch.body];
  const ContactMotion& motion = state.contacts[of.touch.contact];
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

}  // namespace

ChainAssembly::ChainAssembly(std::size_t bodies, std::size_t with_links, std::size_t groups)
    : posed_(bodies),
      posed_angles_(bodies),
      bodies_(with_links),
      modes_(groups),
      best_modes_(groups),
      ovals_(groups) {}

void ChainAssembly::take_poses(const Mechanism& mechanism) {
  for (std::size_t i = 1; i < posed_.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    posed_[i].p_WB = body.guess_p_WB;
    if (posed_angles_[i] != body.guess_theta) {
      posed_angles_[i] = body.guess_theta;
      posed_[i].R_WB = Rotation<double>::from_angle(body.guess_theta);
    }
  }
}

// Sum of the squared distances of a group's joint points from where the poses put them.
double ChainAssembly::cost_of(const ChainStart& start, const Group& group) const {
  double cost = 0;
  for (const int index : group.joints) {
    const Joint& joint = start.mechanism.joints[index];
    for (const PointRef& ref : {joint.first, joint.second}) {
      const auto body = static_cast<std::size_t>(ref.body);
      const Vector2d& p_B = point_of(start.mechanism, ref);
      const Vector2d here = chain_point<ChainRates::kNone>(bodies_[body], p_B).p_W;
      const Vector2d there = chain_point<ChainRates::kNone>(posed_[body], p_B).p_W;
      cost += (here - there).squaredNorm();
    }
  }
  return cost;
}

// Tries both modes of every dyad from the g-th on, as start_run() does. `cost` is that of the groups before.
void ChainAssembly::try_modes(const ChainStart& start, std::size_t g, double cost) {
  if (!(cost < next_cost_)) {
    return;
  }
  if (g == start.plan.groups.size()) {
    next_cost_ = std::min(next_cost_, std::max(cost, best_cost_));
    if (cost < best_cost_) {
      best_cost_ = cost;
      best_modes_ = modes_;
    }
    return;
  }
  const ChainGroup& group = start.groups[g];
  for (const double mode : {1.0, -1.0}) {
    ChainWatch<double> watch;
    modes_[g] = mode;
    solve_group<ChainRates::kNone>(group, mode, start.driver, bodies_.data(), watch);
    const bool dyad = group.two_modes;
    const double limit = traits_of(start.plan.groups[g]).long_sine ? 0 : 1;
    if (!dyad || watch.margin < limit) {
      try_modes(start, g + 1, cost + cost_of(start, start.plan.groups[g]));
    }
    if (!dyad) {
      return;
    }
  }
}

// If two assemblies are equally near, a Run chooses.
bool ChainAssembly::find(const ChainStart& start) {
  take_poses(start.mechanism);
  if (!start.mechanism.contacts.empty()) {
    return assemble_by_run(start);
  }
  best_cost_ = next_cost_ = kInf;
  try_modes(start, 0, 0);
  const double near = kAsNear * start.plan.size * start.plan.size * static_cast<double>(posed_.size());
  if (next_cost_ - best_cost_ > near) {
    return true;
  }
  return assemble_by_run(start);
}

// Takes over the assembly that start_run finds: it has its own ways to search for contacts.
bool ChainAssembly::assemble_by_run(const ChainStart& start) {
  start.plan.size = size_of(start.mechanism);
  const auto nobody = std::shared_ptr<void>();  // owns nothing: mechanism and plan outlive the run
  const auto run = start_run({std::shared_ptr<const Mechanism>(nobody, &start.mechanism),
                              std::shared_ptr<const Plan>(nobody, &start.plan)},
                             {start.driver.position});
  return run && take_modes(start, *run);
}

bool ChainAssembly::take_modes(const ChainStart& start, const Run& run) {
  for (std::size_t g = 0; g < start.groups.size(); ++g) {
    const PairTrack& track = run.at.state.tracks[g];
    if (!std::holds_alternative<std::monostate>(track) && !std::holds_alternative<ContactTrack>(track)) {
      return false;
    }
    if (const auto* contact = std::get_if<OvalContact>(&start.groups[g].kind)) {
      ovals_[g] = oval_row(*contact, run.mechanism().contacts[contact->touch.contact], run.at.state, g,
                           start.driver.position);
    }
    best_modes_[g] = run.at.state.groups[g].mode;
    if (start.groups[g].discs && !take_mode_of_disc(start, run, g)) {
      return false;
    }
    place_as(run, start.plan.groups[g]);
  }
  return true;
}

// Takes the mode in which the dyad puts the disc where the run has it.
bool ChainAssembly::take_mode_of_disc(const ChainStart& start, const Run& run, std::size_t g) {
  const auto disc = static_cast<std::size_t>(start.groups[g].discs->touch.body);
  const Pose<double>& X_WB = run.at.state.bodies[disc].X_WB;
  for (const double mode : {1.0, -1.0}) {
    ChainWatch<double> watch;
    solve_group<ChainRates::kNone>(start.groups[g], mode, start.driver, bodies_.data(), watch);
    const Rotation<double> turned = bodies_[disc].R_WB * X_WB.R_WB.inverse();
    if ((bodies_[disc].p_WB - X_WB.p_WB).norm() <= kSameChainPlace * start.plan.size && turned.cos > 0 &&
        std::abs(turned.sin) <= kSameChainPlace) {
      best_modes_[g] = mode;
      return true;
    }
  }
  return false;
}

void ChainAssembly::place_as(const Run& run, const Group& group) {
  for (const int body : group.bodies) {
    const auto i = static_cast<std::size_t>(body);
    bodies_[i].R_WB = run.at.state.bodies[i].X_WB.R_WB;
    bodies_[i].p_WB = run.at.state.bodies[i].X_WB.p_WB;
  }
}

}  // namespace higherpair
