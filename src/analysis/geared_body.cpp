#include "group_kinds.hpp"
#include "higherpair/mechanism/constraint_rows.hpp"

namespace higherpair {
namespace {

// The condition of the gears without what the body itself contributes, and its coefficient.
struct Drive {
  double value = 0, speed = 0, acceleration = 0;
  double own = 0;
};

Drive drive_of(const Planned& model, const GearedBody& geared, const State& state) {
  const Joint& joint = model.mechanism.joints[static_cast<std::size_t>(geared.gears)];
  const ConstraintRow row = gear_row(joint, state.bodies, 1);
  Drive drive;
  drive.value = row.value;
  for (std::size_t k = 0; k < row.body.size(); ++k) {
    const double coefficient = row.coefficient[k].z();
    if (row.body[k] == geared.body) {
      drive.own += coefficient;
    } else {
      drive.speed += coefficient * body_in(state, row.body[k]).omega;
      drive.acceleration += coefficient * body_in(state, row.body[k]).alpha;
    }
  }
  return drive;
}

}  // namespace

void place_geared(const Planned& model, const GearedBody& geared, State& to) {
  BodyMotion& body = body_in(to, geared.body);
  body = {};
  const Drive drive = drive_of(model, geared, to);
  body.theta = -drive.value / drive.own;
  body.X_WB.R_WB = Rotation<double>::from_angle(body.theta);
  body.X_WB.p_WB = place_of(to, geared.pin) - body.X_WB.R_WB * geared.p_B;
}

void move_geared(const Planned& model, const GearedBody& geared, State& state) {
  const Drive drive = drive_of(model, geared, state);
  move_link(body_in(state, geared.body), -drive.speed / drive.own, -drive.acceleration / drive.own,
            motion_of(state, geared.pin), geared.p_B);
}

}  // namespace higherpair
