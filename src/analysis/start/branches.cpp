#include "higherpair/analysis/branches.hpp"

#include "analysis/follow/step.hpp"
#include "analysis/groups/group_solver.hpp"
#include "analysis/tolerances.hpp"
#include "assembly.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/contains.hpp"

#include <algorithm>

namespace higherpair {
namespace {

ContactPlace place_of_tracked(const Run& run, const TrackedPair& tracked) {
  ContactPlace place;
  place.contact = tracked.contact;
  place.follower = tracked.follower;
  place.pair = tracked.pair;
  place.u = tracked.driver_sign * run.at.inputs[tracked.driver];
  place.known_is_first = tracked.driver_is_first;
  return place;
}

ContactPlace place_of_touching(const Run& run, const TouchingBody& touching) {
  const FrozenPair placed = frozen_pair(model_of(run), touching, run.at.state);
  ContactPlace place;
  place.contact = touching.contact;
  place.follower = touching.follower;
  place.pair = placed.pair;
  place.u = placed.u;
  place.known_is_first = touching.follower_is_second;
  place.carrier_angle = carrier_angle(touching.follower, run.at.state.bodies);
  return place;
}

// Whether pins join the bodies without a loop, so that gears and drivers of pins determine their angles by
// linear equations: there is then one assembly, whatever the poses.
bool is_gear_train(const Mechanism& mechanism, const Group& group) {
  std::vector<int> pins;
  for (const int index : group.joints) {
    const JointType type = mechanism.joints[index].type;
    if (type == JointType::kRevolute) {
      pins.push_back(index);
    } else if (!couples_turning(type)) {
      return false;
    }
  }
  const bool turning_drivers = std::all_of(group.drivers.begin(), group.drivers.end(), [&](int driver) {
    return driven_joint(mechanism, static_cast<std::size_t>(driver)).type == JointType::kRevolute;
  });
  if (!group.contacts.empty() || !turning_drivers || pins.size() != group.bodies.size()) {
    return false;
  }
  // With as many pins as bodies there is no loop if every body is attached by them.
  std::vector<int> loose = group.bodies;
  const auto is_loose = [&](int body) { return contains(loose, body); };
  for (std::size_t left = loose.size() + 1; loose.size() < left;) {
    left = loose.size();
    for (const int index : pins) {
      const Joint& pin = mechanism.joints[index];
      const int a = pin.first.body;
      const int b = pin.second.body;
      if (is_loose(a) != is_loose(b)) {
        loose.erase(std::find(loose.begin(), loose.end(), is_loose(a) ? a : b));
      }
    }
  }
  return loose.empty();
}

// At a dead centre two modes give the same assembly.
std::vector<State> different(const std::vector<State>& states, double size) {
  std::vector<State> kept;
  for (const State& state : states) {
    if (std::none_of(kept.begin(), kept.end(), [&](const State& other) {
          return have_same_poses(state, other, size, kSameAssembly);
        })) {
      kept.push_back(state);
    }
  }
  return kept;
}

}  // namespace

tl::expected<Branches, StartFailure> list_branches(const Mechanism& mechanism,
                                                   const std::vector<double>& drivers) {
  auto planned = planned_run(mechanism, drivers);
  if (!planned) {
    return tl::unexpected(std::move(planned.error()));
  }
  Run run = *std::move(planned);
  const Assemblies found = assemble_all(run);

  Branches branches;
  const std::vector<BodyMotion> posed = posed_bodies(mechanism);
  const bool assembled = !assemble(run).has_value();
  branches.complete = found.complete;
  for (const Group& group : run.plan().groups) {
    if (const auto* tracked = std::get_if<TrackedPair>(&group.kind)) {
      branches.contacts.push_back(place_of_tracked(run, *tracked));
    } else if (const auto* touching = std::get_if<TouchingBody>(&group.kind);
               touching != nullptr && assembled) {
      branches.contacts.push_back(place_of_touching(run, *touching));
    }
    const bool one_of_many = traits_of(group).coupled && !is_gear_train(mechanism, group);
    branches.complete = branches.complete && !one_of_many;
  }
  for (ContactPlace& place : branches.contacts) {
    place.posed = carried_coordinate(place.follower, posed);
  }
  for (const State& state : different(found.states, run.plan().size)) {
    std::vector<double>& coordinates = branches.assemblies.emplace_back();
    for (const Joint& joint : mechanism.joints) {
      coordinates.push_back(joint_motion(mechanism, joint, state.bodies).position);
    }
  }
  return branches;
}

}  // namespace higherpair
