#include "higherpair/analysis/run.hpp"

#include "higherpair/contact/finder.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

// Below this share of the follower's lever ∂gap/∂q is rounding.
constexpr double kSingularShare = 4e-15;

// The follower's coordinate in the poses.
double coordinate_in_pose(const Mechanism& mechanism, const GroundedBody& grounded) {
  const Body& body = mechanism.bodies[static_cast<std::size_t>(grounded.body)];
  if (grounded.freedom.turns) {
    return body.guess_theta;
  }
  const Vector2d at_W =
      body.guess_p_WB + Rotation<double>::from_angle(body.guess_theta) * grounded.freedom.p_BO;
  return (at_W - grounded.freedom.p_WO).dot(grounded.freedom.direction_W);
}

FindResult first_contact(const Mechanism& mechanism, const ContactGroup& group, double u) {
  const double q = coordinate_in_pose(mechanism, group.follower);
  const Approach approach = mechanism.contacts[static_cast<std::size_t>(group.contact)].approach;
  if (approach == Approach::kNearest) {
    return find_nearest_contact(group.pair, u, q);
  }
  const double sense = (approach == Approach::kPositive ? 1 : -1) * group.follower.sign;
  return find_contact(group.pair, u, q, sense > 0 ? 1 : -1, false);
}

std::string explain(FindStatus status, const std::string& contact) {
  const std::string name = "contacts." + contact + ": ";
  switch (status) {
    case FindStatus::kOverlapAtStart:
      return name +
             "the two bodies overlap at the first driver position with the follower in its pose; move the "
             "pose "
             "away from the driver, or use approach = \"nearest\"";
    case FindStatus::kUnbounded:
      return name + "neither body is bounded, so that no safe step towards the contact exists";
    case FindStatus::kNoContact:
    case FindStatus::kFound:
      break;
  }
  return name +
         "the two bodies do not touch at the first driver position, wherever the follower stands; change "
         "driver.start or the pose of the follower";
}

void add_contact(const Run& run, double u_dot, double u_ddot, MotionRow& row) {
  const ContactGroup& group = *run.plan.group;
  const ContactPosition& at = run.track->at;
  row.contact = at;
  row.normal_angle = run.track->phi;
  row.residual = (at.p2_W - at.p1_W).norm();
  const double lever = velocity_per_q(group.pair.motion2, at.p2_W).norm();
  const bool singular = std::abs(at.gap_q) <= kSingularShare * std::max(lever, 1e-300);
  const double q_dot = singular ? 0 : at.dq * u_dot;
  const double q_ddot = singular ? 0 : at.d2q * u_dot * u_dot + at.dq * u_ddot;
  row.sliding = at.sliding * u_dot;
  row.bodies[static_cast<std::size_t>(group.follower.body)] =
      motion_at(group.follower.freedom, at.q, q_dot, q_ddot);
  row.joint_position = group.follower.sign * at.q;
  row.joint_velocity = group.follower.sign * q_dot;
  row.joint_acceleration = group.follower.sign * q_ddot;
  row.status = singular ? RowStatus::kSingular : RowStatus::kOk;
  if (!(row.residual <= run.tolerance * run.plan.size)) {
    row.status = RowStatus::kNotConverged;
  }
}

}  // namespace

tl::expected<Run, std::string> start_run(const Mechanism& mechanism, double driver, double tolerance) {
  auto plan = make_plan(mechanism);
  if (!plan) {
    return tl::unexpected(plan.error());
  }
  Run run{mechanism, std::move(*plan), std::nullopt, tolerance};
  if (!run.plan.group) {
    return run;
  }
  const ContactGroup& group = *run.plan.group;
  const FindResult found = first_contact(mechanism, group, run.plan.driver.sign * driver);
  if (found.status != FindStatus::kFound) {
    return tl::unexpected(
        explain(found.status, mechanism.contacts[static_cast<std::size_t>(group.contact)].name));
  }
  run.track = start_track(group.pair, found.at, found.branch);
  return run;
}

RunStep move_to(Run& run, double position, double velocity, double acceleration) {
  RunStep step;
  const GroundedBody& driver = run.plan.driver;
  const double u = driver.sign * position;
  step.row.bodies.resize(run.mechanism.bodies.size());
  step.row.bodies[static_cast<std::size_t>(driver.body)] =
      motion_at(driver.freedom, u, driver.sign * velocity, driver.sign * acceleration);
  step.row.status = RowStatus::kOk;
  if (!run.track) {
    return step;
  }
  const TrackResult result = follow_to(*run.track, u);
  if (result.limit) {
    step.limit = LimitEvent{driver.sign * result.limit->u};
  }
  if (result.status == TrackStatus::kOk) {
    add_contact(run, driver.sign * velocity, driver.sign * acceleration, step.row);
  } else {
    step.row.status = RowStatus::kNotAssemblable;
  }
  return step;
}

}  // namespace higherpair
