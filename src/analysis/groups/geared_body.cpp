#include "group_kinds.hpp"
#include "higherpair/mechanism/condition_system.hpp"

namespace higherpair {
namespace {

// The gears' condition without the contribution of the body itself, and the coefficient of that contribution.
struct Drive {
  double value = 0, speed = 0, acceleration = 0;
  double own = 0;
};

Drive drive_of(const Planned& model, const GearedBody& geared, const State& state) {
  const Joint& joint = model.mechanism.joints[geared.gears];
  const std::array<int, 3> bodies{joint.first.body, joint.second.body, joint.carrier};
  std::array<BodyAt<Partials<double, 3>>, 3> at;
  for (std::size_t k = 0; k < at.size(); ++k) {
    at[k].theta = state.bodies[bodies[k]].theta;
    at[k].theta.c[k + 1] = 1;
  }
  const auto values = joint_conditions(joint_dimensions(model.mechanism, joint), at[0], at[1], at[2], 1);
  const auto& [value, by_first, by_second, by_carrier] = values.value[0].c;
  Drive drive;
  drive.value = value;
  for (std::size_t k = 0; const double coefficient : {by_first, by_second, by_carrier}) {
    const BodyMotion& body = state.bodies[bodies[k]];
    if (bodies[k++] == geared.body) {
      drive.own += coefficient;
    } else {
      drive.speed += coefficient * body.omega;
      drive.acceleration += coefficient * body.alpha;
    }
  }
  return drive;
}

}  // namespace

void place_geared(const Planned& model, const GearedBody& geared, State& to) {
  to.bodies[geared.body] = {};
  const Drive drive = drive_of(model, geared, to);
  turn_on_pin(geared.pin, geared.body, geared.p_B, -drive.value / drive.own, to);
}

void move_geared(const Planned& model, const GearedBody& geared, State& state) {
  const Drive drive = drive_of(model, geared, state);
  move_link(state.bodies[geared.body], -drive.speed / drive.own, -drive.acceleration / drive.own,
            motion_of(state, geared.pin), geared.p_B);
}

}  // namespace higherpair
