#include "singular_start.hpp"

#include "analysis/follow/crossing.hpp"
#include "analysis/follow/reduction.hpp"
#include "analysis/groups/coupled_system.hpp"
#include "analysis/groups/group_system.hpp"
#include "analysis/tolerances.hpp"
#include "assembly.hpp"
#include "higherpair/contact/finder.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr std::size_t kMostChosen = 6;  // singular groups whose modes are all tried together

bool is_singular(const GroupState& group) {
  return std::abs(group.sine) <= kSingularStart * group.lever;
}

// The groups that start where their branches may cross.
std::vector<std::size_t> singular_groups(const Run& run) {
  std::vector<std::size_t> found;
  for (std::size_t g = 0; g < run.plan().groups.size(); ++g) {
    const Group& group = run.plan().groups[g];
    const bool follows = !std::holds_alternative<TrackedPair>(group.kind) ||
                         std::holds_alternative<ContactTrack>(run.at.state.tracks[g]);
    if (follows && traits_of(group).can_cross && is_singular(run.at.state.groups[g])) {
      found.push_back(g);
    }
  }
  return found;
}

// Sets the mode of a group; for a tracked contact also takes the contact of that branch for the drivers at
// `there`. False if there is none nearby.
bool take_mode(Run& run, std::size_t g, int mode, const std::vector<double>& there) {
  run.at.state.groups[g].mode = mode;
  const auto* tracked = std::get_if<TrackedPair>(&run.plan().groups[g].kind);
  if (tracked == nullptr) {
    return true;
  }
  const ContactPosition at = std::get<ContactTrack>(run.at.state.tracks[g]).at;
  const double u = tracked->driver_sign * there[tracked->driver];
  const FindResult found = find_nearest_contact(tracked->pair, u, at.q, mode);
  const double unit = tracked->pair.motion2.turns ? 1 : run.plan().size;
  if (found.status != FindStatus::kFound || !(std::abs(found.at.q - at.q) <= kNearMerge * unit) ||
      !(found.at.n_W.dot(at.n_W) > 1 - kNearMerge)) {
    return false;
  }
  run.at.state.tracks[g] = start_track(tracked->pair, found.at, mode);
  return true;
}

bool is_coupled(const Run& run, std::size_t g) {
  return traits_of(run.plan().groups[g]).coupled;
}

// Moves a coupled group onto its singular position: near it Newton's method yields only half the digits.
void settle_coupled(Run& run, std::size_t g) {
  Path path;
  std::vector<double> ahead = run.at.inputs;
  ahead[0] += driver_scale(run, 0);
  set_path(run, path, run.at.inputs, ahead);
  run.work.trial = run.at.state;
  Reduction reduction(run, path, g, 0);
  if (const auto singular = reduction.singular_point(kNearSingularStart * unit_of(run, path))) {
    reduction.place(*singular);
    take_group(run.plan().groups[g], run.work.trial, run.at.state);
    run.at.state.groups[g].sine = 0;
  }
}

// Coupled bodies have no modes to choose from: sets the rates of run.at.state so that a step along the path
// is predicted to lead to one of the two positions there.
bool aim_coupled(Run& run, std::size_t g, const Path& path, bool second) {
  const Group& group = run.plan().groups[g];
  run.work.trial = run.at.state;
  const std::vector<Reduction::Point> positions = Reduction(run, path, g, 0).positions_at(path.length);
  if (positions.size() < 2) {
    return false;
  }
  const Eigen::VectorXd& x = positions[second ? 1 : 0].x;
  const Eigen::VectorXd rate = (x - coordinates_of(model_of(run), group, run.at.state)) / path.length;
  Eigen::Index i = 0;
  for (const int index : group.bodies) {
    BodyMotion& body = run.at.state.bodies[index];
    body.v_WB = rate.segment<2>(i);
    body.omega = rate(i + 2) / run.plan().size;
    body.a_WB.setZero();
    body.alpha = 0;
    i += 3;
  }
  for (const int index : group.contacts) {
    run.at.state.contacts[index].rates.phi_dot = rate(i++) / run.plan().size;
  }
  return true;
}

