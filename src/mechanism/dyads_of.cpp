#include "dyads_of.hpp"

namespace higherpair {
namespace {

// Recognises a four-bar loop: |AB| depends on a single angle if a pin joins the bodies of A and B.
void add_loop(const Mechanism& mechanism, RrrDyad& dyad) {
  if (dyad.A.body == dyad.B.body) {
    return;
  }
  for (const Joint& joint : mechanism.joints) {
    if (joint.type != JointType::kRevolute || !joins(joint, dyad.A.body, dyad.B.body)) {
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

// The line fixed in the base along which the point p_M of a body on a slide moves, and how that body rides on
// the base.
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

// A link pinned at A by the joint `pin`, without its line.
RrpDyad link_to_line(const Mechanism& mechanism, const Joint& pin, int link, const Vector2d& pC) {
  RrpDyad dyad;
  dyad.A = known_end(mechanism, pin, link);
  dyad.link = link;
  dyad.pA = point_on(mechanism, pin, link);
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
  dyad.pA = point_on(mechanism, pin, link);
  dyad.line = line;
  return dyad;
}

}  // namespace

std::optional<OuterJoints> sort_joints(const Mechanism& mechanism, std::span<const int> joints, int a,
                                       int b) {
  OuterJoints sorted{-1, -1, -1};
  for (const int index : joints) {
    const Joint& joint = mechanism.joints[index];
    const bool on_a = has_end_on(joint, a);
    const bool on_b = has_end_on(joint, b);
    int& place = on_a && on_b ? sorted.inner : on_a ? sorted.on_a : sorted.on_b;
    if (place >= 0) {
      return std::nullopt;
    }
    place = index;
  }
  return sorted;
}

std::optional<GroupKind> rrr_dyad_of(const Mechanism& mechanism, const OuterJoints& joints, int a, int b) {
  const Joint& inner = mechanism.joints[joints.inner];
  const Joint& on_a = mechanism.joints[joints.on_a];
  const Joint& on_b = mechanism.joints[joints.on_b];
  RrrDyad dyad;
  dyad.A = known_end(mechanism, on_a, a);
  dyad.B = known_end(mechanism, on_b, b);
  dyad.link_a = a;
  dyad.link_b = b;
  dyad.pin_C = joints.inner;
  dyad.a_pA = point_on(mechanism, on_a, a);
  dyad.a_pC = point_on(mechanism, inner, a);
  dyad.b_pB = point_on(mechanism, on_b, b);
  dyad.b_pC = point_on(mechanism, inner, b);
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

GroupKind slide_and_slot(const Mechanism& mechanism, const Joint& slide, const Joint& slot, int body) {
  const Guide guide = guide_of(mechanism, slide, body, point_on(mechanism, slot, body));
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

std::optional<GroupKind> rrp_dyad_of(const Mechanism& mechanism, const OuterJoints& joints, int a, int b) {
  const Joint& inner = mechanism.joints[joints.inner];
  RrpDyad dyad = link_to_line(mechanism, mechanism.joints[joints.on_a], a, point_on(mechanism, inner, a));
  const Guide guide = guide_of(mechanism, mechanism.joints[joints.on_b], b, point_on(mechanism, inner, b));
  dyad.line = guide.line;
  dyad.slider = guide.rider;
  return dyad.length > 0 ? std::optional<GroupKind>(dyad) : std::nullopt;
}

GroupKind rpr_dyad_of(const Mechanism& mechanism, const OuterJoints& joints, int a, int b) {
  const Joint& on_b = mechanism.joints[joints.on_b];
  const Guide guide = guide_of(mechanism, mechanism.joints[joints.inner], b, point_on(mechanism, on_b, b));
  RprDyad dyad =
      link_with_line(mechanism, mechanism.joints[joints.on_a], a, known_end(mechanism, on_b, b), guide.line);
  dyad.slider = guide.rider;
  return dyad;
}

GroupKind prp_dyad_of(const Mechanism& mechanism, const OuterJoints& joints, int a, int b) {
  const Joint& inner = mechanism.joints[joints.inner];
  const Guide on_a = guide_of(mechanism, mechanism.joints[joints.on_a], a, point_on(mechanism, inner, a));
  const Guide on_b = guide_of(mechanism, mechanism.joints[joints.on_b], b, point_on(mechanism, inner, b));
  SlideDyad dyad;
  dyad.first = on_a.line;
  dyad.second = on_b.line;
  dyad.riders = {on_a.rider, on_b.rider};
  return dyad;
}

GroupKind rpp_dyad_of(const Mechanism& mechanism, const OuterJoints& joints, int a, int b) {
  const Joint& on_a = mechanism.joints[joints.on_a];
  const Guide inner = guide_of(mechanism, mechanism.joints[joints.inner], a, point_on(mechanism, on_a, a));
  // C is the point of b on the line along which A moves relative to b.
  const Guide outer = guide_of(mechanism, mechanism.joints[joints.on_b], b, inner.line.p_B);
  SlideDyad dyad;
  dyad.first = outer.line;
  dyad.second = {outer.line.body, Vector2d::Zero(), outer.rider.relative * inner.line.u_B};
  dyad.pin = known_end(mechanism, on_a, a);
  dyad.pinned = Rider{a, outer.line.body, point_on(mechanism, on_a, a),
                      outer.rider.relative_angle + inner.rider.relative_angle,
                      outer.rider.relative * inner.rider.relative};
  dyad.riders = {outer.rider};
  return dyad;
}

}  // namespace higherpair
