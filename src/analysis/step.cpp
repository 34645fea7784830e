#include "step.hpp"

#include "crossing.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "reduction.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kFarthestTurn = 2;  // of a body in one step [rad]

constexpr double kSmooth = 0.04;    // of the change: how far a step may be from a smooth one
constexpr double kNoChange = 1e-9;  // a mismatch that is nothing but rounding [rad, or of the size]

// Groups that have one branch only, or keep it by themselves.
bool keeps_branch(const Run& run, std::size_t g) {
  const GroupKind& kind = run.plan.groups[g].kind;
  return std::holds_alternative<DrivenBody>(kind) || std::holds_alternative<IdleBody>(kind) ||
         std::holds_alternative<GearedBody>(kind) ||
         (std::holds_alternative<TrackedPair>(kind) &&
          !std::holds_alternative<ContactTrack>(run.state.tracks[g]));
}

// How far a group has moved in a step, and how far that is from what the rates and accelerations at both ends
// say. Over a step h of a smooth coordinate x
//     x1 - x0 = h/2 (v0 + v1) - h²/12 (a1 - a0) + O(h⁵),     v1 - v0 = h/2 (a0 + a1) + O(h³):
// a step onto another branch, or over a limit into a part of the branch beyond it, would have to agree in all
// of these at once. Angles, and lengths relative to the size.
struct Smoothness {
  double change = 0;
  double mismatch = 0;
  double farthest_turn = 0;  // of one body

  [[nodiscard]] bool holds() const {
    return mismatch <= kSmooth * change + kNoChange && farthest_turn <= kFarthestTurn;
  }
};

double mismatch_of(double rise, double v0, double v1, double a0, double a1, double h) {
  const double bend = h * h / 12 * (a1 - a0);
  return std::abs(rise - h / 2 * (v0 + v1) + bend) + std::abs(h * (v1 - v0) - h * h / 2 * (a0 + a1));
}

double mismatch_of(const Vector2d& rise, const Vector2d& v0, const Vector2d& v1, const Vector2d& a0,
                   const Vector2d& a1, double h) {
  return mismatch_of(rise.x(), v0.x(), v1.x(), a0.x(), a1.x(), h) +
         mismatch_of(rise.y(), v0.y(), v1.y(), a0.y(), a1.y(), h);
}

Smoothness smoothness(const Group& group, const State& from, const State& to, double h, double size) {
  Smoothness result;
  const double per_size = 1 / size;
  for (const int index : group.bodies) {
    const BodyMotion& a = from.bodies[static_cast<std::size_t>(index)];
    const BodyMotion& b = to.bodies[static_cast<std::size_t>(index)];
    const double turn = b.theta - a.theta;
    const Vector2d shift = b.X_WB.p_WB - a.X_WB.p_WB;
    result.change += std::abs(turn) + per_size * shift.lpNorm<1>();
    result.farthest_turn = std::max(result.farthest_turn, std::abs(turn));
    result.mismatch += mismatch_of(turn, a.omega, b.omega, a.alpha, b.alpha, h) +
                       per_size * mismatch_of(shift, a.v_WB, b.v_WB, a.a_WB, b.a_WB, h);
    // Where the motion turns back within the step, what it covers is more than the change.
    result.change +=
        std::abs(h) * (std::abs(b.omega - a.omega) + per_size * (b.v_WB - a.v_WB).lpNorm<1>()) / 8;
  }
  for (const int index : group.contacts) {
    const ContactMotion& a = from.contacts[static_cast<std::size_t>(index)];
    const ContactMotion& b = to.contacts[static_cast<std::size_t>(index)];
    const double turn = b.phi - a.phi;
    result.change += std::abs(turn);
    result.mismatch += std::abs(turn - h / 2 * (a.rates.phi_dot + b.rates.phi_dot));
  }
  return result;
}

// A body that went over to a neighbouring contact would hardly move.
bool keeps_contacts(const Run& run, const Group& group) {
  return std::all_of(group.contacts.begin(), group.contacts.end(), [&](int index) {
    const auto i = static_cast<std::size_t>(index);
    const Contact& contact = run.mechanism.contacts[i];
    const CommonNormal& from = run.state.contacts[i].at;
    const CommonNormal& to = run.trial.contacts[i].at;
    return same_curvature(curve_of(run.mechanism, contact.first), curve_of(run.mechanism, contact.second),
                          from.rho1 + from.rho2, to.rho1 + to.rho2);
  });
}

// The mode of a group at s: that of run.state, but beyond a change point of the present step the other one.
int mode_at(const Run& run, std::size_t g, double s, double step) {
  int mode = run.state.groups[g].mode;
  for (const Crossing& crossing : run.crossings) {
    if (crossing.group == g && (s - crossing.s) * step > 0) {
      mode = -mode;
    }
  }
  return mode;
}

// Places the groups before `end` in run.trial, `x` beyond run.state, which is at s on the path; whether the
// motion leads there is not asked.
bool place_before(Run& run, const Path& path, std::size_t end, double s, double x) {
  path.positions(s + x, run.trial_drivers);
  for (std::size_t g = 0; g < end; ++g) {
    run.trial.groups[g].mode = mode_at(run, g, s + x, path.length);
    if (place_group(model_of(run), g, run.state, x, run.trial_drivers, run.trial) != GroupStatus::kOk) {
      return false;
    }
  }
  return true;
}

