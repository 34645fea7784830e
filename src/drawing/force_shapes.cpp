#include "higherpair/drawing/scene_maker.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/dynamics/tooth_force.hpp"
#include "higherpair/geometry/pose.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "sketch.hpp"
#include "turn_arrow.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kTurnRadius = 6;  // of the arc of a torque [units]
constexpr double kMostTurn = 1.75 * kPi;
constexpr double kMomentHead = 1.7;  // length of the arc's head [units]
constexpr double kDrawn = 0.02;      // smallest angle of an arc that is drawn [rad]

using Kind = Shape::Kind;

}  // namespace

LargestForces largest_forces(const Mechanism& mechanism, const Reactions& reactions) {
  double largest = 0, torque = 0;
  for (const JointReaction& joint : reactions.joints) {
    if (joint.fx && joint.fy) largest = std::max(largest, std::hypot(*joint.fx, *joint.fy));
  }
  for (const ContactReaction& contact : reactions.contacts) {
    if (contact.force && contact.friction)
      largest = std::max(largest, std::hypot(*contact.force, *contact.friction));
  }
  for (std::size_t i = 0; i < reactions.drivers.size(); ++i) {
    const Joint& joint = mechanism.joints[mechanism.drivers[i].joint];
    double& of_kind = has_angle(joint.type) ? torque : largest;
    of_kind = std::max(of_kind, std::abs(reactions.drivers[i].effort.value_or(0)));
  }
  return {largest, torque};
}

// Arrows of the forces on the second body of each joint or contact, beginning at the point where they act.
void SceneMaker::add_forces(const MotionRow& row, const Reactions& reactions) {
  const auto add_arrow = [&](const std::string& name, int first, int second, const Vector2d& p_W,
                             const Vector2d& force) {
    Shape& arrow = next(Role::kForce, name, Kind::kArrow);
    arrow.text = mechanism_->bodies[first].name + " on " + mechanism_->bodies[second].name;
    const Vector2d from = kMillimetresPerMetre * p_W, to = from + scene_.force_scale * force;
    if (force.norm() > 0) arrow.numbers.assign({from.x(), from.y(), to.x(), to.y()});
  };
  const auto place = [&](const Joint& joint) -> Vector2d {
    if (joint.teeth) {
      return pitch_point(*mechanism_, joint, row.bodies).p_W;
    }
    return Vector2d(row.bodies[joint.second.body].X_WB * point_of(*mechanism_, joint.second));
  };
  for (std::size_t i = 0; i < mechanism_->joints.size(); ++i) {
    const Joint& joint = mechanism_->joints[i];
    const JointReaction& reaction = reactions.joints[i];
    if (couples_turning(joint.type) && !joint.teeth) continue;  // transmits moments only
    add_arrow(joint.name, joint.first.body, joint.second.body, place(joint),
              {reaction.fx.value_or(0), reaction.fy.value_or(0)});
  }
  for (std::size_t i = 0; i < mechanism_->contacts.size(); ++i) {
    const CommonNormal& at = row.contacts[i].at;
    const ContactReaction& reaction = reactions.contacts[i];
    const Contact& contact = mechanism_->contacts[i];
    add_arrow(contact.name, contact.first.body, contact.second.body, at.p_W(),
              reaction.force.value_or(0) * at.n_W + reaction.friction.value_or(0) * perp(at.n_W));
  }
  for (std::size_t i = 0; i < mechanism_->drivers.size(); ++i) {
    add_effort(row, mechanism_->drivers[i], reactions.drivers[i].effort.value_or(0));
  }
}

// A driving force as an arrow along the slide, or a driving torque as an arc around the pin.
void SceneMaker::add_effort(const MotionRow& row, const Driver& driver, double effort) {
  const Joint& joint = mechanism_->joints[driver.joint];
  const std::string name = driver_name(driver);
  const Vector2d p =
      kMillimetresPerMetre * (row.bodies[joint.second.body].X_WB * point_of(*mechanism_, joint.second));
  if (has_angle(joint.type)) {
    const double turn = std::clamp(scene_.torque_scale * effort, -kMostTurn, kMostTurn);
    const bool is_drawn = std::abs(turn) > kDrawn;
    const TurnArrow arrow{p, kTurnRadius * scene_.unit, kPi / 2, turn};
    Shape& arc = next(Role::kForce, name, Kind::kPath);
    if (is_drawn) arc.numbers = arc_of(arrow);
    Shape& head = next(Role::kForce, name, Kind::kPath, true);
    if (is_drawn) head.numbers = head_of(arrow, kMomentHead * scene_.unit);
    return;
  }
  Shape& arrow = next(Role::kForce, name, Kind::kArrow);
  const Vector2d along = row.bodies[joint.first.body].X_WB.R_WB * joint.direction_A;
  const Vector2d to = p + scene_.force_scale * effort * along;
  if (effort != 0) arrow.numbers.assign({p.x(), p.y(), to.x(), to.y()});
}

}  // namespace higherpair
