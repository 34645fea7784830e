#include "span_joints.hpp"

#include "group_solver.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/geometry/newton_root.hpp"
#include "higherpair/geometry/roots.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "other_place.hpp"
#include "step.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace higherpair {
namespace {

constexpr double kFartherAlong =
    2;  // than its speeds at both ends of a step make likely: what a contact runs at most

// Which contact and side has gone to another span.
struct Changed {
  std::size_t contact = 0;
  std::size_t side = 0;
};

std::optional<Changed> changed_place(const Run& run) {
  for (std::size_t i = 0; i < run.mechanism().contacts.size(); ++i) {
    if (!run.mechanism().contacts[i].by_boundary) {
      continue;
    }
    for (std::size_t side = 0; side < 2; ++side) {
      if (run.work.trial.contacts[i].place[side].span != run.at.state.contacts[i].place[side].span) {
        return Changed{i, side};
      }
    }
  }
  return std::nullopt;
}

// How fast a contact runs along a boundary, on a corner how fast its normal turns there. Its sign is the same
// on either side of a joint: u1 = (ω_r + κ2 v_s) / (κ1 + κ2) and u2 = (ω_r - κ1 v_s) / (κ1 + κ2).
double running_speed(const Run& run, const Changed& at, const State& state) {
  const ContactMotion& motion = state.contacts[at.contact];
  const Contact& contact = run.mechanism().contacts[at.contact];
  const BodyMotion& body = state.bodies[static_cast<std::size_t>(ref_of(contact, at.side).body)];
  return boundary_at(run, at.contact, at.side).is_corner(motion.place[at.side])
             ? motion.rates.phi_dot - body.omega
         : at.side == 0 ? motion.rates.along1
                        : -motion.rates.along2;
}

// A contact and side that turns back within the step, and where.
struct Turn {
  Changed at;
  double x = 0;
};

// Whether a contact that runs first one way and then the other may have been on another span in between.
bool may_have_left(const Run& run, const Changed& at, double h) {
  const Boundary& boundary = boundary_at(run, at.contact, at.side);
  const BoundaryPlace& from = run.at.state.contacts[at.contact].place[at.side];
  const BoundaryPlace& to = run.work.trial.contacts[at.contact].place[at.side];
  if (from.span != to.span) {
    return true;
  }
  if (boundary.spans().size() == 1) {
    return false;
  }
  const double before = running_speed(run, at, run.at.state);
  const double after = running_speed(run, at, run.work.trial);
  const double end = end_of(boundary, from.span, before * h > 0).t;
  const double room =
      std::min(std::abs(distance_along(boundary, from, end)), std::abs(distance_along(boundary, to, end)));
  return !(kFartherAlong * std::max(std::abs(before), std::abs(after)) * std::abs(h) < room);
}

std::vector<Turn> turned_back(const Run& run, double h) {
  std::vector<Turn> turned;
  for (std::size_t i = 0; i < run.mechanism().contacts.size(); ++i) {
    if (!run.mechanism().contacts[i].by_boundary || !run.at.state.contacts[i].touches ||
        !run.work.trial.contacts[i].touches) {
      continue;
    }
    for (std::size_t side = 0; side < 2; ++side) {
      const Changed at{i, side};
      if (running_speed(run, at, run.at.state) * running_speed(run, at, run.work.trial) < 0 &&
          may_have_left(run, at, h)) {
        turned.push_back({at});
      }
    }
  }
  return turned;
}

// The part of a step up to where a contact turns back on another span than it began on, so that it may be
// back at the end; run.work.trial is then there. All of the step if none does.
double length_without_return(Run& run, const Path& path, std::vector<Turn>& turned, double s, double h) {
  double length = h;
  for (Turn& turn : turned) {
    const Changed at = turn.at;
    StateAside aside(run.work.trial);
    const auto speed = [&](double x) {
      mark_places(run);
      return solve_at(run, path, s, x) ? running_speed(run, at, run.work.trial) : kNoValue;
    };
    const auto x = root_between(speed, running_speed(run, at, run.at.state), length,
                                running_speed(run, at, run.work.trial));
    turn.x = x.value_or(0);
    mark_places(run);
    const bool elsewhere = x && *x != 0 && std::abs(*x) < std::abs(length) && solve_at(run, path, s, *x) &&
                           run.work.trial.contacts[at.contact].place[at.side].span !=
                               run.at.state.contacts[at.contact].place[at.side].span;
    if (elsewhere) {
      length = *x;
      aside.commit();
    }
  }
  return length;
}

// The sense in which the contact runs along a boundary, from span to span or by its speed at the step's end.
bool runs_forward(const Run& run, const Changed& changed, double h) {
  const Boundary& boundary = boundary_at(run, changed.contact, changed.side);
  const int from = run.at.state.contacts[changed.contact].place[changed.side].span;
  const int to = run.work.trial.contacts[changed.contact].place[changed.side].span;
  const bool is_next = to == boundary.next_span(from, true);
  const bool is_previous = to == boundary.next_span(from, false);
  if (is_next != is_previous) {
    return is_next;
  }
  const double before = running_speed(run, changed, run.at.state);
  const double after = running_speed(run, changed, run.work.trial);
  return (before * after < 0 ? after : before) * h > 0;
}

// A number that goes through 0 where the contact is at the joint.
double beyond_joint(const Boundary& boundary, const BoundaryPlace& place, const JointPassage& passage,
                    bool forward) {
  const double sense = forward ? 1 : -1;
  if (place.span == passage.before.span) {
    return -sense * distance_along(boundary, place, passage.before.t);
  }
  if (place.span == passage.after.span) {
    return -sense * distance_along(boundary, place, passage.after.t);
  }
  return boundary.size();
}

std::string curvature_text(const Boundary& boundary, const BoundaryPlace& place) {
  return fmt::format("{:.6g}", boundary.at(place).kappa);
}

// The joint that the contact's group moves, to say how its acceleration jumps.
std::optional<int> moved_joint(const Run& run, std::size_t contact) {
  for (const Group& group : run.plan().groups) {
    if (std::find(group.contacts.begin(), group.contacts.end(), static_cast<int>(contact)) !=
            group.contacts.end() &&
        !group.joints.empty()) {
      return group.joints.front();
    }
  }
  return std::nullopt;
}

double acceleration_of(const Run& run, int joint) {
  return joint_motion(run.mechanism(), run.mechanism().joints[static_cast<std::size_t>(joint)],
                      run.at.state.bodies)
      .acceleration;
}

}  // namespace

