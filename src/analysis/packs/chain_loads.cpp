#include "chain_loads.hpp"

#include "higherpair/mechanism/description.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/joint_sides.hpp"

namespace higherpair {
namespace {

BodyPoint body_point(const Mechanism& mechanism, const PointRef& ref) {
  return {ref.body, point_of(mechanism, ref)};
}

bool add_spring(const Mechanism& mechanism, const Spring& spring, std::span<const ChainAngle> angles,
                ChainLoads& loads) {
  const ChainLoads::Tension tension{spring.stiffness, spring.free, spring.damping};
  if (!spring.joint) {
    loads.point_springs.push_back(
        {body_point(mechanism, spring.first), body_point(mechanism, spring.second), tension});
    return true;
  }
  const Joint& joint = mechanism.joints[*spring.joint];
  if (joint.type == JointType::kPrismatic || joint.type == JointType::kSlot) {
    loads.line_springs.push_back(
        {{joint.first.body, point_of(mechanism, joint.first), {joint.direction_A.x(), joint.direction_A.y()}},
         body_point(mechanism, joint.second),
         tension});
    return true;
  }
  if (joint.type != JointType::kRevolute) {
    return false;
  }
  const ChainLoads::TurnSpring turn{joint.first.body, joint.second.body, tension};
  if (is_driven(mechanism, *spring.joint)) {
    loads.turn_springs.push_back(turn);
  } else {
    const auto angle = [&](int body) { return angles[body]; };
    loads.pin_springs.push_back({turn, angle(turn.first), angle(turn.second)});
  }
  return true;
}

bool take_loads(const Mechanism& mechanism, std::span<const ChainAngle> angles, ChainLoads& loads) {
  loads.gravity_W = mechanism.gravity_W;
  loads.masses.clear();
  loads.forces.clear();
  loads.point_springs.clear();
  loads.line_springs.clear();
  loads.turn_springs.clear();
  loads.pin_springs.clear();
  for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
    if (const auto& mass = mechanism.bodies[i].mass) {
      loads.masses.push_back({static_cast<int>(i), *mass});
    }
  }
  for (const Load& load : mechanism.loads) {
    loads.forces.push_back({{load.body, load.p_B}, load.force, load.torque, load.frame == LoadFrame::kBody});
  }
  for (const Spring& spring : mechanism.springs) {
    if (!add_spring(mechanism, spring, angles, loads)) {
      return false;
    }
  }
  return true;
}

// The joint of a group between two bodies, as a support of body `held`.
bool take_joint(const Mechanism& mechanism, const Group& group, int held, int other, JointType type,
                ChainSupport& support) {
  for (const int index : group.joints) {
    const Joint& joint = mechanism.joints[index];
    if (joint.type == type && joins(joint, held, other)) {
      support = {index, joint.second.body == held ? 1.0 : -1.0, body_point(mechanism, joint.second)};
      return true;
    }
  }
  return false;
}

class TakeSupports {
public:
  TakeSupports(const Mechanism& mechanism, const Group& group, ChainSupports& supports)
      : mechanism_(mechanism), group_(group), supports_(supports) {}

  bool operator()(const DrivenBody& driven) const {
    const CarriedBody& of = driven.carried;
    return take(of.body, of.carrier, of.freedom.turns ? JointType::kRevolute : JointType::kPrismatic,
                supports_.outer[0]);
  }
  bool operator()(const RrrDyad& dyad) const {
    return take(dyad.link_a, dyad.A.body, JointType::kRevolute, supports_.outer[0]) &&
           take(dyad.link_b, dyad.B.body, JointType::kRevolute, supports_.outer[1]) &&
           take(dyad.link_a, dyad.link_b, JointType::kRevolute, supports_.inner);
  }
  bool operator()(const RrpDyad& dyad) const {
    if (!take(dyad.link, dyad.A.body, JointType::kRevolute, supports_.outer[0])) {
      return false;
    }
    if (!dyad.slider) {
      return take(dyad.link, dyad.line.body, JointType::kSlot, supports_.outer[1]);
    }
    return take(dyad.link, dyad.slider->body, JointType::kRevolute, supports_.inner) &&
           take(dyad.slider->body, dyad.line.body, JointType::kPrismatic, supports_.outer[1]);
  }
  bool operator()(const RprDyad& dyad) const {
    if (!take(dyad.link, dyad.A.body, JointType::kRevolute, supports_.outer[0])) {
      return false;
    }
    if (!dyad.slider) {
      return take(dyad.link, dyad.B.body, JointType::kSlot, supports_.inner);
    }
    return take(dyad.slider->body, dyad.B.body, JointType::kRevolute, supports_.outer[1]) &&
           take(dyad.link, dyad.slider->body, JointType::kPrismatic, supports_.inner);
  }
  bool operator()(const OvalContact& contact) const { return (*this)(contact.touch); }
  bool operator()(const ChainTouch& touch) const {
    return take(touch.body, touch.carrier, touch.freedom.turns ? JointType::kRevolute : JointType::kPrismatic,
                supports_.outer[0]);
  }

private:
  bool take(int held, int other, JointType type, ChainSupport& support) const {
    return take_joint(mechanism_, group_, held, other, type, support);
  }

  const Mechanism& mechanism_;
  const Group& group_;
  ChainSupports& supports_;
};

}  // namespace

bool take_statics(const Mechanism& mechanism, const Plan& plan, std::span<const ChainGroup> groups,
                  std::span<const ChainAngle> angles, ChainStatics& statics) {
  if (!plan.idle_bodies.empty() || mechanism.joints.size() > kMostChainJoints ||
      !take_loads(mechanism, angles, statics.loads)) {
    return false;
  }
  statics.joints = mechanism.joints.size();
  statics.contacts = mechanism.contacts.size();
  statics.supports.assign(groups.size(), {});
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const TakeSupports take(mechanism, plan.groups[g], statics.supports[g]);
    if (!(groups[g].discs ? take(groups[g].discs->touch) : std::visit(take, groups[g].kind))) {
      return false;
    }
  }
  return true;
}

}  // namespace higherpair