// Places a group in run.trial on the branch given by `mode`, and its rates; kOk only where that continues
// run.state smoothly.
GroupStatus step_group(Run& run, std::size_t g, int mode, double h) {
  run.trial.groups[g].mode = mode;
  const GroupStatus status = place_group(model_of(run), g, run.state, h, run.trial_drivers, run.trial);
  if (status != GroupStatus::kOk) {
    return status;
  }
  set_group_rates(model_of(run), g, run.trial_motions, run.trial);
  const Group& group = run.plan.groups[g];
  if (keeps_branch(run, g)) {
    return GroupStatus::kOk;
  }
  const bool smooth = smoothness(group, run.state, run.trial, h, run.plan.size).holds();
  return smooth && keeps_contacts(run, group) ? GroupStatus::kOk : GroupStatus::kNotConverged;
}

// Whether the group, which run.trial has on the other side of a change point, gets there straight through it:
// where the branches only come near each other the step has jumped.
bool crosses(Run& run, const Path& path, std::size_t g, double s, double h) {
  const State kept = run.trial;
  const auto at = Reduction(run, path, g, s).crossing_within(h);
  run.trial = kept;
  path.positions(s + h, run.trial_drivers);
  path.motions(s + h, run.trial_motions);
  if (at) {
    run.crossings.push_back({g, s + at->ahead});
  }
  return at.has_value();
}

GroupStatus step_on_branch(Run& run, const Path& path, std::size_t g, double s, double h) {
  const GroupState& before = run.state.groups[g];
  if (!can_cross(run.plan.groups[g])) {
    return step_group(run, g, before.mode, h);
  }
  if (std::holds_alternative<CoupledBodies>(run.plan.groups[g].kind)) {
    // Newton's method may arrive on either side of a change point: the sign of the determinant says where.
    const GroupStatus status = step_group(run, g, before.mode, h);
    const bool same = run.trial.groups[g].mode == before.mode;
    return status != GroupStatus::kOk || same || crosses(run, path, g, s, h) ? status
                                                                             : GroupStatus::kNotConverged;
  }
  const bool may_cross = (before.sine + h * before.sine_rate) * before.sine < 0;
  if (may_cross && step_group(run, g, -before.mode, h) == GroupStatus::kOk && crosses(run, path, g, s, h)) {
    return GroupStatus::kOk;
  }
  return step_group(run, g, before.mode, h);
}

}  // namespace

double unit_of(const Run& run, const Path& path) {
  if (path.is_single()) {
    return driver_scale(run, 0);
  }
  double fastest = 0;
  for (std::size_t i = 0; i < path.from.size(); ++i) {
    fastest = std::max(fastest, std::abs(path.to[i] - path.from[i]) / driver_scale(run, i));
  }
  return 1 / fastest;
}

void set_rates(const Run& run, const std::vector<DriverMotion>& drivers, State& state) {
  for (std::size_t g = 0; g < run.plan.groups.size(); ++g) {
    set_group_rates(model_of(run), g, drivers, state);
  }
}

void set_unit_motions(const std::vector<double>& positions, std::vector<DriverMotion>& motions) {
  motions.resize(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    motions[i] = {positions[i], positions.size() == 1 ? 1.0 : 0.0, 0};
  }
}

double driver_scale(const Run& run, std::size_t driver) {
  const Joint& joint = run.mechanism.joints[static_cast<std::size_t>(run.mechanism.drivers[driver].joint)];
  return joint.type == JointType::kRevolute ? 1 : run.plan.size;
}

StepResult try_step(Run& run, const Path& path, double s, double h) {
  run.crossings.clear();
  path.positions(s + h, run.trial_drivers);
  path.motions(s + h, run.trial_motions);
  for (std::size_t g = 0; g < run.plan.groups.size(); ++g) {
    const GroupStatus status = step_on_branch(run, path, g, s, h);
    if (status != GroupStatus::kOk) {
      return {status == GroupStatus::kOutOfReach ? StepResult::kLost : StepResult::kDisagrees, g};
    }
  }
  return {};
}

bool solve_at(Run& run, const Path& path, double s, double x) {
  return solve_before(run, path, run.plan.groups.size(), s, x);
}

bool solve_before(Run& run, const Path& path, std::size_t end, double s, double x) {
  if (!place_before(run, path, end, s, x)) {
    return false;
  }
  path.motions(s + x, run.trial_motions);
  for (std::size_t g = 0; g < end; ++g) {
    set_group_rates(model_of(run), g, run.trial_motions, run.trial);
  }
  return true;
}

bool place_anew(Run& run, const std::vector<double>& drivers) {
  for (std::size_t g = 0; g < run.plan.groups.size(); ++g) {
    run.trial.groups[g].mode = run.state.groups[g].mode;
    if (place_group_anew(model_of(run), g, run.state, drivers, run.trial) != GroupStatus::kOk) {
      return false;
    }
  }
  set_unit_motions(drivers, run.trial_motions);
  set_rates(run, run.trial_motions, run.trial);
  return true;
}

}  // namespace higherpair
