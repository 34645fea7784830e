#include "higherpair/dynamics/inverse_dynamics.hpp"

#include "higherpair/analysis/unit_motion.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "tolerances.hpp"

#include <algorithm>

namespace higherpair {

bool Reactions::opens() const {
  return std::any_of(contacts.begin(), contacts.end(), [](const ContactReaction& c) { return c.pulls; });
}

InverseDynamics::InverseDynamics(const Run& run)
    : statics_(run), wrenches_(run.mechanism().bodies.size()), left_(wrenches_) {
  reactions_.joints.resize(run.mechanism().joints.size());
  reactions_.contacts.resize(run.mechanism().contacts.size());
  reactions_.drivers.resize(run.mechanism().drivers.size());
}

const Reactions& InverseDynamics::solve(const Run& run) {
  const MotionRow& row = run.row;
  reactions_.defined = row.status != RowStatus::kNotAssemblable && row.all_rates;
  if (reactions_.defined) {
    std::fill(wrenches_.begin(), wrenches_.end(), Wrench(Wrench::Zero()));
    add_applied(run.mechanism(), row.bodies, wrenches_);
    add_inertia(run.mechanism(), row.bodies, wrenches_);
    left_ = wrenches_;
    statics_.set_row(run);
    reactions_.defined = statics_.balance(left_);
    if (reactions_.defined && statics_.choose_flanks(run.mechanism())) {
      left_ = wrenches_;
      statics_.set_row(run);
      reactions_.defined = statics_.balance(left_);
    }
  }
  if (!reactions_.defined) {
    std::fill(reactions_.joints.begin(), reactions_.joints.end(), JointReaction());
    std::fill(reactions_.contacts.begin(), reactions_.contacts.end(), ContactReaction());
    std::fill(reactions_.drivers.begin(), reactions_.drivers.end(), DriverEffort());
    return reactions_;
  }
  read_joints(run);
  read_contacts(run);
  read_efforts(run);
  add_virtual_power(run);
  return reactions_;
}

std::optional<double> InverseDynamics::determined(std::size_t row, double factor) const {
  // A component that the condition does not have is 0, whatever the multiplier.
  if (factor == 0) {
    return 0.0;
  }
  return statics_.is_determined(row) ? std::optional(factor * statics_.multiplier(row)) : std::nullopt;
}

void InverseDynamics::read_joints(const Run& run) {
  for (std::size_t i = 0; i < reactions_.joints.size(); ++i) {
    const std::size_t first = statics_.joint_row(i);
    const JointType type = run.mechanism().joints[i].type;
    const Eigen::Vector3d& along = statics_.row(first).coefficient[1];
    JointReaction& reaction = reactions_.joints[i];
    reaction.fx = determined(first, along.x());
    reaction.fy = type == JointType::kRevolute ? determined(first + 1, 1) : determined(first, along.y());
    if (type == JointType::kPrismatic) {
      reaction.moment = determined(first + 1, statics_.size());
    } else if (couples_turning(type)) {
      reaction.moment = determined(first, statics_.size());
    }
  }
}

void InverseDynamics::read_contacts(const Run& run) {
  const double largest = statics_.largest_multiplier();
  for (std::size_t i = 0; i < reactions_.contacts.size(); ++i) {
    const std::size_t first = statics_.contact_row(i);
    ContactReaction& reaction = reactions_.contacts[i];
    if (!run.row.contacts[i].touches) {
      reaction = {0.0, 0.0, false};
      continue;
    }
    reaction.force = determined(first, 1);
    reaction.friction = run.mechanism().contacts[i].rolling ? determined(first + 1, 1) : 0.0;
    reaction.pulls = !run.mechanism().contacts[i].both_sides && reaction.force &&
                     *reaction.force < -kMultiplierRounding * largest;
  }
}

void InverseDynamics::read_efforts(const Run& run) {
  for (std::size_t i = 0; i < reactions_.drivers.size(); ++i) {
    const bool turns = driven_joint(run.mechanism(), i).type == JointType::kRevolute;
    reactions_.drivers[i].effort = determined(statics_.driver_row(i), turns ? statics_.size() : 1);
  }
}

// What holds idle bodies does no work: they do not turn.
double InverseDynamics::power(const std::vector<BodyMotion>& bodies) const {
  double sum = 0;
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const BodyMotion& body = bodies[i];
    sum += wrenches_[i].dot(Eigen::Vector3d(body.v_WB.x(), body.v_WB.y(), body.omega));
  }
  return sum;
}

// For a displaced row there is no motion for a unit velocity; by the principle of virtual power the effort is
// the same.
void InverseDynamics::add_virtual_power(const Run& run) {
  for (std::size_t i = 0; i < reactions_.drivers.size(); ++i) {
    DriverEffort& driver = reactions_.drivers[i];
    driver.by_power = run.is_displaced ? driver.effort : std::optional(-power(unit_motion(run, i, unit_)));
  }
}

}  // namespace higherpair
