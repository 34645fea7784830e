#include "recognise.hpp"

#include "dyads_of.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <algorithm>
#include <utility>

namespace higherpair {
namespace {

bool is_grounded(const Joint& joint) {
  return touches(joint, 0) && can_be_driven(joint.type);
}

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

std::optional<GroupKind> tracked_pair(const Mechanism& mechanism, const GroupItems& set,
                                      std::span<const Group> before) {
  const int body = set.bodies.front();
  const Contact& contact = mechanism.contacts[set.contacts.front()];
  TrackedPair tracked;
  tracked.contact = set.contacts.front();
  tracked.driver_is_first = contact.second.body == body;
  const CurveRef& on_driver = tracked.driver_is_first ? contact.first : contact.second;
  const CurveRef& on_follower = tracked.driver_is_first ? contact.second : contact.first;
  const auto driver = grounded_driver(before, on_driver.body);
  const Joint& joint = joint_of(mechanism, set.joints.front());
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

std::optional<GroupKind> recognise_one(const Mechanism& mechanism, const GroupItems& set,
                                       std::span<const Group> before) {
  const int body = set.bodies.front();
  if (set.joints.size() == 2 && set.contacts.empty() && set.drivers.empty()) {
    const Joint& one = joint_of(mechanism, set.joints[0]);
    const Joint& two = joint_of(mechanism, set.joints[1]);
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
  const Joint& joint = joint_of(mechanism, set.joints.front());
  const bool alone = set.contacts.empty();
  if (alone && set.drivers.size() == 1 && joint.type != JointType::kSlot) {
    return DrivenBody{set.drivers.front(), carried_body(mechanism, joint, body)};
  }
  if (!set.drivers.empty() || joint.type == JointType::kSlot) {
    return std::nullopt;
  }
  if (alone && joint.type == JointType::kRevolute) {
    return IdleBody{known_end(mechanism, joint, body), body, point_of(mechanism, end_on(joint, body))};
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

std::optional<GroupKind> recognise_geared(const Mechanism& mechanism, const GroupItems& set) {
  if (set.bodies.size() != 1 || set.joints.size() != 2 || !set.contacts.empty() || !set.drivers.empty()) {
    return std::nullopt;
  }
  const bool first_is_pin = joint_of(mechanism, set.joints[0]).type == JointType::kRevolute;
  const int gears = set.joints[first_is_pin ? 1 : 0];
  const Joint& pin = joint_of(mechanism, set.joints[first_is_pin ? 0 : 1]);
  if (pin.type != JointType::kRevolute || !couples_turning(joint_of(mechanism, gears).type)) {
    return std::nullopt;
  }
  const int body = set.bodies.front();
  return GearedBody{known_end(mechanism, pin, body), body, point_of(mechanism, end_on(pin, body)), gears};
}

std::optional<GroupKind> recognise_two(const Mechanism& mechanism, const GroupItems& set) {
  if (set.joints.size() != 3 || !set.contacts.empty() || !set.drivers.empty()) {
    return std::nullopt;
  }
  int a = set.bodies[0];
  int b = set.bodies[1];
  auto joints = sort_joints(mechanism, set.joints, a, b);
  const auto is_slot = [&](int index) { return joint_of(mechanism, index).type == JointType::kSlot; };
  if (!joints || std::any_of(set.joints.begin(), set.joints.end(), is_slot)) {
    return std::nullopt;
  }
  const auto turns = [&](int index) { return joint_of(mechanism, index).type == JointType::kRevolute; };
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

CarriedBody carried_body(const Mechanism& mechanism, const Joint& joint, int body) {
  const bool carrier_first = joint.second.body == body;
  CarriedBody carried;
  carried.body = body;
  carried.carrier = end_off(joint, body).body;
  OneFreedom& freedom = carried.freedom;
  freedom.turns = joint.type == JointType::kRevolute;
  freedom.p_WO = point_of(mechanism, end_off(joint, body));
  freedom.p_BO = point_of(mechanism, end_on(joint, body));
  if (freedom.turns) {
    carried.sign = carrier_first ? 1 : -1;
    return carried;
  }
  freedom.theta = carrier_first ? joint.relative_angle : -joint.relative_angle;
  freedom.R_WB = Rotation<double>::from_angle(freedom.theta);
  // The line belongs to the joint's first body; if that one is carried, the carrier's point moves along it
  // the opposite way.
  freedom.direction_W = carrier_first ? joint.direction_A : Vector2d(-(freedom.R_WB * joint.direction_A));
  return carried;
}

// If a body is on several joints to ground, like a valve in two guides, it moves alike on each.
std::optional<OneFreedom> grounded_freedom(const Mechanism& mechanism, int body) {
  const auto joint = std::find_if(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& each) {
    return is_grounded(each) && touches(each, body);
  });
  return joint == mechanism.joints.end() ? std::nullopt
                                         : std::optional(carried_body(mechanism, *joint, body).freedom);
}

GroupKind kind_of(const Mechanism& mechanism, const GroupItems& items, std::span<const Group> before) {
  std::optional<GroupKind> kind;
  const bool geared = std::any_of(items.joints.begin(), items.joints.end(), [&](int joint) {
    return couples_turning(joint_of(mechanism, joint).type);
  });
  if (geared) {
    kind = recognise_geared(mechanism, items);
  } else if (items.bodies.size() == 1) {
    kind = recognise_one(mechanism, items, before);
  } else if (items.bodies.size() == 2) {
    kind = recognise_two(mechanism, items);
  }
  return kind ? *std::move(kind) : GroupKind(CoupledBodies{});
}

Group recognise(const Mechanism& mechanism, const BodySet& set, const std::vector<Group>& before) {
  const GroupItems items{set.bodies, set.joints, set.contacts, set.drivers};
  return {set.bodies, set.joints, set.contacts, set.drivers, kind_of(mechanism, items, before)};
}

}  // namespace higherpair
