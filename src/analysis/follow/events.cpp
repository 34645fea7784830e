#include "events.hpp"

#include "analysis/tolerances.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/hermite.hpp"
#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// Where within a step the speed of an output first falls and then rises, so that it may have reversed twice:
// the minimum of the cubic through the velocities and accelerations at both ends. 0 if there is none.
double slowest_within(double v0, double a0, double v1, double a1, double h) {
  if (v0 * v1 <= 0 || !(v0 * a0 * h < 0 && v1 * a1 * h > 0)) {
    return 0;
  }
  const double per_step = v0 > 0 ? h : -h;
  const HermiteCubic speed{std::abs(v0), per_step * a0, std::abs(v1), per_step * a1};
  const double t = speed.lowest_at();
  return speed(t) <= kMayReverse * std::min(std::abs(v0), std::abs(v1)) ? t * h : 0;
}

double unit_of(const Run& run, const OutputJoint& output) {
  return has_angle(run.mechanism().joints[output.joint].type) ? 1 : run.plan().size;
}

class StrokeEnds {
public:
  StrokeEnds(Run& run, const Path& path, double s, double h) : run_(run), path_(path), s_(s), h_(h) {}

  void note(OutputJoint& output) {
    const JointMotion before = motion_in(output, run_.at.state);
    const JointMotion after = motion_in(output, run_.work.trial);
    const double middle =
        slowest_within(before.velocity, before.acceleration, after.velocity, after.acceleration, h_);
    const auto between = middle != 0 ? motion_at(output, middle) : std::nullopt;
    if (between && between->velocity * before.velocity < 0) {
      note_between(output, 0, before, middle, *between);
      note_between(output, middle, *between, h_, after);
    } else {
      note_between(output, 0, before, h_, after);
    }
    // Where the drivers turn back, the output's next stroke begins, without an event.
    const double lag = 2 * kShortestStroke * unit_of(run_, output);
    output.from = std::clamp(output.from, after.position - lag, after.position + lag);
  }

private:
  [[nodiscard]] const Joint& joint_of(const OutputJoint& output) const {
    return run_.mechanism().joints[output.joint];
  }

  [[nodiscard]] JointMotion motion_in(const OutputJoint& output, const State& state) const {
    return joint_motion(run_.mechanism(), joint_of(output), state.bodies);
  }

  std::optional<JointMotion> motion_at(const OutputJoint& output, double x) {
    return with_trial<JointMotion>(run_, path_, s_, x,
                                   [&](const State& state) { return motion_in(output, state); });
  }

  double velocity_at(const OutputJoint& output, double x) {
    const auto motion = motion_at(output, x);
    return motion ? motion->velocity : kNoValue;
  }

  // Below this speed the sense of an output is a matter of rounding.
  [[nodiscard]] double slowest(const OutputJoint& output, double fast) const {
    return kSlowestOutput * std::max(fast, unit_of(run_, output) * fastest_body(run_, run_.work.trial));
  }

  // Notes a reversal between x0 and x1 within the step.
  void note_between(OutputJoint& output, double x0, const JointMotion& first, double x1,
                    const JointMotion& last) {
    const double before = first.velocity, after = last.velocity;
    // Only recent speeds count: those reached earlier, next to a pole, are no measure of what is slow here.
    const double fastest = std::max(std::abs(before), std::abs(after));
    const double fast = std::max(fastest, std::exchange(output.fastest, fastest));
    const double slow = slowest(output, fast);
    // At the beginning of the motion, or after a jump to another contact, whose own event reports it.
    if (output.sense * before <= 0 && std::abs(before) > slow) {
      output.sense = before > 0 ? 1 : -1;
      output.from = first.position;
      output.least = kShortestFirstStroke;
    }
    const int sense = after > 0 ? 1 : -1;
    if (sense == output.sense || std::abs(after) <= slow) {
      return;
    }
    const bool has_moved = std::exchange(output.sense, sense) != 0;
    const auto velocity = [&](double x) { return velocity_at(output, x0 + x); };
    const auto x =
        std::abs(before) <= slow ? std::optional(0.0) : root_between(velocity, before, x1 - x0, after);
    const auto motion = x ? motion_at(output, x0 + *x) : std::nullopt;
    const double to = motion ? motion->position : first.position;
    const bool ends_stroke = x && has_moved && is_stroke(run_, output, to);
    output.from = to;
    output.least = kShortestStroke;
    if (!ends_stroke) {
      return;
    }
    RunEvent event =
        event_at(EventType::kStrokeEnd, path_, s_ + x0 + *x, "the motion of this joint reverses");
    event.joint = output.joint;
    event.value = motion ? std::optional(to) : std::nullopt;
    run_.events.push_back(std::move(event));
  }