void set_place_of(const Run& run, const JointPassage& passage, const BoundaryPlace& place, State& state) {
  ContactMotion& motion = state.contacts[passage.contact];
  motion.place[passage.side] = place;
  const Boundary& boundary = boundary_at(run, passage.contact, passage.side);
  const double rho = radius_of(boundary.at(place), boundary.is_corner(place));
  (passage.side == 0 ? motion.at.rho1 : motion.at.rho2) = rho;
}

void mark_places(Run& run) {
  for (std::size_t i = 0; i < run.mechanism().contacts.size(); ++i) {
    if (run.mechanism().contacts[i].by_boundary) {
      run.work.trial.contacts[i].place = run.at.state.contacts[i].place;
    }
  }
}

namespace {

std::optional<JointPassage> first_passage(Run& run, const Path& path, const std::vector<Turn>& turned,
                                          double s, double h) {
  std::optional<JointPassage> first;
  // A joint passed before the one found shows as a change there.
  while (const auto changed = changed_place(run)) {
    const Boundary& boundary = boundary_at(run, changed->contact, changed->side);
    const bool forward = runs_forward(run, *changed, h);
    const int span = run.at.state.contacts[changed->contact].place[changed->side].span;
    JointPassage passage{changed->contact, changed->side, end_of(boundary, span, forward),
                         end_of(boundary, boundary.next_span(span, forward), !forward), 0};
    const auto place_in = [&](const State& state) {
      return state.contacts[passage.contact].place[passage.side];
    };
    const auto seen = [&](const State& state) {
      return ValueAndSlope{beyond_joint(boundary, place_in(state), passage, forward),
                           (forward ? 1 : -1) * running_speed(run, *changed, state)};
    };
    double solved = kNoValue;
    const auto beyond = [&](double x) {
      mark_places(run);
      solved = x;
      return solve_at(run, path, s, x) ? seen(run.work.trial) : ValueAndSlope{kNoValue, kNoValue};
    };
    const double length = first ? first->x : h;
    // Where it turns back on its span it leaves that behind there, though it may have begun at the joint.
    const auto turn = std::find_if(turned.begin(), turned.end(), [&](const Turn& candidate) {
      return candidate.at.contact == changed->contact && candidate.at.side == changed->side &&
             std::abs(candidate.x) < std::abs(length);
    });
    const double after = seen(run.work.trial).value;
    const double from = turn == turned.end() ? 0 : turn->x;
    const ValueAndSlope before = from != 0 ? beyond(from) : seen(run.at.state);
    const auto left = before.value >= 0 ? std::optional(0.0)
                                        : newton_root_between([&](double x) { return beyond(from + x); },
                                                              before, length - from, after);
    const auto x = left ? std::optional(from + *left) : std::nullopt;
    if (!x || (first && std::abs(*x) >= std::abs(first->x))) {
      return first;
    }
    passage.x = *x;
    first = passage;
    if (solved != *x) {
      mark_places(run);
      if (!solve_at(run, path, s, *x)) {
        return first;
      }
    }
    run.work.trial.contacts[passage.contact].place[passage.side] = place_in(run.at.state);
  }
  if (first) {
    first->solved = true;
  }
  return first;
}

}  // namespace

