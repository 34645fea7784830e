#include "events.hpp"

#include "coupled_crossing.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "root_between.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/tools/minima.hpp>

namespace higherpair {
namespace {

// Velocities below this share of the step's largest are rounding, not a motion whose sense could change.
constexpr double kAtRest = 1e-12;

double output_velocity(const OutputJoint& output, const State& state) {
  const BodyMotion& body = state.bodies[static_cast<std::size_t>(output.body)];
  return output.turns ? body.omega : body.v_WB.dot(output.direction_W);
}

// The largest speed of any body, as a turning [per unit of the path] or sliding one [m].
double fastest_motion(const State& state, double size, bool turning) {
  double fastest = 0;
  for (const BodyMotion& body : state.bodies) {
    fastest = std::max({fastest, std::abs(body.omega), body.v_WB.norm() / size});
  }
  return turning ? fastest : fastest * size;
}

void note_stroke_ends(Run& run, const Path& path, double s, double h) {
  for (OutputJoint& output : run.outputs) {
    const double before = output_velocity(output, run.state);
    const double after = output_velocity(output, run.trial);
    const double fast = std::max({std::abs(before), std::abs(after), output.fastest});
    output.fastest = fast;
    if (std::abs(after) <= kAtRest * fast) {
      continue;
    }
    const int sense = after > 0 ? 1 : -1;
    if (output.sense == 0 && std::abs(before) > kAtRest * fast) {
      output.sense = before > 0 ? 1 : -1;
    }
    if (sense == output.sense) {
      continue;
    }
    // An output at rest has a sense by rounding alone.
    const double rest = kAtRest * std::max(fast, fastest_motion(run.trial, run.plan.size, output.turns));
    if (std::abs(after) <= rest) {
      continue;
    }
    const bool reverses = output.sense != 0;
    output.sense = sense;
    if (!reverses) {
      continue;
    }
    const State kept = run.trial;
    const auto velocity = [&](double x) {
      return solve_at(run, path, s, x) ? output_velocity(output, run.trial) : NAN;
    };
    const auto x = std::abs(before) <= rest ? std::optional(0.0) : root_between(velocity, before, h, after);
    run.trial = kept;
    if (x) {
      RunEvent event;
      event.type = EventType::kStrokeEnd;
      set_place(event, path, s + *x);
      event.joint = output.joint;
      event.cause = "the motion of this joint reverses";
      run.events.push_back(std::move(event));
    }
  }
}

// κ1 + κ2 up to a positive factor; empty where one of the curves is a line or a point, which cannot conform.
std::optional<double> conformity(const Run& run, std::size_t contact, const State& state) {
  const Contact& touching = run.mechanism.contacts[contact];
  const bool conics =
      is_conic(curve_of(run.mechanism, touching.first)) && is_conic(curve_of(run.mechanism, touching.second));
  const CommonNormal& at = state.contacts[contact].at;
  return conics ? std::optional((at.rho1 + at.rho2) * (at.rho1 * at.rho2 > 0 ? 1 : -1)) : std::nullopt;
}

void note_conforming(Run& run, const Path& path, double s, double h) {
  for (std::size_t i = 0; i < run.mechanism.contacts.size(); ++i) {
    const auto before = conformity(run, i, run.state);
    const auto after = conformity(run, i, run.trial);
    if (!before || !after || *before * *after >= 0) {
      continue;
    }
    const State kept = run.trial;
    const auto value = [&](double x) {
      return solve_at(run, path, s, x) ? conformity(run, i, run.trial).value_or(NAN) : NAN;
    };
    const auto x = root_between(value, *before, h, *after);
    run.trial = kept;
    if (x) {
      RunEvent event;
      event.type = EventType::kConforming;
      set_place(event, path, s + *x);
      event.contact = static_cast<int>(i);
      event.cause =
          "both curves have the same curvature at the contact: beyond, the bodies cut into each other there";
      run.events.push_back(std::move(event));
    }
  }
}

// Where a group's sine passes through 0 with its sign changed: between `reach` before and after the place of
// the least slack it is interpolated with its rates (cubic Hermite).
// \param after  the groups at the end of the step
double crossing_between(Run& run, const Path& path, std::size_t g, double s, double h,
                        std::vector<GroupState> after) {
  const auto sine = [&](double x) {
    return solve_at(run, path, s, x) ? std::abs(run.trial.groups[g].sine) : INFINITY;
  };
  std::uintmax_t calls = 100;
  const double middle =
      boost::math::tools::brent_find_minima(sine, std::min(0.0, h), std::max(0.0, h), 52, calls).first;
  const double reach = std::copysign(std::min({1e-3, std::abs(middle), std::abs(h - middle)}), h);
  if (!(std::abs(reach) > 1e-9) || !solve_at(run, path, s, middle - reach)) {
    return middle;
  }
  const GroupState a = run.trial.groups[g];
  // Beyond the crossing the motion has the modes of the end of the step.
  run.state.groups.swap(after);
  const bool solved = solve_at(run, path, s, middle + reach);
  run.state.groups.swap(after);
  if (!solved) {
    return middle;
  }
  const GroupState b = run.trial.groups[g];
  const double f0 = a.sine, f1 = b.sine, d0 = a.sine_rate * 2 * reach, d1 = b.sine_rate * 2 * reach;
  double t = 0.5;
  for (int i = 0; i < 20; ++i) {
    const double u = 1 - t;
    const double value =
        f0 * (1 + 2 * t) * u * u + d0 * t * u * u + f1 * t * t * (3 - 2 * t) - d1 * t * t * u;
    const double slope = 6 * t * u * (f1 - f0) + d0 * u * (1 - 3 * t) - d1 * t * (2 - 3 * t);
    t -= slope == 0 ? 0 : value / slope;
  }
  return t >= 0 && t <= 1 ? middle - reach + 2 * reach * t : middle;
}

// Where ∂gap/∂q of a tracked contact passes through 0: the root of the cubic through four places about it. At
// the crossing itself, and next to it, the tracker gives 0.
double crossing_of_track(Run& run, const Path& path, std::size_t g, double s, double h) {
  const double before = run.state.groups[g].sine;
  const double after = run.trial.groups[g].sine;
  const auto sine = [&](double x) { return solve_at(run, path, s, x) ? run.trial.groups[g].sine : NAN; };
  const double middle = root_between(sine, before, h, after).value_or(h * before / (before - after));
  const double d = std::copysign(
      std::min({1e-3 * driver_scale(run, 0), std::abs(middle) / 3, std::abs(h - middle) / 3}), h);
  const auto t =
      root_of_cubic(sine(middle - 3 * d), sine(middle - d), sine(middle + d), sine(middle + 3 * d));
  return middle + t.value_or(0) * d;
}

// Where in a step that changes a group's mode its branches cross, from the start of the path.
double crossing_in_step(Run& run, const Path& path, std::size_t g, double s, double h) {
  const GroupKind& kind = run.plan.groups[g].kind;
  if (std::holds_alternative<TrackedPair>(kind)) {
    return s + crossing_of_track(run, path, g, s, h);
  }
  if (std::holds_alternative<CoupledBodies>(kind)) {
    return place_of_crossing(run, path, g, s, h).value_or(s + h / 2);
  }
  return s + crossing_between(run, path, g, s, h, run.trial.groups);
}

void note_dead_points(Run& run, const Path& path, double s, double h) {
  for (std::size_t g = 0; g < run.plan.groups.size(); ++g) {
    if (run.state.groups[g].mode == run.trial.groups[g].mode) {
      continue;
    }
    const State kept = run.trial;
    const double place = crossing_in_step(run, path, g, s, h);
    run.trial = kept;
    RunEvent event;
    event.type = EventType::kDeadPoint;
    set_place(event, path, place);
    name_item(run, g, event);
    event.cause =
        "branches cross here: the input cannot tell which way the mechanism goes on; it is taken straight on";
    run.events.push_back(std::move(event));
  }
}

}  // namespace

std::vector<OutputJoint> output_joints(const Mechanism& mechanism) {
  std::vector<OutputJoint> outputs;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    const bool grounded = (joint.first.body == 0) != (joint.second.body == 0);
    if (is_driven(mechanism, static_cast<int>(i)) || !grounded || !can_be_driven(joint.type)) {
      continue;
    }
    const int body = joint.first.body == 0 ? joint.second.body : joint.first.body;
    OutputJoint output;
    output.joint = static_cast<int>(i);
    output.body = body;
    output.turns = joint.type == JointType::kRevolute;
    if (!output.turns) {
      output.direction_W = grounded_freedom(mechanism, body).value_or(OneFreedom{}).direction_W;
    }
    outputs.push_back(output);
  }
  return outputs;
}

void note_events(Run& run, const Path& path, double s, double h) {
  note_stroke_ends(run, path, s, h);
  note_conforming(run, path, s, h);
  note_dead_points(run, path, s, h);
}

}  // namespace higherpair
