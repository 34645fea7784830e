#include "higherpair/mechanism/jerk_rows.hpp"

#include "higherpair/contact/jerk.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

namespace higherpair {
namespace {

const BodyMotion& at(const std::vector<BodyMotion>& bodies, int index) {
  return bodies[static_cast<std::size_t>(index)];
}

// The second joint point as seen from the first, with the jerks of both frames taken as 0.
struct Relative {
  Vector2d p_W, v_W, a_W, jerk_W;
};

Relative relative_of(const Mechanism& mechanism, const Joint& joint, const std::vector<BodyMotion>& bodies) {
  const BodyMotion& a = at(bodies, joint.first.body);
  const BodyMotion& b = at(bodies, joint.second.body);
  const Vector2d p_A = point_of(mechanism, joint.first);
  const Vector2d p_B = point_of(mechanism, joint.second);
  const PointMotion A = point_motion(a, p_A);
  const PointMotion B = point_motion(b, p_B);
  return {B.p_W - A.p_W, B.v_W - A.v_W, B.a_W - A.a_W, point_jerk(b, {}, p_B) - point_jerk(a, {}, p_A)};
}

// (d·r)‴ for a direction that turns with the first body.
double moving_term(const BodyMotion& first, const Vector2d& direction_W, const Relative& r) {
  const double omega = first.omega;
  const Vector2d across = perp(direction_W);
  const Vector2d second = first.alpha * across - omega * omega * direction_W;
  const Vector2d third = -3 * omega * first.alpha * direction_W - omega * omega * omega * across;
  return direction_W.dot(r.jerk_W) + 3 * omega * across.dot(r.a_W) + 3 * second.dot(r.v_W) + third.dot(r.p_W);
}

}  // namespace

void append_jerk_terms(const Mechanism& mechanism, const Joint& joint, const std::vector<BodyMotion>& bodies,
                       std::vector<double>& deltas) {
  if (couples_turning(joint.type)) {
    deltas.push_back(0);
    return;
  }
  const Relative r = relative_of(mechanism, joint, bodies);
  if (joint.type == JointType::kRevolute) {
    deltas.push_back(r.jerk_W.x());
    deltas.push_back(r.jerk_W.y());
    return;
  }
  const BodyMotion& first = at(bodies, joint.first.body);
  deltas.push_back(moving_term(first, perp(Vector2d(first.X_WB.R_WB * joint.direction_A)), r));
  if (joint.type == JointType::kPrismatic) {
    deltas.push_back(0);
  }
}

void append_jerk_terms(const Mechanism& mechanism, const Contact& contact, const ContactMotion& motion,
                       const std::vector<BodyMotion>& bodies, ContactShape shape,
                       std::vector<double>& deltas) {
  const BodyMotion& first = at(bodies, contact.first.body);
  const BodyMotion& second = at(bodies, contact.second.body);
  const CommonNormal& touch = motion.at;
  const ContactJerk jerk = contact_jerk(curve_of(mechanism, contact.first),
                                        curve_of(mechanism, contact.second), touch, first, second);
  const Vector2d by_turning_W = jerk_by_turning(second, touch.p2_W - second.X_WB.p_WB) -
                                jerk_by_turning(first, touch.p1_W - first.X_WB.p_WB);
  const double wanted = shape == ContactShape::kTrue ? jerk.normal_jerk() : jerk.linkage_normal_jerk;
  deltas.push_back(by_turning_W.dot(touch.n_W) - wanted);
  if (contact.rolling) {
    deltas.push_back(by_turning_W.dot(perp(touch.n_W)) - jerk.rolling_jerk);
  }
}

void append_driver_jerk_term(const Mechanism& mechanism, const Joint& joint,
                             const std::vector<BodyMotion>& bodies, std::vector<double>& deltas) {
  if (joint.type == JointType::kRevolute) {
    deltas.push_back(0);
    return;
  }
  const BodyMotion& first = at(bodies, joint.first.body);
  deltas.push_back(
      moving_term(first, first.X_WB.R_WB * joint.direction_A, relative_of(mechanism, joint, bodies)));
}

}  // namespace higherpair