// How fast all bodies together move.
double total_speed(const Run& run, const State& state) {
  double speed = 0;
  for (const BodyMotion& body : state.bodies) {
    speed += std::abs(body.omega) + body.v_WB.norm() / run.plan().size;
  }
  return speed;
}

double total_acceleration(const Run& run, const State& state) {
  double acceleration = 0;
  for (const BodyMotion& body : state.bodies) {
    acceleration += std::abs(body.alpha) + body.a_WB.norm() / run.plan().size;
  }
  return acceleration;
}

// Squared distance of a group from its poses, as for assembling; but where a contact chooses the mode, joint
// points may not move, so bodies are compared instead.
double distance_of(const Run& run, const Group& group, const State& state) {
  const std::vector<BodyMotion> posed = posed_bodies(run.mechanism());
  if (group.contacts.empty()) {
    return distance_from_poses(run.mechanism(), group, state.bodies, posed);
  }
  double distance = 0;
  for (const int body : group.bodies) {
    const auto i = static_cast<std::size_t>(body);
    const double turned = run.plan().size * (state.bodies[i].theta - posed[i].theta);
    distance += (state.bodies[i].X_WB.p_WB - posed[i].X_WB.p_WB).squaredNorm() + turned * turned;
  }
  return distance;
}

double distance_of(const Run& run, const std::vector<std::size_t>& groups, const State& state) {
  double distance = 0;
  for (const std::size_t g : groups) {
    distance += distance_of(run, run.plan().groups[g], state);
  }
  return distance;
}

// A way to leave a singular start.
struct Departure {
  State state;
  std::size_t driver = 0;
  double reach = 0;  // distance of that driver from the start
  double speed = 0;
  double acceleration = 0;
  double distance = 0;  // squared distance of the singular groups from the poses
  double at_start = 0;  // the same where the branch is at the start, between both sides of a crossing

  // Order where branches cross: the slower motion; of equally fast ones that with the smaller acceleration;
  // then the one nearer to the poses.
  [[nodiscard]] bool goes_before(const Departure& other) const {
    if (std::abs(speed - other.speed) > kSameSpeed * (speed + other.speed)) {
      return speed < other.speed;
    }
    if (std::abs(acceleration - other.acceleration) >
        kSameAcceleration * (acceleration + other.acceleration)) {
      return acceleration < other.acceleration;
    }
    return distance < other.distance;
  }
};

// Rates at a singular start are unbounded: they predict nothing, not even the whole turns of angles.
State without_rates(State state) {
  for (BodyMotion& body : state.bodies) {
    body.v_WB.setZero();
    body.a_WB.setZero();
    body.omega = body.alpha = 0;
  }
  for (ContactMotion& contact : state.contacts) {
    contact.rates.phi_dot = 0;
  }
  return state;
}

// The departures with every combination of modes of the singular groups.
std::vector<Departure> departures(Run& run, const std::vector<std::size_t>& groups, std::size_t driver,
                                  double reach) {
  std::vector<Departure> found;
  const StateAside start(run.at.state);
  const State at_rest = without_rates(start.kept());
  std::vector<double> ahead = run.at.inputs;
  ahead[driver] += reach;
  Path path;
  set_path(run, path, run.at.inputs, ahead);
  const std::size_t chosen = std::min(groups.size(), kMostChosen);
  for (unsigned combination = 0; combination < (1U << chosen); ++combination) {
    run.at.state = at_rest;
    bool taken = true;
    for (std::size_t i = 0; i < chosen && taken; ++i) {
      const bool other = (combination >> i & 1U) != 0;
      taken = is_coupled(run, groups[i])
                  ? aim_coupled(run, groups[i], path, other)
                  : take_mode(run, groups[i], start.kept().groups[groups[i]].mode * (other ? -1 : 1), ahead);
    }
    if (!taken || !solve_at(run, path, 0, path.length)) {
      continue;
    }
    const State& there = run.work.trial;
    if (std::none_of(groups.begin(), groups.end(),
                     [&](std::size_t g) { return is_singular(there.groups[g]); })) {
      found.push_back({there, driver, reach, total_speed(run, there), total_acceleration(run, there),
                       distance_of(run, groups, there)});
    }
  }
  return found;
}

