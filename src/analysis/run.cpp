#include "higherpair/analysis/run.hpp"

#include "higherpair/contact/finder.hpp"
#include "higherpair/contact/separation.hpp"

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

void add_contact(const Run& run, const ContactPosition& at, double phi, double u_dot, double u_ddot,
                 MotionRow& row) {
  const ContactGroup& group = *run.plan.group;
  row.contact = at;
  row.normal_angle = phi;
  row.residual = std::max(row.residual, (at.p2_W - at.p1_W).norm());
  const double lever = velocity_per_q(group.pair.motion2, at.p2_W).norm();
  const bool singular = !run.rolling && std::abs(at.gap_q) <= kSingularShare * std::max(lever, 1e-300);
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

// Sets up the rolling contact near the pose (or near the slipping contact that was found); says why it cannot
// roll.
std::optional<std::string> start_rolling_contact(Run& run, double driver, const FindResult& found) {
  const ContactGroup& group = *run.plan.group;
  const double u = run.plan.driver.sign * driver;
  const double q = coordinate_in_pose(run.mechanism, group.follower);
  const Pose<double> X_W1 = pose_at(group.pair.motion1, u);
  const Pose<double> X_W2 = pose_at(group.pair.motion2, q);
  const Separation here = separation(group.pair.curve1, X_W1, group.pair.curve2, X_W2, 1e-6 * run.plan.size);
  RollingTrack track;
  const RollingResult start = start_rolling(track, group.pair, u, q, here.n_W);
  if (start.converged && start.mismatch <= run.tolerance * run.plan.size) {
    run.rolling = track;
    return std::nullopt;
  }
  const std::string name = run.mechanism.contacts[static_cast<std::size_t>(group.contact)].name;
  if (found.status != FindStatus::kFound) {
    return explain(found.status, name);
  }
  return "contacts." + name + ": this pair cannot roll: already at the first driver position it slips by " +
         std::to_string(std::abs(found.at.sliding)) +
         (group.pair.motion1.turns ? " m for each radian" : " m for each metre") +
         " of the driver; set rolling = false, or choose curves and joints whose contact point stays at the "
         "instant centre";
}

}  // namespace

tl::expected<Run, std::string> start_run(const Mechanism& mechanism, double driver, double tolerance) {
  auto plan = make_plan(mechanism);
  if (!plan) {
    return tl::unexpected(plan.error());
  }
  Run run{mechanism, std::move(*plan), std::nullopt, std::nullopt, tolerance};
  if (!run.plan.group) {
    return run;
  }
  const ContactGroup& group = *run.plan.group;
  const FindResult found = first_contact(mechanism, group, run.plan.driver.sign * driver);
  const Contact& contact = mechanism.contacts[static_cast<std::size_t>(group.contact)];
  if (contact.rolling) {
    if (auto reason = start_rolling_contact(run, driver, found)) {
      return tl::unexpected(*reason);
    }
    return run;
  }
  if (found.status != FindStatus::kFound) {
    return tl::unexpected(
        explain(found.status, mechanism.contacts[static_cast<std::size_t>(group.contact)].name));
  }
  run.track = start_track(group.pair, found.at, found.branch);
  return run;
}

std::optional<Slip> find_slip(const Run& run, const std::vector<double>& positions) {
  if (!run.rolling) {
    return std::nullopt;
  }
  RollingTrack track = *run.rolling;
  for (const double position : positions) {
    const RollingResult result = roll_to(track, run.plan.driver.sign * position);
    const bool slips = std::abs(track.at.sliding) > run.tolerance * run.plan.size;
    if (!result.converged || !(result.mismatch <= run.tolerance * run.plan.size) || slips) {
      return Slip{position, track.at.sliding};
    }
  }
  return std::nullopt;
}

RunStep move_to(Run& run, double position, double velocity, double acceleration) {
  RunStep step;
  const GroundedBody& driver = run.plan.driver;
  const double u = driver.sign * position;
  step.row.bodies.resize(run.mechanism.bodies.size());
  step.row.bodies[static_cast<std::size_t>(driver.body)] =
      motion_at(driver.freedom, u, driver.sign * velocity, driver.sign * acceleration);
  step.row.status = RowStatus::kOk;
  if (run.rolling) {
    const RollingResult result = roll_to(*run.rolling, u);
    step.row.residual = result.mismatch;
    add_contact(run, run.rolling->at, run.rolling->phi, driver.sign * velocity, driver.sign * acceleration,
                step.row);
    return step;
  }
  if (!run.track) {
    return step;
  }
  const TrackResult result = follow_to(*run.track, u);
  if (result.limit) {
    step.limit = LimitEvent{driver.sign * result.limit->u};
  }
  if (result.status == TrackStatus::kOk) {
    add_contact(run, run.track->at, run.track->phi, driver.sign * velocity, driver.sign * acceleration,
                step.row);
  } else {
    step.row.status = RowStatus::kNotAssemblable;
  }
  return step;
}

}  // namespace higherpair
