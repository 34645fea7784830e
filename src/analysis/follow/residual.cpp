#include "residual.hpp"

#include "analysis/rates/series_motion.hpp"
#include "analysis/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

// The largest errors so far, squared.
struct Errors {
  double distance2 = 0;  // [m²]
  double speed2 = 0;     // [m²/s²]
  double fastest2 = 0;   // [m²/s²]
  double sum = 0;        // no unit: keeps a NaN, which a maximum may lose

  void add(double length2, double velocity2) {
    distance2 = std::max(distance2, length2);
    speed2 = std::max(speed2, velocity2);
    sum += length2 + velocity2;
  }

  void compare(double velocity2) { fastest2 = std::max(fastest2, velocity2); }
};

double square(double x) {
  return x * x;
}

using Moving = PowerSeries<double, 1>;

double speed2(const Vector2<Moving>& p_W) {
  return square(p_W.x().c[1]) + square(p_W.y().c[1]);
}

// A joint's point on one of its bodies: relative to the body's origin, and its velocity. Single numbers,
// since packing pairs would take longer than computing with them saves.
struct JointPoint {
  double x = 0, y = 0;
  double v_x = 0, v_y = 0;
};

JointPoint joint_point(const BodyMotion& body, const Vector2d& p_B) {
  const auto [c, s] = body.X_WB.R_WB;
  const double x = c * p_B.x() - s * p_B.y();
  const double y = s * p_B.x() + c * p_B.y();
  return {x, y, body.v_WB.x() - body.omega * y, body.v_WB.y() + body.omega * x};
}

// The same as joint_conditions and their rates, in a third of the time: most joints are pins, and every row
// of every mechanism is checked.
void add_pin(const Run& run, const Joint& joint, Errors& errors) {
  const MotionRow& row = run.row;
  const auto body_a = static_cast<std::size_t>(joint.first.body);
  const auto body_b = static_cast<std::size_t>(joint.second.body);
  const BodyMotion& a = row.bodies[body_a];
  const BodyMotion& b = row.bodies[body_b];
  const JointPoint at_a = joint_point(a, point_of(run.mechanism(), joint.first));
  const JointPoint at_b = joint_point(b, point_of(run.mechanism(), joint.second));
  const double x = (b.X_WB.p_WB.x() - a.X_WB.p_WB.x()) + (at_b.x - at_a.x);
  const double y = (b.X_WB.p_WB.y() - a.X_WB.p_WB.y()) + (at_b.y - at_a.y);
  const bool rates = row.all_rates || (row.has_rates[body_a] && row.has_rates[body_b]);
  errors.compare(square(at_a.v_x) + square(at_a.v_y));
  errors.add(square(x) + square(y), rates ? square(at_b.v_x - at_a.v_x) + square(at_b.v_y - at_a.v_y) : 0);
}

void add_joint(const Run& run, const Joint& joint, Errors& errors) {
  if (joint.type == JointType::kRevolute) {
    add_pin(run, joint, errors);
    return;
  }
  const MotionRow& row = run.row;
  const auto has_rates = [&](int body) { return row.has_rates[body]; };
  const auto body = [&](int index) { return series_of_body<1>(row.bodies[index]); };
  const bool turning = couples_turning(joint.type);
  const bool rates = row.all_rates || (has_rates(joint.first.body) && has_rates(joint.second.body) &&
                                       (!turning || has_rates(joint.carrier)));
  const JointDimensions<double> of = joint_dimensions(run.mechanism(), joint);
  const double size = run.plan().size;
  const BodyAt<Moving> first = body(joint.first.body);
  const BodyAt<Moving> second = body(joint.second.body);
  const BodyAt<Moving> carrier = turning ? body(joint.carrier) : first;
  const ConditionValues<Moving> values = joint_conditions(of, first, second, carrier, size);
  if (turning) {
    errors.compare(square(size * second.theta.c[1]));
    errors.compare(square(size * of.turning_ratio * first.theta.c[1]));
    errors.compare(square(size * (of.turning_ratio - 1) * carrier.theta.c[1]));
  } else {
    errors.compare(speed2(first.point(of.p_A)));
    errors.compare(speed2(second.point(of.p_B)));
  }
  const auto error2 = [&](std::size_t k) {
    return square(values.value[0].c[k]) + square(values.value[1].c[k]);
  };
  errors.add(error2(0), rates ? error2(1) : 0);
}

// Squared distance of the contact points. Far out on open curves a rounding of the common normal shifts them
// along the tangent, which is not an error of the position.
double apart2(const CommonNormal& at) {
  const double radii = std::abs(at.rho1) + std::abs(at.rho2);
  const double shift = std::isfinite(radii) ? kNormalRounding * radii : 0;
  const Vector2d apart = at.p2_W - at.p1_W;
  return square(apart.dot(at.n_W)) + square(std::max(0.0, std::abs(cross(at.n_W, apart)) - shift));
}

// Tangency holds by construction: both points are those with the common normal.
void add_contact(const Run& run, const Contact& contact, const ContactMotion& motion, Errors& errors) {
  const MotionRow& row = run.row;
  const auto body_a = static_cast<std::size_t>(contact.first.body);
  const auto body_b = static_cast<std::size_t>(contact.second.body);
  const Vector2d p_W = motion.at.p_W();
  const Vector2d v1 = velocity_at(row.bodies[body_a], p_W);
  const Vector2d v = velocity_at(row.bodies[body_b], p_W) - v1;
  errors.compare(v1.squaredNorm());
  errors.compare((v + v1).squaredNorm());
  const bool rates = row.has_rates[body_a] && row.has_rates[body_b];
  const double along_normal = v.dot(motion.at.n_W);
  errors.add(apart2(motion.at), !rates ? 0 : contact.rolling ? v.squaredNorm() : square(along_normal));
}

}  // namespace

double residual_of(const Run& run) {
  Errors errors;
  // The pins of a single crank are at rest: include its turning in the speeds that errors are compared with.
  for (const BodyMotion& body : run.row.bodies) {
    errors.compare(square(run.plan().size * body.omega));
  }
  for (const Joint& joint : run.mechanism().joints) {
    add_joint(run, joint, errors);
  }
  for (std::size_t i = 0; i < run.mechanism().contacts.size(); ++i) {
    if (run.row.contacts[i].touches) {
      add_contact(run, run.mechanism().contacts[i], run.row.contacts[i], errors);
    }
  }
  const double scaled2 = errors.fastest2 > 0 ? errors.speed2 / errors.fastest2 * square(run.plan().size) : 0;
  return std::isfinite(errors.sum) ? std::sqrt(std::max(errors.distance2, scaled2)) : kInf;
}

}  // namespace higherpair
