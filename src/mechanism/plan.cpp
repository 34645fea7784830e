#include "higherpair/mechanism/plan.hpp"

#include <algorithm>
#include <cstddef>

namespace higherpair {
namespace {

const Body& body_of(const Mechanism& mechanism, int index) {
  return mechanism.bodies[static_cast<std::size_t>(index)];
}

Vector2d point_of(const Mechanism& mechanism, const PointRef& ref) {
  return body_of(mechanism, ref.body).points[static_cast<std::size_t>(ref.point)].p_B;
}

const Curve& curve_of(const Mechanism& mechanism, const CurveRef& ref) {
  return body_of(mechanism, ref.body).curves[static_cast<std::size_t>(ref.curve)].curve;
}

// A revolute or prismatic joint between a body and ground, whichever is named first.
GroundedBody grounded_body(const Mechanism& mechanism, int joint_index) {
  const Joint& joint = mechanism.joints[static_cast<std::size_t>(joint_index)];
  const bool ground_first = joint.first.body == 0;
  const PointRef& moving = ground_first ? joint.second : joint.first;
  GroundedBody grounded;
  grounded.body = moving.body;
  grounded.joint = joint_index;
  OneFreedom& freedom = grounded.freedom;
  freedom.turns = joint.type == JointType::kRevolute;
  freedom.p_WO = point_of(mechanism, ground_first ? joint.first : joint.second);
  freedom.p_BO = point_of(mechanism, moving);
  if (freedom.turns) {
    grounded.sign = ground_first ? 1 : -1;
    return grounded;
  }
  freedom.theta = ground_first ? joint.relative_angle : -joint.relative_angle;
  freedom.R_WB = Rotation<double>::from_angle(freedom.theta);
  // The line belongs to the first body; if that one moves, ground's point runs along it the other way.
  freedom.direction_W = ground_first ? joint.direction_A : Vector2d(-(freedom.R_WB * joint.direction_A));
  return grounded;
}

bool is_grounded(const Joint& joint) {
  return (joint.first.body == 0 || joint.second.body == 0) && joint.type != JointType::kSlot;
}

tl::unexpected<std::string> refuse(const std::string& reason) {
  return tl::unexpected(
      "only a driver and one follower, each on its own revolute or prismatic joint to ground and "
      "touching in one contact, can be solved: " +
      reason);
}

double size_of(const Mechanism& mechanism) {
  std::vector<Vector2d> points;
  const auto place = [&](const Body& body, const Vector2d& p_B) {
    points.push_back(Rotation<double>::from_angle(body.guess_theta) * p_B + body.guess_p_WB);
  };
  for (const Joint& joint : mechanism.joints) {
    place(body_of(mechanism, joint.first.body), point_of(mechanism, joint.first));
    place(body_of(mechanism, joint.second.body), point_of(mechanism, joint.second));
  }
  for (const Contact& contact : mechanism.contacts) {
    for (const CurveRef& ref : {contact.first, contact.second}) {
      const Curve& curve = curve_of(mechanism, ref);
      place(body_of(mechanism, ref.body), curve.vertex_B);
      if (is_conic(curve) && curve.q > 0) {
        place(body_of(mechanism, ref.body), center(curve));
      }
    }
  }
  double size = 0;
  for (const Vector2d& a : points) {
    for (const Vector2d& b : points) {
      size = std::max(size, (a - b).norm());
    }
  }
  return size;
}

tl::expected<ContactGroup, std::string> contact_group(const Mechanism& mechanism,
                                                      const GroundedBody& driver) {
  if (mechanism.contacts.size() != 1) {
    return refuse("there is not exactly one contact");
  }
  const Contact& contact = mechanism.contacts.front();
  ContactGroup group;
  group.driver_is_first = contact.first.body == driver.body;
  const CurveRef& on_driver = group.driver_is_first ? contact.first : contact.second;
  const CurveRef& on_follower = group.driver_is_first ? contact.second : contact.first;
  if (on_driver.body != driver.body) {
    return refuse("contacts." + contact.name + " does not touch the driven body");
  }
  int follower_joint = -1;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (static_cast<int>(i) == driver.joint) {
      continue;
    }
    if (follower_joint >= 0) {
      return refuse("joints." + joint.name + " is one joint too many");
    }
    if (!is_grounded(joint)) {
      return refuse("joints." + joint.name + " is no revolute or prismatic joint to ground");
    }
    follower_joint = static_cast<int>(i);
  }
  if (follower_joint < 0) {
    return refuse("the follower has no joint to ground");
  }
  group.follower = grounded_body(mechanism, follower_joint);
  if (group.follower.body != on_follower.body) {
    return refuse("contacts." + contact.name + " does not touch the body on joints." +
                  mechanism.joints[static_cast<std::size_t>(follower_joint)].name);
  }
  group.pair = {curve_of(mechanism, on_driver), driver.freedom, curve_of(mechanism, on_follower),
                group.follower.freedom};
  return group;
}

}  // namespace

tl::expected<Plan, std::string> make_plan(const Mechanism& mechanism) {
  if (mechanism.drivers.size() != 1) {
    return refuse("there is not exactly one driver");
  }
  const int joint_index = mechanism.drivers.front().joint;
  const Joint& joint = mechanism.joints[static_cast<std::size_t>(joint_index)];
  if (!is_grounded(joint)) {
    return refuse("the driven joint joints." + joint.name + " does not go to ground");
  }
  Plan plan;
  plan.driver = grounded_body(mechanism, joint_index);
  plan.size = size_of(mechanism);
  const bool alone =
      mechanism.bodies.size() == 2 && mechanism.contacts.empty() && mechanism.joints.size() == 1;
  if (alone) {
    return plan;
  }
  if (mechanism.bodies.size() != 3) {
    return refuse("there are " + std::to_string(mechanism.bodies.size() - 1) + " moving bodies");
  }
  auto group = contact_group(mechanism, plan.driver);
  if (!group) {
    return tl::unexpected(group.error());
  }
  plan.group = std::move(*group);
  return plan;
}

}  // namespace higherpair
