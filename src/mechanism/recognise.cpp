#include "recognise.hpp"

#include "higherpair/mechanism/joint_motion.hpp"

#include <algorithm>
#include <utility>

namespace higherpair {
namespace {

const Joint& joint_of(const Mechanism& mechanism, int index) {
  return mechanism.joints[static_cast<std::size_t>(index)];
}

bool touches(const Joint& joint, int body) {
  return joint.first.body == body || joint.second.body == body;
}

const PointRef& end_on(const Joint& joint, int body) {
  return joint.first.body == body ? joint.first : joint.second;
}

const PointRef& end_off(const Joint& joint, int body) {
  return joint.first.body == body ? joint.second : joint.first;
}

BodyPoint known_end(const Mechanism& mechanism, const Joint& joint, int body) {
  const PointRef& end = end_off(joint, body);
  return {end.body, point_of(mechanism, end)};
}

Rotation<double> direction_of(const Vector2d& v) {
  const double length = v.norm();
  return {v.x() / length, v.y() / length};
}

bool is_grounded(const Joint& joint) {
  return touches(joint, 0) && can_be_driven(joint.type);
}

// The driver that moves a body against ground, if one does.
std::optional<int> grounded_driver(const std::vector<Group>& before, int body) {
  for (const Group& group : before) {
    const auto* driven = std::get_if<DrivenBody>(&group.kind);
    if (driven != nullptr && driven->carried.body == body && driven->carried.carrier == 0) {
      return driven->driver;
    }
  }
  return std::nullopt;
}

std::optional<GroupKind> tracked_pair(const Mechanism& mechanism, const BodySet& set,
                                      const std::vector<Group>& before) {
  const int body = set.bodies.front();
  const Contact& contact = mechanism.contacts[static_cast<std::size_t>(set.contacts.front())];
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
  const Joint& driven = joint_of(mechanism, mechanism.drivers[static_cast<std::size_t>(*driver)].joint);
  const CarriedBody mover = carried_body(mechanism, driven, on_driver.body);
  tracked.driver = *driver;
  tracked.driver_sign = mover.sign;
  tracked.follower = carried_body(mechanism, joint, body);
  tracked.pair = {curve_of(mechanism, on_driver), mover.freedom, curve_of(mechanism, on_follower),
                  tracked.follower.freedom};
  return tracked;
}

// |AB| depends on one angle only if a pin joins the bodies of A and B.
void add_loop(const Mechanism& mechanism, RrrDyad& dyad) {
  if (dyad.A.body == dyad.B.body) {
    return;
  }
  for (const Joint& joint : mechanism.joints) {
    if (joint.type != JointType::kRevolute || !touches(joint, dyad.A.body) || !touches(joint, dyad.B.body)) {
      continue;
    }
    const Vector2d on_A = point_of(mechanism, end_on(joint, dyad.A.body));
    const Vector2d on_B = point_of(mechanism, end_on(joint, dyad.B.body));
    const Vector2d arm = dyad.A.p_B - on_A;
    const Vector2d ground = dyad.B.p_B - on_B;
    if (arm.norm() == 0 || ground.norm() == 0) {
      continue;
    }
    dyad.loop = make_four_bar_loop(ground.norm(), arm.norm(), dyad.length_a, dyad.length_b);
    dyad.arm = {dyad.A.body, on_A, direction_of(arm)};
    dyad.ground = {dyad.B.body, on_B, direction_of(ground)};
    return;
  }
}

struct OuterJoints {
  int inner = 0;
  int on_a = 0;
  int on_b = 0;
};

// Of three joints of bodies a and b the one between them and the two to known bodies.
std::optional<OuterJoints> sort_joints(const Mechanism& mechanism, const std::vector<int>& joints, int a,
                                       int b) {
  OuterJoints sorted{-1, -1, -1};
  for (const int index : joints) {
    const Joint& joint = joint_of(mechanism, index);
    const bool on_a = touches(joint, a);
    const bool on_b = touches(joint, b);
    int& place = on_a && on_b ? sorted.inner : on_a ? sorted.on_a : sorted.on_b;
    if (place >= 0) {
      return std::nullopt;
    }
    place = index;
  }
  return sorted;
}

std::optional<GroupKind> rrr_dyad_of(const Mechanism& mechanism, const OuterJoints& joints, int a, int b) {
  const Joint& inner = joint_of(mechanism, joints.inner);
  const Joint& on_a = joint_of(mechanism, joints.on_a);
  const Joint& on_b = joint_of(mechanism, joints.on_b);
  RrrDyad dyad;
  dyad.A = known_end(mechanism, on_a, a);
  dyad.B = known_end(mechanism, on_b, b);
  dyad.link_a = a;
  dyad.link_b = b;
  dyad.a_pA = point_of(mechanism, end_on(on_a, a));
  dyad.a_pC = point_of(mechanism, end_on(inner, a));
  dyad.b_pB = point_of(mechanism, end_on(on_b, b));
  dyad.b_pC = point_of(mechanism, end_on(inner, b));
  dyad.length_a = (dyad.a_pC - dyad.a_pA).norm();
  dyad.length_b = (dyad.b_pC - dyad.b_pB).norm();
  if (dyad.length_a == 0 || dyad.length_b == 0) {
    return std::nullopt;
  }
  dyad.along_a = direction_of(dyad.a_pC - dyad.a_pA);
  dyad.along_b = direction_of(dyad.b_pC - dyad.b_pB);
  add_loop(mechanism, dyad);
  return dyad;
}

// The line fixed in `base` along which the point p_M of the body at the other end of a slide runs, and how
// that body stands on it.
struct Guide {
  BodyLine line;
  Rider rider;
};

Guide guide_of(const Mechanism& mechanism, const Joint& joint, int moving, const Vector2d& p_M) {
  const PointRef& on_base = end_off(joint, moving);
  const PointRef& on_moving = end_on(joint, moving);
  const bool base_first = joint.second.body == moving;
  const double relative = base_first ? joint.relative_angle : -joint.relative_angle;
  const Rotation<double> R = Rotation<double>::from_angle(relative);
  const Vector2d d = base_first ? joint.direction_A : Vector2d(R * joint.direction_A);
  Guide guide;
  guide.line.body = on_base.body;
  guide.line.p_B = point_of(mechanism, on_base) + R * Vector2d(p_M - point_of(mechanism, on_moving));
  guide.line.u_B = {d.x(), d.y()};
  guide.rider = {moving, on_base.body, p_M, relative, R};
  return guide;
}

// A link pinned at A by the joint `pin`.
RrpDyad link_to_line(const Mechanism& mechanism, const Joint& pin, int link, const Vector2d& pC) {
  RrpDyad dyad;
  dyad.A = known_end(mechanism, pin, link);
  dyad.link = link;
  dyad.pA = point_of(mechanism, end_on(pin, link));
  dyad.pC = pC;
  dyad.length = (pC - dyad.pA).norm();
  if (dyad.length > 0) {
    dyad.along = direction_of(pC - dyad.pA);
  }
  return dyad;
}

RprDyad link_with_line(const Mechanism& mechanism, const Joint& pin, int link, const BodyPoint& B,
                       const BodyLine& line) {
  RprDyad dyad;
  dyad.A = known_end(mechanism, pin, link);
  dyad.B = B;
  dyad.link = link;
  dyad.pA = point_of(mechanism, end_on(pin, link));
  dyad.line = line;
  return dyad;
}

// A body on a pin and a slot: the slot is on the known body, or on the body itself.
std::optional<GroupKind> pin_and_slot(const Mechanism& mechanism, const Joint& pin, const Joint& slot,
                                      int body) {
  if (slot.second.body == body) {
    RrpDyad dyad = link_to_line(mechanism, pin, body, point_of(mechanism, slot.second));
    dyad.line = {
        slot.first.body, point_of(mechanism, slot.first), {slot.direction_A.x(), slot.direction_A.y()}};
    return dyad.length > 0 ? std::optional<GroupKind>(dyad) : std::nullopt;
  }
  const BodyLine line = {body, point_of(mechanism, slot.first), {slot.direction_A.x(), slot.direction_A.y()}};
  return link_with_line(mechanism, pin, body, known_end(mechanism, slot, body), line);
}

// A body on a slide and a slot (a yoke): the slot is on the known body, or on the body itself.
GroupKind slide_and_slot(const Mechanism& mechanism, const Joint& slide, const Joint& slot, int body) {
  const Guide guide = guide_of(mechanism, slide, body, point_of(mechanism, end_on(slot, body)));
  SlideDyad dyad;
  dyad.first = guide.line;
  dyad.riders = {guide.rider};
  const Rotation<double> along{slot.direction_A.x(), slot.direction_A.y()};
  if (slot.second.body == body) {
    dyad.second = {slot.first.body, point_of(mechanism, slot.first), along};
  } else {
    dyad.pin = known_end(mechanism, slot, body);
    dyad.second = {guide.line.body, Vector2d::Zero(), guide.rider.relative * along};
  }
  return dyad;
}

// Of two bodies a carries the pin to a known body, b the slide to one, and a pin joins them.
std::optional<GroupKind> rrp_dyad_of(const Mechanism& mechanism, const OuterJoints& joints, int a, int b) {
  const Joint& inner = joint_of(mechanism, joints.inner);
  RrpDyad dyad =
      link_to_line(mechanism, joint_of(mechanism, joints.on_a), a, point_of(mechanism, end_on(inner, a)));
  const Guide guide =
      guide_of(mechanism, joint_of(mechanism, joints.on_b), b, point_of(mechanism, end_on(inner, b)));
  dyad.line = guide.line;
  dyad.slider = guide.rider;
  return dyad.length > 0 ? std::optional<GroupKind>(dyad) : std::nullopt;
}

// Both bodies are pinned to known ones and slide on each other.
GroupKind rpr_dyad_of(const Mechanism& mechanism, const OuterJoints& joints, int a, int b) {
  const Joint& on_b = joint_of(mechanism, joints.on_b);
  const Guide guide =
      guide_of(mechanism, joint_of(mechanism, joints.inner), b, point_of(mechanism, end_on(on_b, b)));
  RprDyad dyad = link_with_line(mechanism, joint_of(mechanism, joints.on_a), a, known_end(mechanism, on_b, b),
                                guide.line);
  dyad.slider = guide.rider;
  return dyad;
}

// Both bodies slide on known ones and a pin joins them.
GroupKind prp_dyad_of(const Mechanism& mechanism, const OuterJoints& joints, int a, int b) {
  const Joint& inner = joint_of(mechanism, joints.inner);
  const Guide on_a =
      guide_of(mechanism, joint_of(mechanism, joints.on_a), a, point_of(mechanism, end_on(inner, a)));
  const Guide on_b =
      guide_of(mechanism, joint_of(mechanism, joints.on_b), b, point_of(mechanism, end_on(inner, b)));
  SlideDyad dyad;
  dyad.first = on_a.line;
  dyad.second = on_b.line;
  dyad.riders = {on_a.rider, on_b.rider};
  return dyad;
}

// a is pinned at A and slides on b, which slides on a known body.
GroupKind rpp_dyad_of(const Mechanism& mechanism, const OuterJoints& joints, int a, int b) {
  const Joint& on_a = joint_of(mechanism, joints.on_a);
  const Guide inner =
      guide_of(mechanism, joint_of(mechanism, joints.inner), a, point_of(mechanism, end_on(on_a, a)));
  // C: the point of b on the line along which A runs, seen from b.
  const Guide outer = guide_of(mechanism, joint_of(mechanism, joints.on_b), b, inner.line.p_B);
  SlideDyad dyad;
  dyad.first = outer.line;
  dyad.second = {outer.line.body, Vector2d::Zero(), outer.rider.relative * inner.line.u_B};
  dyad.pin = known_end(mechanism, on_a, a);
  dyad.pinned = Rider{a, outer.line.body, point_of(mechanism, end_on(on_a, a)),
                      outer.rider.relative_angle + inner.rider.relative_angle,
                      outer.rider.relative * inner.rider.relative};
  dyad.riders = {outer.rider};
  return dyad;
}

std::optional<GroupKind> recognise_one(const Mechanism& mechanism, const BodySet& set,
                                       const std::vector<Group>& before) {
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
  if (auto tracked = tracked_pair(mechanism, set, before)) {
    return tracked;
  }
  const Contact& contact = mechanism.contacts[static_cast<std::size_t>(set.contacts.front())];
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
  const bool first_is_pin = joint_of(mechanism, set.joints[0]).type == JointType::kRevolute;
  const int gears = set.joints[first_is_pin ? 1 : 0];
  const Joint& pin = joint_of(mechanism, set.joints[first_is_pin ? 0 : 1]);
  if (pin.type != JointType::kRevolute || !couples_turning(joint_of(mechanism, gears).type)) {
    return std::nullopt;
  }
  const int body = set.bodies.front();
  return GearedBody{known_end(mechanism, pin, body), body, point_of(mechanism, end_on(pin, body)), gears};
}

std::optional<GroupKind> recognise_two(const Mechanism& mechanism, const BodySet& set) {
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
  // The line belongs to the first body; if that one is carried, the carrier's point runs along it the other
  // way.
  freedom.direction_W = carrier_first ? joint.direction_A : Vector2d(-(freedom.R_WB * joint.direction_A));
  return carried;
}

std::optional<OneFreedom> grounded_freedom(const Mechanism& mechanism, int body) {
  std::optional<OneFreedom> freedom;
  for (const Joint& joint : mechanism.joints) {
    if (is_grounded(joint) && touches(joint, body)) {
      if (freedom) {
        return std::nullopt;
      }
      freedom = carried_body(mechanism, joint, body).freedom;
    }
  }
  return freedom;
}

Group recognise(const Mechanism& mechanism, const BodySet& set, const std::vector<Group>& before) {
  Group group{set.bodies, set.joints, set.contacts, set.drivers, CoupledBodies{}};
  std::optional<GroupKind> kind;
  const bool geared = std::any_of(set.joints.begin(), set.joints.end(), [&](int joint) {
    return couples_turning(joint_of(mechanism, joint).type);
  });
  if (geared) {
    kind = recognise_geared(mechanism, set);
  } else if (set.bodies.size() == 1) {
    kind = recognise_one(mechanism, set, before);
  } else if (set.bodies.size() == 2) {
    kind = recognise_two(mechanism, set);
  }
  if (kind) {
    group.kind = *std::move(kind);
  }
  return group;
}

}  // namespace higherpair
