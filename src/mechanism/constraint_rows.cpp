#include "higherpair/mechanism/constraint_rows.hpp"

#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/contact/details.hpp"
#include "higherpair/contact/separation.hpp"
#include "higherpair/mechanism/condition_system.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/tolerances.hpp"

namespace higherpair {
namespace {

template <int N>
BodyAt<Partials<double, N>> variable(const std::vector<BodyMotion>& bodies, int index, std::size_t first) {
  const BodyMotion& body = bodies[index];
  return variable<N>(BodyAt<double>{body.X_WB, body.theta}, first);
}

template <int N>
ConstraintRow row_of(const Partials<double, N>& value, const std::array<int, 3>& bodies) {
  ConstraintRow row;
  row.body = bodies;
  row.value = value.c[0];
  for (std::size_t k = 0; 3 * k + 3 <= N; ++k) {
    row.coefficient[k] = {value.c[3 * k + 1], value.c[3 * k + 2], value.c[3 * k + 3]};
  }
  return row;
}

// Coefficients of direction·(velocity of the body's material point at p).
Eigen::Vector3d along(const Vector2d& direction_W, const BodyMotion& body, const Vector2d& p_W) {
  return {direction_W.x(), direction_W.y(), direction_W.dot(perp(Vector2d(p_W - body.X_WB.p_WB)))};
}

// The same as joint_conditions for a pin, in a third of the time: most joints are pins, and every row of a
// run with forces needs them.
void append_pin_rows(const Mechanism& mechanism, const Joint& joint, const std::vector<BodyMotion>& bodies,
                     std::vector<ConstraintRow>& rows) {
  const BodyMotion& first = bodies[joint.first.body];
  const BodyMotion& second = bodies[joint.second.body];
  const Vector2d a = first.X_WB.R_WB * point_of(mechanism, joint.first);
  const Vector2d b = second.X_WB.R_WB * point_of(mechanism, joint.second);
  const Vector2d apart = second.X_WB.p_WB + b - (first.X_WB.p_WB + a);
  ConstraintRow& along_x = rows.emplace_back();
  along_x.body = {joint.first.body, joint.second.body, 0};
  along_x.coefficient[0] = {-1, 0, a.y()};
  along_x.coefficient[1] = {1, 0, -b.y()};
  along_x.value = apart.x();
  ConstraintRow& along_y = rows.emplace_back();
  along_y.body = {joint.first.body, joint.second.body, 0};
  along_y.coefficient[0] = {0, -1, -a.x()};
  along_y.coefficient[1] = {0, 1, b.x()};
  along_y.value = apart.y();
}

double arc_difference(const Mechanism& mechanism, const Contact& contact,
                      const std::vector<BodyMotion>& bodies, const ContactMotion& motion) {
  return arc_difference(curve_of(mechanism, contact.first), bodies[contact.first.body],
                        curve_of(mechanism, contact.second), bodies[contact.second.body], motion.at,
                        motion.phi);
}

}  // namespace

EquivalentLink link_of(const Mechanism& mechanism, const Contact& contact, const CommonNormal& at) {
  return contact.by_boundary ? link_at(at)
                             : equivalent_link(is_line(curve_of(mechanism, contact.first)), at.rho1,
                                               is_line(curve_of(mechanism, contact.second)), at.rho2);
}

ContactMotion facing_motion(const Mechanism& mechanism, const Contact& contact, const Pose<double>& X_W1,
                            const Pose<double>& X_W2, double size) {
  ContactMotion motion;
  if (contact.by_boundary) {
    motion.place = nearest_places(boundary_of(mechanism, contact.first), X_W1,
                                  boundary_of(mechanism, contact.second), X_W2);
    return motion;
  }
  motion.at.n_W = separation(curve_of(mechanism, contact.first), X_W1, curve_of(mechanism, contact.second),
                             X_W2, kRoughNormal * size)
                      .n_W;
  motion.phi = angle_of(motion.at.n_W);
  return motion;
}

bool place_contact(const Mechanism& mechanism, const Contact& contact, const std::vector<BodyMotion>& bodies,
                   ContactMotion& motion) {
  const Pose<double>& X_W1 = bodies[contact.first.body].X_WB;
  const Pose<double>& X_W2 = bodies[contact.second.body].X_WB;
  if (contact.by_boundary) {
    const auto found =
        find_boundary_normal(boundary_of(mechanism, contact.first), X_W1,
                             boundary_of(mechanism, contact.second), X_W2, motion.place[0], motion.place[1]);
    if (!found) {
      return false;
    }
    motion.at = found->at;
    motion.place = {found->place1, found->place2};
  } else {
    const auto found = find_common_normal(curve_of(mechanism, contact.first), X_W1,
                                          curve_of(mechanism, contact.second), X_W2, motion.at.n_W);
    if (!found) {
      return false;
    }
    motion.at = *found;
  }
  motion.phi = nearest_turn(angle_of(motion.at.n_W), motion.phi);
  return true;
}

int row_count(const Joint& joint) {
  return condition_count(joint.type);
}

int row_count(const Contact& contact) {
  return contact.rolling ? 2 : 1;
}

void append_rows(const Mechanism& mechanism, const Joint& joint, const std::vector<BodyMotion>& bodies,
                 double size, std::vector<ConstraintRow>& rows) {
  if (joint.type == JointType::kRevolute) {
    append_pin_rows(mechanism, joint, bodies, rows);
    return;
  }
  const JointDimensions<double> of = joint_dimensions(mechanism, joint);
  const auto append = [&](const auto& values, int carrier) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(values.count); ++i) {
      rows.push_back(row_of(values.value[i], {joint.first.body, joint.second.body, carrier}));
    }
  };
  if (couples_turning(joint.type)) {
    append(joint_conditions(of, variable<9>(bodies, joint.first.body, 1),
                            variable<9>(bodies, joint.second.body, 4), variable<9>(bodies, joint.carrier, 7),
                            size),
           joint.carrier);
  } else {
    const auto first = variable<6>(bodies, joint.first.body, 1);
    append(joint_conditions(of, first, variable<6>(bodies, joint.second.body, 4), first, size), 0);
  }
}

