#include "joint_passage.hpp"

#include "analysis/follow/step.hpp"
#include "higherpair/geometry/boundary_places.hpp"

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr std::size_t kMostSmoothJoints = 200;

// A joint of the contact's group, whose acceleration is reported where it jumps.
std::optional<int> reported_joint(const Run& run, std::size_t contact) {
  const auto g = group_with_contact(run.plan(), static_cast<int>(contact));
  const bool moves = g && !run.plan().groups[*g].joints.empty();
  return moves ? std::optional(run.plan().groups[*g].joints.front()) : std::nullopt;
}

double acceleration_of(const Run& run, int joint) {
  return joint_motion(run.mechanism(), run.mechanism().joints[joint], run.at.state.bodies).acceleration;
}

// The event of passing the joint; none if nothing jumps.
std::optional<EventType> type_of(const Run& run, const JointPassage& passage) {
  const Boundary& boundary = boundary_at(run, passage.contact, passage.side);
  const bool onto_corner = boundary.is_corner(passage.after);
  if (!onto_corner && joint_of(run, passage) == SpanJoint::kSmooth) {
    return std::nullopt;
  }
  const bool over_end = is_on_edge(run, passage.contact, passage.side, passage.before) ||
                        is_on_edge(run, passage.contact, passage.side, passage.after);
  return over_end                                            ? EventType::kEnd
         : onto_corner || boundary.is_corner(passage.before) ? EventType::kCorner
                                                             : EventType::kCurvatureJump;
}

std::string cause_of(const Run& run, const JointPassage& passage, EventType type) {
  const bool onto_corner = boundary_at(run, passage.contact, passage.side).is_corner(passage.after);
  const std::string& body = body_of_side(run, passage.contact, passage.side);
  if (type == EventType::kEnd) {
    return onto_corner ? onto_edge_text(run, passage.contact, passage.side)
                       : fmt::format("the contact leaves the edge at the end of the curve of {}", body);
  }
  if (type == EventType::kCorner) {
    return fmt::format("the contact {} a corner of {}", onto_corner ? "goes onto" : "leaves", body);
  }
  return fmt::format("the curvature of {} jumps", body);
}

// What the drivers' own accelerations add to that of a joint.
double added_by_drivers(Run& run, const Path& path, double s, int joint) {
  if (!path.curve) {
    return 0;
  }
  const StateAside aside(run.at.state);
  path.motions(s, run.work.motions);
  for (DriverMotion& driver : run.work.motions) {
    driver.velocity = 0;
  }
  set_rates(run, run.work.motions, run.at.state);
  return acceleration_of(run, joint);
}

}  // namespace

SpanJoint joint_of(const Run& run, const JointPassage& passage) {
  const Boundary& boundary = boundary_at(run, passage.contact, passage.side);
  const bool forward = passage.before.t == range_of(boundary, passage.before.span).high;
  return boundary.joint_after(forward ? passage.before.span : passage.after.span);
}

bool lies_flat_behind(const Run& run, const JointPassage& passage, const State& state) {
  const std::size_t opposite = 1 - passage.side;
  return is_flat(boundary_at(run, passage.contact, passage.side), passage.after) &&
         is_flat(boundary_at(run, passage.contact, opposite),
                 state.contacts[passage.contact].place[opposite]);
}

void set_place_of(const Run& run, std::size_t contact, std::size_t side, const BoundaryPlace& place,
                  State& state) {
  ContactMotion& motion = state.contacts[contact];
  motion.place[side] = place;
  const Boundary& boundary = boundary_at(run, contact, side);
  const double rho = radius_of(boundary.at(place), boundary.is_corner(place));
  (side == 0 ? motion.at.rho1 : motion.at.rho2) = rho;
}

void set_point_of(const Run& run, std::size_t contact, std::size_t side, const BoundaryPlace& place,
                  State& state) {
  CommonNormal& at = state.contacts[contact].at;
  const BodyMotion& body = state.bodies[ref_of(run.mechanism().contacts[contact], side).body];
  (side == 0 ? at.p1_W : at.p2_W) = body.X_WB * boundary_at(run, contact, side).at(place).p_B;
  set_place_of(run, contact, side, place, state);
}

bool place_at_joint(Run& run, const Path& path, double s, const JointPassage& passage) {
  if (!passage.solved && !solve_from_spans(run, path, s, passage.x)) {
    return false;
  }
  set_place_of(run, passage.contact, passage.side, passage.before, run.work.trial);
  set_rates_on(run, path, s + passage.x, run.work.trial);
  return true;
}

void go_over_joint(Run& run, const Path& path, double s, const JointPassage& passage) {
  const auto joint = reported_joint(run, passage.contact);
  const double added = joint ? added_by_drivers(run, path, s, *joint) : 0;
  const double before = joint ? acceleration_of(run, *joint) - added : 0;
  set_place_of(run, passage.contact, passage.side, passage.after, run.at.state);
  set_rates_on(run, path, s, run.at.state);
  const auto type = type_of(run, passage);
  if (!type) {
    if (run.smooth_joints.size() < kMostSmoothJoints) run.smooth_joints.push_back(share_at(path, s));
    return;
  }
  RunEvent& event = report_contact(run, *type, path, s, passage.contact, cause_of(run, passage, *type));
  if (*type == EventType::kCurvatureJump) {
    const Boundary& boundary = boundary_at(run, passage.contact, passage.side);
    event.curvature = std::array{boundary.at(passage.before).kappa, boundary.at(passage.after).kappa};
  }
  if (joint) {
    const Joint& moved = run.mechanism().joints[*joint];
    set_jump(event, path,
             {.of = "the acceleration of joint " + moved.name,
              .turns = moved.type == JointType::kRevolute,
              .order = 2,
              .before = before,
              .after = acceleration_of(run, *joint) - added});
  }
}

}  // namespace higherpair
