#include "higherpair/mechanism/constraint_rows.hpp"

#include "higherpair/contact/details.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

namespace higherpair {
namespace {

const BodyMotion& at(const std::vector<BodyMotion>& bodies, int index) {
  return bodies[static_cast<std::size_t>(index)];
}

// A point of a body as it stands: the arm from the frame's origin and what the body's turning contributes.
struct Arm {
  Vector2d r_W;
  Vector2d p_W;
  Vector2d v_W;
  Vector2d centripetal_W;  // acceleration for a = 0, α = 0
};

Arm arm_to(const BodyMotion& body, const Vector2d& p_W) {
  const Vector2d r_W = p_W - body.X_WB.p_WB;
  return {r_W, p_W, body.v_WB + body.omega * perp(r_W), -body.omega * body.omega * r_W};
}

Arm arm_to_point(const Mechanism& mechanism, const PointRef& ref, const std::vector<BodyMotion>& bodies) {
  const BodyMotion& body = at(bodies, ref.body);
  const Vector2d r_W = body.X_WB.R_WB * point_of(mechanism, ref);
  return {r_W, body.X_WB.p_WB + r_W, body.v_WB + body.omega * perp(r_W), -body.omega * body.omega * r_W};
}

// Coefficients of direction·(velocity of the point at the arm).
Eigen::Vector3d along(const Vector2d& direction_W, const Arm& arm) {
  return {direction_W.x(), direction_W.y(), direction_W.dot(perp(arm.r_W))};
}

// direction·(p_B - p_A) for a direction that turns with body A. \param shift  subtracted from the value
ConstraintRow moving_row(const Joint& joint, const Vector2d& direction_W, const Arm& A, const Arm& B,
                         const BodyMotion& first) {
  const Vector2d r = B.p_W - A.p_W;
  const Vector2d across = perp(direction_W);
  ConstraintRow row;
  row.body = {joint.first.body, joint.second.body, 0};
  row.coefficient[0] = -along(direction_W, A);
  row.coefficient[0].z() += r.dot(across);
  row.coefficient[1] = along(direction_W, B);
  row.value = r.dot(direction_W);
  row.gamma = (B.centripetal_W - A.centripetal_W).dot(direction_W) +
              2 * first.omega * (B.v_W - A.v_W).dot(across) - first.omega * first.omega * r.dot(direction_W);
  return row;
}

// The conditions of a pin, along x and along y.
void append_pin_rows(const Joint& joint, const Arm& A, const Arm& B, std::vector<ConstraintRow>& rows) {
  const Vector2d apart = B.p_W - A.p_W;
  const Vector2d gamma = B.centripetal_W - A.centripetal_W;
  ConstraintRow& along_x = rows.emplace_back();
  along_x.body = {joint.first.body, joint.second.body, 0};
  along_x.coefficient[0] = {-1, 0, A.r_W.y()};
  along_x.coefficient[1] = {1, 0, -B.r_W.y()};
  along_x.value = apart.x();
  along_x.gamma = gamma.x();
  ConstraintRow& along_y = rows.emplace_back();
  along_y.body = {joint.first.body, joint.second.body, 0};
  along_y.coefficient[0] = {0, -1, -A.r_W.x()};
  along_y.coefficient[1] = {0, 1, B.r_W.x()};
  along_y.value = apart.y();
  along_y.gamma = gamma.y();
}

ConstraintRow angle_row(const Joint& joint, const std::vector<BodyMotion>& bodies, double angle,
                        double size) {
  ConstraintRow row;
  row.body = {joint.first.body, joint.second.body, 0};
  row.coefficient[0].z() = -size;
  row.coefficient[1].z() = size;
  row.value = size * (at(bodies, joint.second.body).theta - at(bodies, joint.first.body).theta - angle);
  return row;
}

}  // namespace

double arc_difference(const Mechanism& mechanism, const Contact& contact, const ContactMotion& motion,
                      const std::vector<BodyMotion>& bodies) {
  const CommonNormal& touch = motion.at;
  const double arc1 = contact_arc(curve_of(mechanism, contact.first), at(bodies, contact.first.body),
                                  touch.p1_W, touch.n_W, motion.phi);
  const double arc2 = contact_arc(curve_of(mechanism, contact.second), at(bodies, contact.second.body),
                                  touch.p2_W, -touch.n_W, motion.phi + kPi);
  return arc1 + arc2;
}

int row_count(const Joint& joint) {
  return joint.type == JointType::kRevolute || joint.type == JointType::kPrismatic ? 2 : 1;
}

int row_count(const Contact& contact) {
  return contact.rolling ? 2 : 1;
}

ConstraintRow gear_row(const Joint& joint, const std::vector<BodyMotion>& bodies, double size) {
  ConstraintRow row;
  row.body = {joint.first.body, joint.second.body, joint.carrier};
  const double k = joint.turning_ratio;
  row.coefficient[0].z() = -k * size;
  row.coefficient[1].z() = size;
  row.coefficient[2].z() = (k - 1) * size;
  const double carrier = at(bodies, joint.carrier).theta;
  row.value = size * ((at(bodies, joint.second.body).theta - carrier) -
                      k * (at(bodies, joint.first.body).theta - carrier) - joint.relative_angle);
  return row;
}

void append_rows(const Mechanism& mechanism, const Joint& joint, const std::vector<BodyMotion>& bodies,
                 double size, std::vector<ConstraintRow>& rows) {
  if (couples_turning(joint.type)) {
    rows.push_back(gear_row(joint, bodies, size));
    return;
  }
  const Arm A = arm_to_point(mechanism, joint.first, bodies);
  const Arm B = arm_to_point(mechanism, joint.second, bodies);
  if (joint.type == JointType::kRevolute) {
    append_pin_rows(joint, A, B, rows);
    return;
  }
  const BodyMotion& first = at(bodies, joint.first.body);
  rows.push_back(moving_row(joint, perp(Vector2d(first.X_WB.R_WB * joint.direction_A)), A, B, first));
  if (joint.type == JointType::kPrismatic) {
    rows.push_back(angle_row(joint, bodies, joint.relative_angle, size));
    // The angles of the poses may be whole turns apart.
    rows.back().value = size * nearest_turn(rows.back().value / size, 0);
  }
}

void append_rows(const Mechanism& mechanism, const Contact& contact, const ContactMotion& motion,
                 const std::vector<BodyMotion>& bodies, std::vector<ConstraintRow>& rows) {
  const CommonNormal& touch = motion.at;
  const Arm first = arm_to(at(bodies, contact.first.body), touch.p1_W);
  const Arm second = arm_to(at(bodies, contact.second.body), touch.p2_W);
  const auto row_along = [&](const Vector2d& direction_W, double value, double relative_acceleration) {
    ConstraintRow row;
    row.body = {contact.first.body, contact.second.body, 0};
    row.coefficient[0] = -along(direction_W, first);
    row.coefficient[1] = along(direction_W, second);
    row.value = value;
    row.gamma = (second.centripetal_W - first.centripetal_W).dot(direction_W) - relative_acceleration;
    return row;
  };
  rows.push_back(row_along(touch.n_W, touch.gap(), motion.rates.normal_acceleration));
  if (contact.rolling) {
    // The material points at a contact that rolls have no relative acceleration along t.
    const double difference = arc_difference(mechanism, contact, motion, bodies);
    rows.push_back(row_along(perp(touch.n_W), difference - motion.arc_difference, 0));
  }
}

void append_driver_row(const Mechanism& mechanism, const Joint& joint, double position, double velocity,
                       double acceleration, const std::vector<BodyMotion>& bodies, double size,
                       std::vector<ConstraintRow>& rows) {
  ConstraintRow row;
  if (joint.type == JointType::kRevolute) {
    row = angle_row(joint, bodies, position, size);
    row.rate = size * velocity;
    row.gamma = -size * acceleration;
  } else {
    const BodyMotion& first = at(bodies, joint.first.body);
    row = moving_row(joint, first.X_WB.R_WB * joint.direction_A, arm_to_point(mechanism, joint.first, bodies),
                     arm_to_point(mechanism, joint.second, bodies), first);
    row.value -= position;
    row.rate = velocity;
    row.gamma -= acceleration;
  }
  rows.push_back(row);
}

}  // namespace higherpair