void append_rows(const Mechanism& mechanism, const Contact& contact, const ContactMotion& motion,
                 const std::vector<BodyMotion>& bodies, std::vector<ConstraintRow>& rows) {
  const CommonNormal& touch = motion.at;
  const auto append_along = [&](const Vector2d& direction_W, double value) {
    ConstraintRow& row = rows.emplace_back();
    row.body = {contact.first.body, contact.second.body, 0};
    row.coefficient[0] = -along(direction_W, bodies[contact.first.body], touch.p1_W);
    row.coefficient[1] = along(direction_W, bodies[contact.second.body], touch.p2_W);
    row.value = value;
  };
  append_along(touch.n_W, touch.gap());
  if (contact.rolling) {
    // Adding the distance of the points along t prevents the remaining error of the normal from becoming an
    // error of the arcs.
    const Vector2d t_W = perp(touch.n_W);
    const bool flat =
        is_line(curve_of(mechanism, contact.first)) || is_line(curve_of(mechanism, contact.second));
    const double apart = flat ? 0 : t_W.dot(touch.p2_W - touch.p1_W);
    append_along(t_W, arc_difference(mechanism, contact, bodies, motion) + apart - motion.arc_difference);
  }
}

void append_driver_row(const Mechanism& mechanism, const Joint& joint, double position,
                       const std::vector<BodyMotion>& bodies, double size, std::vector<ConstraintRow>& rows) {
  if (has_angle(joint.type)) {  // the same in a fraction of the time
    const double off = bodies[joint.second.body].theta - bodies[joint.first.body].theta - position;
    ConstraintRow& row = rows.emplace_back();
    row.body = {joint.first.body, joint.second.body, 0};
    row.coefficient[0].z() = -size;
    row.coefficient[1].z() = size;
    row.value = size * off;
    return;
  }
  rows.push_back(
      row_of(driver_condition(joint_dimensions(mechanism, joint), variable<6>(bodies, joint.first.body, 1),
                              variable<6>(bodies, joint.second.body, 4), Partials<double, 6>(position), size),
             {joint.first.body, joint.second.body, 0}));
}

Eigen::VectorXd values_of(const std::vector<ConstraintRow>& rows) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    values(static_cast<Eigen::Index>(i)) = rows[i].value;
  }
  return values;
}

void add_step(const Eigen::Vector3d& step, double size, BodyMotion& body) {
  body.X_WB.p_WB += step.head<2>();
  body.theta += step.z() / size;
  body.X_WB.R_WB = Rotation<double>::from_angle(body.theta);
}

void start_arcs(const Mechanism& mechanism, const Contact& contact, const std::vector<BodyMotion>& bodies,
                ContactMotion& motion) {
  if (contact.rolling) {
    motion.arc_difference = arc_difference(mechanism, contact, bodies, motion);
  }
}

ConstraintRow angle_row(const std::vector<BodyMotion>& bodies, int body, double held, double size) {
  ConstraintRow row;
  row.body[1] = body;
  row.coefficient[1].z() = size;
  row.value = size * (bodies[body].theta - held);
  return row;
}

}  // namespace higherpair
