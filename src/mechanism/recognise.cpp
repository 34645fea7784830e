#include "recognise.hpp"

#include "dyads_of.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <algorithm>
#include <utility>

namespace higherpair {
namespace {

// The driver that moves a body against ground, if one does.
std::optional<int> grounded_driver(std::span<const Group> before, int body) {
  for (const Group& group : before) {
    const auto* driven = std::get_if<DrivenBody>(&group.kind);
    if (driven != nullptr && driven->carried.body == body && driven->carried.carrier == 0) {
      return driven->driver;
    }
  }
  return std::nullopt;
}

std::optional<GroupKind> tracked_pair(const Mechanism& mechanism, const BodySet& set,
                                      std::span<const Group> before) {
  const int body = set.bodies.front();
  const Contact& contact = mechanism.contacts[set.contacts.front()];
  TrackedPair tracked;
  tracked.contact = set.contacts.front();
  tracked.driver_is_first = contact.second.body == body;
  const CurveRef& on_driver = end_off(contact, body);
  const CurveRef& on_follower = end_on(contact, body);
  const auto driver = grounded_driver(before, on_driver.body);
  const Joint& joint = mechanism.joints[set.joints.front()];
  if (!driver || !is_grounded(joint)) {
    return std::nullopt;
  }
  const Joint& driven = driven_joint(mechanism, static_cast<std::size_t>(*driver));
  const CarriedBody mover = carried_body(mechanism, driven, on_driver.body);
  tracked.driver = *driver;
  tracked.driver_sign = mover.sign;
  tracked.follower = carried_body(mechanism, joint, body);
  tracked.pair = {curve_of(mechanism, on_driver), mover.freedom, curve_of(mechanism, on_follower),
                  tracked.follower.freedom};
  return tracked;
}

std::optional<GroupKind> recognise_one(const Mechanism& mechanism, const BodySet& set,
                                       std::span<const Group> before) {
  const int body = set.bodies.front();
  if (set.joints.size() == 2 && set.contacts.empty() && set.drivers.empty()) {
    const Joint& one = mechanism.joints[set.joints[0]];
    const Joint& two = mechanism.joints[set.joints[1]];
    const bool second_is_slot = two.type == JointType::kSlot;
    const Joint& slot = second_is_slot ? two : one;
    const Joint& other = second_is_slot ? one : two;
    if (slot.type != JointType::kSlot || other.type == JointType::kSlot) {
      return std::nullopt;
    }
    return other.type == JointType::kRevolute ? pin_and_slot(mechanism, other, slot, body)
                                              : slide_and_slot(mechanism, other, slot, body);
  }
  if (set.joints.size() != 1) {
    return std::nullopt;
  }
  const Joint& joint = mechanism.joints[set.joints.front()];
  const bool alone = set.contacts.empty();
  if (alone && set.drivers.size() == 1 && joint.type != JointType::kSlot) {
    return DrivenBody{set.drivers.front(), carried_body(mechanism, joint, body)};
  }
  if (!set.drivers.empty() || joint.type == JointType::kSlot) {
    return std::nullopt;
  }
  if (alone && joint.type == JointType::kRevolute) {
    return IdleBody{known_end(mechanism, joint, body), body, point_on(mechanism, joint, body)};
  }
  if (set.contacts.size() != 1) {
    return std::nullopt;
  }
  const Contact& contact = mechanism.contacts[set.contacts.front()];
  if (auto tracked = contact.by_boundary ? std::nullopt : tracked_pair(mechanism, set, before)) {
    return tracked;
  }
  if (contact.rolling) {
    return std::nullopt;
  }
  return TouchingBody{set.contacts.front(), carried_body(mechanism, joint, body),
                      contact.second.body == body};
}

std::optional<GroupKind> recognise_geared(const Mechanism& mechanism, const BodySet& set) {
  if (set.bodies.size() != 1 || set.joints.size() != 2 || !set.contacts.empty() || !set.drivers.empty()) {
    return std::nullopt;
  }
  const bool first_is_pin = mechanism.joints[set.joints[0]].type == JointType::kRevolute;
  const int gears = set.joints[first_is_pin ? 1 : 0];
  const Joint& pin = mechanism.joints[set.joints[first_is_pin ? 0 : 1]];
  if (pin.type != JointType::kRevolute || !couples_turning(mechanism.joints[gears].type)) {
    return std::nullopt;
  }
  const int body = set.bodies.front();
  return GearedBody{known_end(mechanism, pin, body), body, point_on(mechanism, pin, body), gears};
}

std::optional<GroupKind> recognise_two(const Mechanism& mechanism, const BodySet& set) {
  if (set.joints.size() != 3 || !set.contacts.empty() || !set.drivers.empty()) {
    return std::nullopt;
  }
  int a = set.bodies[0];
  int b = set.bodies[1];
  auto joints = sort_joints(mechanism, set.joints, a, b);
  const auto is_slot = [&](int index) { return mechanism.joints[index].type == JointType::kSlot; };
  if (!joints || std::any_of(set.joints.begin(), set.joints.end(), is_slot)) {
    return std::nullopt;
  }
  const auto turns = [&](int index) { return mechanism.joints[index].type == JointType::kRevolute; };
  if (!turns(joints->on_a) && turns(joints->on_b)) {
    std::swap(a, b);
    std::swap(joints->on_a, joints->on_b);
  }
  const bool pin_in_the_middle = turns(joints->inner);
  if (turns(joints->on_a) && turns(joints->on_b)) {
    return pin_in_the_middle ? rrr_dyad_of(mechanism, *joints, a, b)
                             : std::optional(rpr_dyad_of(mechanism, *joints, a, b));
  }
  if (turns(joints->on_a)) {
    return pin_in_the_middle ? rrp_dyad_of(mechanism, *joints, a, b)
                             : std::optional(rpp_dyad_of(mechanism, *joints, a, b));
  }
  return pin_in_the_middle ? std::optional(prp_dyad_of(mechanism, *joints, a, b)) : std::nullopt;
}

}  // namespace

GroupKind kind_of(const Mechanism& mechanism, const BodySet& set, std::span<const Group> before) {
  std::optional<GroupKind> kind;
  const bool geared = std::any_of(set.joints.begin(), set.joints.end(),
                                  [&](int joint) { return couples_turning(mechanism.joints[joint].type); });
  if (geared) {
    kind = recognise_geared(mechanism, set);
  } else if (set.bodies.size() == 1) {
    kind = recognise_one(mechanism, set, before);
  } else if (set.bodies.size() == 2) {
    kind = recognise_two(mechanism, set);
  }
  return kind ? *std::move(kind) : GroupKind(CoupledBodies{});
}

Group recognise(const Mechanism& mechanism, const BodySet& set, const std::vector<Group>& before) {
  return {set, kind_of(mechanism, set, before)};
}

}  // namespace higherpair
