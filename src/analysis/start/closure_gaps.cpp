// By how much the links of a group are too short to close, or have length to spare.
#include "analysis/follow/step.hpp"
#include "analysis/groups/group_solver.hpp"
#include "assembly.hpp"
#include "higherpair/analysis/branch_run.hpp"
#include "higherpair/numeric/overload.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

Vector2d in_ground(const BodyPoint& point, const std::vector<BodyMotion>& bodies) {
  return bodies[point.body].X_WB * point.p_B;
}

double distance_from(const BodyLine& line, const std::vector<BodyMotion>& bodies, const Vector2d& p_W) {
  const Pose<double>& X_WB = bodies[line.body].X_WB;
  const Vector2d u_W = X_WB.R_WB * Vector2d(line.u_B.cos, line.u_B.sin);
  return std::abs(cross(u_W, Vector2d(p_W - X_WB * line.p_B)));
}

}  // namespace

std::optional<double> closure_gap(const Group& group, const std::vector<BodyMotion>& bodies) {
  const auto apart = [&](const auto& dyad) {
    return (in_ground(dyad.A, bodies) - in_ground(dyad.B, bodies)).norm();
  };
  using Gap = std::optional<double>;
  return std::visit(
      Overload{[&](const RrrDyad& dyad) -> Gap {
                 return std::max(apart(dyad) - (dyad.length_a + dyad.length_b),
                                 std::abs(dyad.length_a - dyad.length_b) - apart(dyad));
               },
               [&](const RrpDyad& dyad) -> Gap {
                 return distance_from(dyad.line, bodies, in_ground(dyad.A, bodies)) - dyad.length;
               },
               [&](const RprDyad& dyad) -> Gap { return std::abs(slot_offset(dyad)) - apart(dyad); },
               [](const auto&) -> Gap { return std::nullopt; }},
      group.kind);
}

std::vector<std::optional<double>> closure_gaps(const Run& run, const std::vector<double>& drivers) {
  const State& from = run.at.state;
  State state = from;
  std::vector<DriverMotion> motions;
  for (const double position : drivers) {
    motions.push_back({position});
  }
  std::vector<std::optional<double>> gaps(run.plan().groups.size());
  for (std::size_t g = 0; g < gaps.size(); ++g) {
    // A contact that was never found cannot be followed.
    if (std::holds_alternative<TrackedPair>(run.plan().groups[g].kind) &&
        std::holds_alternative<std::monostate>(state.tracks[g])) {
      break;
    }
    gaps[g] = closure_gap(run.plan().groups[g], state.bodies);
    if ((gaps[g] && *gaps[g] > 0) ||
        place_group_anew(model_of(run), g, from, motions, state) != GroupStatus::kOk) {
      break;
    }
  }
  return gaps;
}

std::vector<std::optional<double>> first_closure_gaps(RunModel model, const std::vector<double>& drivers,
                                                      int branch) {
  Run run = planned_run(std::move(model), drivers);
  (void)assemble_on(run, branch);
  return closure_gaps(run, drivers);
}

std::optional<double> transmission_sine(const Plan& plan, int joint, const std::vector<BodyMotion>& bodies) {
  for (const Group& group : plan.groups) {
    const auto* dyad = std::get_if<RrrDyad>(&group.kind);
    if (dyad == nullptr || dyad->pin_C != joint) {
      continue;
    }
    const Vector2d A = in_ground(dyad->A, bodies);
    const Vector2d B = in_ground(dyad->B, bodies);
    const Vector2d C = bodies[dyad->link_a].X_WB * dyad->a_pC;
    return cross(Vector2d(A - C), Vector2d(B - C)) / (dyad->length_a * dyad->length_b);
  }
  return std::nullopt;
}

}  // namespace higherpair
