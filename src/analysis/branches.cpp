#include "higherpair/analysis/branches.hpp"

#include "assembly.hpp"
#include "group_solver.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

namespace higherpair {
namespace {

double posed_coordinate(const std::vector<BodyMotion>& posed, const CarriedBody& carried) {
  return carried_coordinate(carried, posed[static_cast<std::size_t>(carried.carrier)],
                            posed[static_cast<std::size_t>(carried.body)]);
}

ContactPlace place_of_tracked(const Run& run, const TrackedPair& tracked) {
  ContactPlace place;
  place.contact = tracked.contact;
  place.follower = tracked.follower;
  place.pair = tracked.pair;
  place.u = tracked.driver_sign * run.drivers[static_cast<std::size_t>(tracked.driver)];
  place.known_is_first = tracked.driver_is_first;
  return place;
}

ContactPlace place_of_touching(const Run& run, const TouchingBody& touching) {
  const StandingPair placed = standing_pair({run.mechanism, run.plan}, touching, run.state);
  ContactPlace place;
  place.contact = touching.contact;
  place.follower = touching.follower;
  place.pair = placed.pair;
  place.u = placed.u;
  place.known_is_first = touching.follower_is_second;
  if (touching.follower.freedom.turns) {
    place.carrier_angle = run.state.bodies[static_cast<std::size_t>(touching.follower.carrier)].theta;
  }
  return place;
}

}  // namespace

tl::expected<Branches, StartFailure> list_branches(const Mechanism& mechanism,
                                                   const std::vector<double>& drivers) {
  auto plan = make_plan(mechanism);
  if (!plan) {
    return tl::unexpected(StartFailure{plan.error(), std::nullopt});
  }
  Run run;
  run.mechanism = mechanism;
  run.plan = std::move(*plan);
  run.drivers = drivers;
  const Assemblies found = assemble_all(run);

  Branches branches;
  const std::vector<BodyMotion> posed = posed_bodies(mechanism);
  const bool assembled = !assemble(run).has_value();
  branches.complete = found.complete;
  for (const Group& group : run.plan.groups) {
    if (const auto* tracked = std::get_if<TrackedPair>(&group.kind)) {
      branches.contacts.push_back(place_of_tracked(run, *tracked));
    } else if (const auto* touching = std::get_if<TouchingBody>(&group.kind);
               touching != nullptr && assembled) {
      branches.contacts.push_back(place_of_touching(run, *touching));
    }
    branches.complete = branches.complete && !std::holds_alternative<CoupledBodies>(group.kind);
  }
  for (ContactPlace& place : branches.contacts) {
    place.posed = posed_coordinate(posed, place.follower);
  }
  for (const State& state : found.states) {
    std::vector<double>& coordinates = branches.assemblies.emplace_back();
    for (const Joint& joint : mechanism.joints) {
      coordinates.push_back(joint_motion(mechanism, joint, state.bodies).position);
    }
  }
  return branches;
}

}  // namespace higherpair
