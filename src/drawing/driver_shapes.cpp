#include "higherpair/drawing/scene_maker.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "sketch.hpp"
#include "turn_arrow.hpp"

#include <cmath>

namespace higherpair {
namespace {

// Sizes in units. The arc is near the pin: nothing else is drawn so close to it, and the frame has room
// there.
constexpr double kDriverRadius = 3.4, kDriverHead = 1.5;
constexpr double kBeside = 3.6;      // from a slide to the arrow beside it
constexpr double kDriverArrow = 7;   // length of that
constexpr double kClear = 0.55;      // angle from the link to the arc [rad]
constexpr double kDriverTurn = 1.3;  // of the arc [rad]

using Kind = Shape::Kind;

// The direction in which a body extends from a point of it, in ground: that of its point farthest from there.
double direction_of_link(const Mechanism& mechanism, const BodyMotion& motion, const PointRef& pin) {
  const Vector2d& p_B = point_of(mechanism, pin);
  Vector2d longest = Vector2d::Zero();
  for (const NamedPoint& point : mechanism.bodies[pin.body].points) {
    if ((point.p_B - p_B).norm() > longest.norm()) longest = point.p_B - p_B;
  }
  const Vector2d d_W = motion.X_WB.R_WB * (longest.norm() > 0 ? longest : Vector2d(1, 0));
  return std::atan2(d_W.y(), d_W.x());
}

// Before or behind the link, whichever is higher: the support of the pin is below it.
double beginning_of_arc(double link, double sense) {
  const double before = link + sense * kClear;
  const double behind = link - sense * (kClear + kDriverTurn + kDriverHead / kDriverRadius);
  const auto height = [&](double from) { return std::sin(from + sense * kDriverTurn / 2); };
  return height(before) >= height(behind) ? before : behind;
}

}  // namespace

// An arrow in the sense in which the driver moves its body; where it rests, in that of its coordinate.
void SceneMaker::add_driver(const MotionRow& row, const Driver& driver) {
  const Joint& joint = mechanism_->joints[driver.joint];
  const std::string name = driver_name(driver);
  const bool first_moves = joint.second.body == 0;  // the second body is ground
  const PointRef& moved = first_moves ? joint.first : joint.second;
  const BodyMotion& body = row.bodies[moved.body];
  const double velocity = joint_motion(*mechanism_, joint, row.bodies).velocity;
  const double sense = (velocity < 0) != first_moves ? -1 : 1;
  const Vector2d p = kMillimetresPerMetre * (body.X_WB * point_of(*mechanism_, moved));
  const double u = scene_.unit;
  if (has_angle(joint.type)) {
    const double from = beginning_of_arc(direction_of_link(*mechanism_, body, moved), sense);
    const TurnArrow arrow{p, kDriverRadius * u, from, sense * kDriverTurn};
    next(Role::kDriver, name, Kind::kPath).numbers = arc_of(arrow);
    next(Role::kDriver, name, Kind::kPath, true).numbers = head_of(arrow, kDriverHead * u);
    return;
  }
  const Vector2d along = sense * (row.bodies[joint.first.body].X_WB.R_WB * joint.direction_A);
  const Vector2d from = p + kBeside * u * perp(along) - kDriverArrow / 2 * u * along;
  const Vector2d to = from + kDriverArrow * u * along;
  next(Role::kDriver, name, Kind::kArrow).numbers = {from.x(), from.y(), to.x(), to.y()};
}

}  // namespace higherpair