// How much the velocities of two departures differ: those of one branch hardly do.
double change_of_velocities(const Run& run, const State& a, const State& b) {
  double change = 0;
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    change += std::abs(b.bodies[i].omega - a.bodies[i].omega) +
              (b.bodies[i].v_WB - a.bodies[i].v_WB).norm() / run.plan().size;
  }
  return change;
}

// Sets how far the departures before a crossing are from the poses at the start, where they are interpolated
// with those that continue them after it.
void measure_at_start(const Run& run, const std::vector<std::size_t>& groups,
                      const std::vector<Departure>& after, std::vector<Departure>& before) {
  for (Departure& one : before) {
    const auto other =
        std::min_element(after.begin(), after.end(), [&](const Departure& a, const Departure& b) {
          return change_of_velocities(run, one.state, a.state) <
                 change_of_velocities(run, one.state, b.state);
        });
    State between = other->state;
    interpolate(run, one.state, other->reach - one.reach, 0.5, between);
    one.at_start = distance_of(run, groups, between);
  }
}

// The departure before a crossing whose position at the start is that of the poses; none where the branches
// are too near each other there for the poses to decide.
std::optional<Departure> posed_among(const Run& run, const std::vector<Departure>& before) {
  const auto nearest =
      std::min_element(before.begin(), before.end(),
                       [](const Departure& a, const Departure& b) { return a.at_start < b.at_start; });
  const double known = kSameRunPosition * run.plan().size;
  for (const Departure& other : before) {
    const bool same = &other != &*nearest &&
                      !(nearest->at_start <= kPosesTell * other.at_start && other.at_start > known * known);
    if (same) {
      return std::nullopt;
    }
  }
  return *nearest;
}

// Whether the group has one position where it is singular: sliders on two lines that coincide have any on
// them.
bool has_own_position(const Run& run, std::size_t g) {
  return is_coupled(run, g) || !traits_of(run.plan().groups[g]).finds_mode;
}

// Whether a start is next to its departure; where pins coincide, links may have any direction at the start.
bool leads_to(const State& start, const State& departure) {
  for (std::size_t i = 0; i < start.bodies.size(); ++i) {
    if (!(std::abs(start.bodies[i].theta - departure.bodies[i].theta) <= kNearMerge)) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::optional<int> leave_singular_start(Run& run) {
  const std::vector<std::size_t> groups = singular_groups(run);
  if (groups.empty()) {
    return std::nullopt;
  }
  for (const std::size_t g : groups) {
    if (is_coupled(run, g)) {
      settle_coupled(run, g);
    }
  }
  std::optional<Departure> chosen;
  for (std::size_t driver = 0; driver < run.at.inputs.size() && !chosen; ++driver) {
    const double reach = kCrossingReach * driver_scale(run, driver);
    std::vector<Departure> before = departures(run, groups, driver, -reach);
    const std::vector<Departure> after = departures(run, groups, driver, reach);
    const bool crossing = !before.empty() && !after.empty();
    if (crossing && run.at.inputs.size() == 1) {
      measure_at_start(run, groups, after, before);
      chosen = posed_among(run, before);
      if (chosen) {
        break;
      }
    }
    for (const Departure& one : before.empty() ? after : before) {
      const bool better = !chosen || (crossing ? one.goes_before(*chosen) : one.distance < chosen->distance);
      chosen = better ? one : chosen;
    }
  }
  const GroupState& start = run.at.state.groups[groups.front()];
  const auto* tracked = std::get_if<TrackedPair>(&run.plan().groups[groups.front()].kind);
  if (!chosen) {
    return tracked == nullptr ? std::nullopt : std::optional(tracked->contact);
  }
  if (run.at.inputs.size() == 1 && !(std::abs(start.sine) > start.noise) &&
      leads_to(run.at.state, chosen->state) &&
      std::all_of(groups.begin(), groups.end(), [&](std::size_t g) { return has_own_position(run, g); })) {
    run.at.beside = run.at.state;
  }
  run.at.state = chosen->state;
  run.at.inputs[chosen->driver] += chosen->reach;
  return std::nullopt;
}

}  // namespace higherpair