std::optional<JointPassage> joint_within(Run& run, const Path& path, double s, double h) {
  std::vector<Turn> turned = turned_back(run, h);
  if (turned.empty() && !changed_place(run)) {
    return std::nullopt;
  }
  StateAside aside(run.work.trial);
  const double length = length_without_return(run, path, turned, s, h);
  const auto first = first_passage(run, path, turned, s, length);
  if (first) {
    aside.commit();
  }
  return first;
}

bool place_at_joint(Run& run, const Path& path, double s, const JointPassage& passage) {
  if (!passage.solved) {
    mark_places(run);
    if (!solve_at(run, path, s, passage.x)) {
      return false;
    }
  }
  set_place_of(run, passage, passage.before, run.work.trial);
  set_rates(run, run.work.motions, run.work.trial);
  return true;
}

void go_over_joint(Run& run, const Path& path, double s, const JointPassage& passage) {
  const Boundary& boundary = boundary_at(run, passage.contact, passage.side);
  const auto joint = moved_joint(run, passage.contact);
  const double before = joint ? acceleration_of(run, *joint) : 0;
  set_place_of(run, passage, passage.after, run.at.state);
  path.motions(s, run.work.motions);
  set_rates(run, run.work.motions, run.at.state);
  const bool onto_corner = boundary.is_corner(passage.after);
  const bool over_end = is_on_edge(run, passage.contact, passage.side, passage.before) ||
                        is_on_edge(run, passage.contact, passage.side, passage.after);
  const int span = passage.before.t == range_of(boundary, passage.before.span).high ? passage.before.span
                                                                                    : passage.after.span;
  if (!onto_corner && boundary.joint_after(span) == SpanJoint::kSmooth) {
    return;
  }
  const EventType type = over_end                                            ? EventType::kEnd
                         : onto_corner || boundary.is_corner(passage.before) ? EventType::kCorner
                                                                             : EventType::kCurvatureJump;
  RunEvent event = event_at(type, path, s, "");
  event.contact = static_cast<int>(passage.contact);
  const std::string& body = body_of_side(run, passage.contact, passage.side);
  const std::string jump =
      joint ? fmt::format("; for a unit rate of the driver the acceleration of joint {} jumps {}",
                          run.mechanism().joints[static_cast<std::size_t>(*joint)].name,
                          from_to_text(before, acceleration_of(run, *joint)))
            : "";
  if (over_end) {
    event.cause =
        onto_corner
            ? fmt::format("the contact reaches the end of the curve of {} and goes on at the edge there{}",
                          body, jump)
            : fmt::format("the contact leaves the edge at the end of the curve of {}{}", body, jump);
  } else if (event.type == EventType::kCorner) {
    event.cause =
        fmt::format("the contact {} a corner of {}{}", onto_corner ? "goes onto" : "leaves", body, jump);
  } else {
    event.cause =
        fmt::format("the curvature of {} jumps from {} to {} 1/m{}", body,
                    curvature_text(boundary, passage.before), curvature_text(boundary, passage.after), jump);
  }
  run.events.push_back(std::move(event));
}

}  // namespace higherpair