  Run& run_;
  const Path& path_;
  double s_;
  double h_;
};

// κ1 + κ2 up to a positive factor; none if one of the curves is a line or a point, which cannot conform.
std::optional<double> conformity(const Run& run, std::size_t contact, const State& state) {
  const Contact& touching = run.mechanism().contacts[contact];
  const CommonNormal& at = state.contacts[contact].at;
  if (touching.by_boundary) {
    const bool corner = at.rho1 == 0 || at.rho2 == 0;
    return corner ? std::nullopt : std::optional(1 / at.rho1 + 1 / at.rho2);
  }
  const bool curved = is_curved(curve_of(run.mechanism(), touching.first)) &&
                      is_curved(curve_of(run.mechanism(), touching.second));
  return curved ? std::optional((at.rho1 + at.rho2) * (at.rho1 * at.rho2 > 0 ? 1 : -1)) : std::nullopt;
}

void note_conforming(Run& run, const Path& path, double s, double h) {
  for (std::size_t i = 0; i < run.mechanism().contacts.size(); ++i) {
    const auto before = conformity(run, i, run.at.state);
    const auto after = conformity(run, i, run.work.trial);
    if (!before || !after || *before * *after >= 0) {
      continue;
    }
    const auto value = [&](double x) {
      return solve_at(run, path, s, x) ? conformity(run, i, run.work.trial).value_or(kNoValue) : kNoValue;
    };
    const auto x = [&] {
      const StateAside aside(run.work.trial);
      return root_between(value, *before, h, *after);
    }();
    if (x) {
      report_contact(
          run, EventType::kConforming, path, s + *x, i,
          "both curves have the same curvature at the contact: beyond, the bodies cut into each other there");
    }
  }
}

}  // namespace

bool is_stroke(const Run& run, const OutputJoint& output, double position) {
  return !(std::abs(position - output.from) < output.least * unit_of(run, output));
}

std::vector<OutputJoint> output_joints(const Mechanism& mechanism) {
  std::vector<OutputJoint> outputs;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    const bool grounded = (joint.first.body == 0) != (joint.second.body == 0);
    if (grounded && !couples_turning(joint.type) && !is_driven(mechanism, static_cast<int>(i))) {
      outputs.push_back({static_cast<int>(i)});
    }
  }
  return outputs;
}

void note_crossings(Run& run, const Path& path, double s, double end) {
  for (const Crossing& crossing : run.work.crossings) {
    const bool on_the_way = (crossing.s - s) * (end - s) >= 0 && (end - crossing.s) * (end - s) >= 0;
    if (!on_the_way) {
      continue;
    }
    RunEvent event = event_at(EventType::kDeadPoint, path, crossing.s,
                              "branches cross here: the input cannot tell which way the mechanism goes on; "
                              "it is taken straight on");
    name_item(run, crossing.group, event);
    // A chord leads over the change point at the break before it.
    const bool known =
        std::any_of(run.at.reported.begin(), run.at.reported.end(), [&](const RunEvent& other) {
          return is_same_item(event, other) &&
                 (path.is_chord || is_at_same_drivers(run, event, other, kSameChangePoint));
        });
    if (!known) {
      run.at.reported.push_back(event);
      run.events.push_back(std::move(event));
    }
  }
}

void note_events(Run& run, const Path& path, double s, double h) {
  StrokeEnds ends(run, path, s, h);
  for (OutputJoint& output : run.at.outputs) {
    ends.note(output);
  }
  note_conforming(run, path, s, h);
  note_crossings(run, path, s, s + h);
  run.at.reported.clear();
}

}  // namespace higherpair
