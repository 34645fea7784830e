#include "step.hpp"

#include "coupled_crossing.hpp"
#include "higherpair/contact/step_agreement.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/tools/minima.hpp>

namespace higherpair {
namespace {

constexpr double kFarthestTurn = 2;  // of a body in one step [rad]

// Groups that keep to their branch by themselves.
bool is_safe(const Group& group) {
  return std::holds_alternative<DrivenBody>(group.kind) || std::holds_alternative<TrackedPair>(group.kind) ||
         std::holds_alternative<IdleBody>(group.kind) || std::holds_alternative<GearedBody>(group.kind);
}

// How far the bodies of a group have moved, and how far from where their rates said; angles, and lengths by
// the size.
struct Agreement {
  double change = 0;
  double mismatch = 0;
  double farthest_turn = 0;  // of one body

  // Next to a limit a prediction may lead to any angle, and there is a solution within a turn of any.
  [[nodiscard]] bool within(double share) const {
    return mismatch <= share * change + 1e-9 && farthest_turn <= kFarthestTurn;
  }
};

Agreement agreement(const Group& group, const State& from, const State& to, double h, double size) {
  Agreement result;
  const double per_size = 1 / size;
  for (const int index : group.bodies) {
    const BodyMotion& a = from.bodies[static_cast<std::size_t>(index)];
    const BodyMotion& b = to.bodies[static_cast<std::size_t>(index)];
    const double turn = b.theta - a.theta;
    const Vector2d shift = b.X_WB.p_WB - a.X_WB.p_WB;
    result.change += std::abs(turn) + per_size * shift.lpNorm<1>();
    result.farthest_turn = std::max(result.farthest_turn, std::abs(turn));
    result.mismatch += std::abs(turn - h * (a.omega + h / 2 * a.alpha)) +
                       per_size * (shift - h * (a.v_WB + h / 2 * a.a_WB)).lpNorm<1>();
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

// Places the groups before `end` in run.trial, `x` beyond run.state, which stands at s; in the modes of
// run.state and without asking whether they agree with a prediction.
bool place_before(Run& run, const Path& path, std::size_t end, double s, double x) {
  std::vector<double> drivers;
  path.positions(s + x, drivers);
  std::optional<LimitPosition> limit;
  for (std::size_t g = 0; g < end; ++g) {
    run.trial.groups[g].mode = run.state.groups[g].mode;
    if (place_group(model_of(run), g, run.state, x, drivers, run.trial, limit) != GroupStatus::kOk) {
      return false;
    }
  }
  return true;
}

// A group that came over to the other branch next to where they cross.
std::optional<std::size_t> group_that_turns_back(const Run& run, double h) {
  for (std::size_t g = 0; g < run.plan.groups.size(); ++g) {
    const GroupState& a = run.state.groups[g];
    const GroupState& b = run.trial.groups[g];
    if (turns_back(a.sine, a.sine_rate, b.sine, b.sine_rate, h) && !is_safe(run.plan.groups[g]) &&
        !std::holds_alternative<CoupledBodies>(run.plan.groups[g].kind)) {
      return g;
    }
  }
  return std::nullopt;
}

// Whether the slack only touches 0 within the step, so that branches really cross there; without it the links
// would come near to being aligned and part again, or part of the way could not be assembled.
bool really_crosses(Run& run, const Path& path, std::size_t g, double s, double h) {
  const double before = slack_after(run, path, g, s, 0);
  if (!std::isfinite(before)) {
    return true;
  }
  // The gap of a contact may come to 0 from either side, and be 0 to rounding at an end.
  const double end = slack_after(run, path, g, s, h);
  const double sense = (std::abs(end) > std::abs(before) ? end : before) < 0 ? -1 : 1;
  const auto slack = [&](double x) { return sense * slack_after(run, path, g, s, x); };
  std::uintmax_t calls = 100;
  const auto [x, smallest] =
      boost::math::tools::brent_find_minima(slack, std::min(0.0, h), std::max(0.0, h), 52, calls);
  const double size = run.plan.size;
  const bool is_length = std::holds_alternative<TouchingBody>(run.plan.groups[g].kind);
  return std::abs(smallest) <= 1e-13 * (std::abs(before) + std::abs(end) + (is_length ? size : size * size));
}

// Places a group in run.trial on the branch given by `mode`, where the present position leads to.
GroupStatus place_on(Run& run, std::size_t g, int mode, double h, double share,
                     const std::vector<double>& drivers, StepResult& result) {
  run.trial.groups[g].mode = mode;
  const GroupStatus status = place_group(model_of(run), g, run.state, h, drivers, run.trial, result.limit);
  const Group& group = run.plan.groups[g];
  return status != GroupStatus::kOk || is_safe(group) || agrees(run, group, h, share)
             ? status
             : GroupStatus::kNotConverged;
}

// Newton's method may come out on any branch: the sign of the determinant tells which.
GroupStatus place_coupled_agreeing(Run& run, const Path& path, std::size_t g, double s, double h,
                                   const std::vector<double>& drivers, StepResult& result) {
  const int mode = run.state.groups[g].mode;
  const GroupStatus status = place_on(run, g, mode, h, kStepAgreement, drivers, result);
  if (status != GroupStatus::kOk || run.trial.groups[g].mode == mode) {
    return status;
  }
  const State kept = run.trial;
  const bool crosses =
      agrees(run, run.plan.groups[g], h, kCrossingAgreement) && passes_crossing(run, path, g, s, h);
  run.trial = kept;
  return crosses ? GroupStatus::kOk : GroupStatus::kNotConverged;
}

GroupStatus place_agreeing(Run& run, const Path& path, std::size_t g, double s, double h,
                           const std::vector<double>& drivers, StepResult& result) {
  const Group& group = run.plan.groups[g];
  if (std::holds_alternative<CoupledBodies>(group.kind)) {
    return place_coupled_agreeing(run, path, g, s, h, drivers, result);
  }
  const GroupState& before = run.state.groups[g];
  const bool crosses = !is_safe(group) && (before.sine + h * before.sine_rate) * before.sine < 0;
  if (crosses && place_on(run, g, -before.mode, h, kCrossingAgreement, drivers, result) == GroupStatus::kOk) {
    const State kept = run.trial;
    const bool crossing = really_crosses(run, path, g, s, h);
    run.trial = kept;
    if (crossing) {
      return GroupStatus::kOk;
    }
  }
  return place_on(run, g, before.mode, h, kStepAgreement, drivers, result);
}

}  // namespace

bool agrees(const Run& run, const Group& group, double h, double share) {
  return agreement(group, run.state, run.trial, h, run.plan.size).within(share) && keeps_contacts(run, group);
}

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

double slack_after(Run& run, const Path& path, std::size_t g, double s, double h) {
  if (!place_before(run, path, g, s, h)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  for (const int body : run.plan.groups[g].bodies) {
    run.trial.bodies[static_cast<std::size_t>(body)] = run.state.bodies[static_cast<std::size_t>(body)];
  }
  for (const int contact : run.plan.groups[g].contacts) {
    run.trial.contacts[static_cast<std::size_t>(contact)] =
        run.state.contacts[static_cast<std::size_t>(contact)];
  }
  return slack_of(model_of(run), g, run.trial).value_or(std::numeric_limits<double>::quiet_NaN());
}

StepResult try_step(Run& run, const Path& path, double s, double h) {
  StepResult result;
  std::vector<double>& drivers = run.trial_drivers;
  path.positions(s + h, drivers);
  for (std::size_t g = 0; g < run.plan.groups.size(); ++g) {
    const bool known = result.limit.has_value();
    const GroupStatus status = place_agreeing(run, path, g, s, h, drivers, result);
    result.group = result.limit && !known ? g : result.group;
    if (status != GroupStatus::kOk) {
      result.group = g;
      result.kind = status == GroupStatus::kOutOfReach ? StepResult::kLost : StepResult::kDisagrees;
      return result;
    }
  }
  path.motions(s + h, run.trial_motions);
  set_rates(run, run.trial_motions, run.trial);
  if (const auto g = group_that_turns_back(run, h)) {
    result.group = *g;
    result.kind = StepResult::kDisagrees;
  }
  return result;
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

StepResult place_anew(Run& run, const std::vector<double>& drivers) {
  StepResult result;
  for (std::size_t g = 0; g < run.plan.groups.size(); ++g) {
    const bool known = result.limit.has_value();
    run.trial.groups[g].mode = run.state.groups[g].mode;
    if (place_group(model_of(run), g, run.state, 0, drivers, run.trial, result.limit) != GroupStatus::kOk) {
      return {StepResult::kLost, g, std::nullopt};
    }
    result.group = result.limit && !known ? g : result.group;
  }
  set_unit_motions(drivers, run.trial_motions);
  set_rates(run, run.trial_motions, run.trial);
  return result;
}

}  // namespace higherpair
