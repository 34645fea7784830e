#include "group_system.hpp"

#include "group_kinds.hpp"
#include "higherpair/geometry/support.hpp"

#include <algorithm>

namespace higherpair {
namespace {

// One condition: coefficients by (x, y, θ) of bodies and by φ of a contact.
struct Condition {
  ConstraintRow row;
  int contact = -1;
  double per_phi = 0;
};

bool touch_at(const Planned& model, const Contact& contact, const State& state, ContactMotion& motion) {
  const Curve& curve1 = curve_of(model.mechanism, contact.first);
  const Curve& curve2 = curve_of(model.mechanism, contact.second);
  const auto first = place(curve1, body_in(state, contact.first.body).X_WB);
  const auto second = place(curve2, body_in(state, contact.second.body).X_WB);
  CommonNormal& at = motion.at;
  const Vector2d n = at.n_W;
  const Vector2d inward = -n;
  if ((!is_line(curve1) && !has_point(first, n)) || (!is_line(curve2) && !has_point(second, inward))) {
    return false;
  }
  if (!is_line(curve1)) {
    const auto point = support_point(first, n);
    at.p1_W = point.p_W;
    at.rho1 = point.rho;
  }
  if (!is_line(curve2)) {
    const auto point = support_point(second, inward);
    at.p2_W = point.p_W;
    at.rho2 = point.rho;
  }
  // A face: the foot of the other body's point.
  if (is_line(curve1)) {
    at.p1_W = at.p2_W - (at.p2_W - first.vertex_W).dot(first.axis_W) * first.axis_W;
    at.rho1 = 0;
  }
  if (is_line(curve2)) {
    at.p2_W = at.p1_W - (at.p1_W - second.vertex_W).dot(second.axis_W) * second.axis_W;
    at.rho2 = 0;
  }
  return at.p1_W.allFinite() && at.p2_W.allFinite();
}

// -∂/∂(x, y, θ of the body's pose) of direction·p for a point fixed in it.
Eigen::Vector3d moves(const BodyMotion& body, const Vector2d& p_W, const Vector2d& direction_W) {
  return {direction_W.x(), direction_W.y(), direction_W.dot(perp(Vector2d(p_W - body.X_WB.p_WB)))};
}

// gap = n·(p2 - p1) and s = t·(p2 - p1), with dp/dφ = ρ t on either curve; a face holds n instead.
void append_contact(const Planned& model, int index, const State& state, std::vector<Condition>& conditions) {
  const Contact& contact = model.mechanism.contacts[static_cast<std::size_t>(index)];
  const ContactMotion& motion = state.contacts[static_cast<std::size_t>(index)];
  const CommonNormal& at = motion.at;
  const BodyMotion& body1 = body_in(state, contact.first.body);
  const BodyMotion& body2 = body_in(state, contact.second.body);
  const Vector2d n = at.n_W;
  const Vector2d t = perp(n);
  const Vector2d apart = at.p2_W - at.p1_W;
  Condition gap;
  gap.row.body = {contact.first.body, contact.second.body, 0};
  gap.row.coefficient[0] = -moves(body1, at.p1_W, n);
  gap.row.coefficient[1] = moves(body2, at.p2_W, n);
  gap.row.value = apart.dot(n);
  gap.contact = index;
  gap.per_phi = apart.dot(t);
  Condition along = gap;
  const Curve& curve1 = curve_of(model.mechanism, contact.first);
  const Curve& curve2 = curve_of(model.mechanism, contact.second);
  if (is_line(curve1) || is_line(curve2)) {
    const bool first = is_line(curve1);
    const Vector2d axis =
        first ? Vector2d(-(body1.X_WB.R_WB * curve1.axis_B)) : body2.X_WB.R_WB * curve2.axis_B;
    const double size = model.plan.size;
    along.row.coefficient[0] = {0, 0, first ? -size : 0};
    along.row.coefficient[1] = {0, 0, first ? 0 : -size};
    along.row.value = size * std::atan2(cross(axis, n), axis.dot(n));
    along.per_phi = size;
  } else {
    along.row.coefficient[0] = -moves(body1, at.p1_W, t);
    along.row.coefficient[0].z() += at.rho1;
    along.row.coefficient[1] = moves(body2, at.p2_W, t);
    along.row.coefficient[1].z() += at.rho2;
    along.row.value = apart.dot(t);
    along.per_phi = -(at.rho1 + at.rho2) - apart.dot(n);
  }
  conditions.push_back(gap);
  conditions.push_back(along);
  if (contact.rolling) {
    Condition slip;
    slip.row.body = gap.row.body;
    slip.row.coefficient[0] = -moves(body1, at.p1_W, t);
    slip.row.coefficient[1] = moves(body2, at.p2_W, t);
    slip.row.value = arc_difference(model.mechanism, contact, motion, state.bodies) - motion.arc_difference;
    conditions.push_back(slip);
  }
}

std::vector<Condition> conditions_of(const Planned& model, const Group& group,
                                     const std::vector<DriverMotion>& drivers, const State& state) {
  const Mechanism& mechanism = model.mechanism;
  std::vector<ConstraintRow> rows;
  for (const int index : group.joints) {
    append_rows(mechanism, mechanism.joints[static_cast<std::size_t>(index)], state.bodies, model.plan.size,
                rows);
  }
  for (const int index : group.drivers) {
    const Driver& driver = mechanism.drivers[static_cast<std::size_t>(index)];
    const DriverMotion& motion = drivers[static_cast<std::size_t>(index)];
    append_driver_row(mechanism, mechanism.joints[static_cast<std::size_t>(driver.joint)], motion.position,
                      motion.velocity, motion.acceleration, state.bodies, model.plan.size, rows);
  }
  const std::vector<int>& idle = model.plan.idle_bodies;
  for (const int body : group.bodies) {
    if (std::find(idle.begin(), idle.end(), body) != idle.end()) {
      ConstraintRow& row = rows.emplace_back();
      row.body[1] = body;
      row.coefficient[1].z() = model.plan.size;
    }
  }
  std::vector<Condition> conditions;
  for (const ConstraintRow& row : rows) {
    conditions.push_back({row, -1, 0});
  }
  for (const int index : group.contacts) {
    append_contact(model, index, state, conditions);
  }
  return conditions;
}

Eigen::Index column_of(const std::vector<int>& list, int item) {
  const auto found = std::find(list.begin(), list.end(), item);
  return found == list.end() ? -1 : found - list.begin();
}

}  // namespace

Eigen::VectorXd coordinates_of(const Planned& model, const Group& group, const State& state) {
  const double size = model.plan.size;
  const auto bodies = static_cast<Eigen::Index>(group.bodies.size());
  Eigen::VectorXd x(3 * bodies + static_cast<Eigen::Index>(group.contacts.size()));
  for (Eigen::Index i = 0; i < bodies; ++i) {
    const BodyMotion& body = body_in(state, group.bodies[static_cast<std::size_t>(i)]);
    x.segment<2>(3 * i) = body.X_WB.p_WB;
    x(3 * i + 2) = size * body.theta;
  }
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    x(3 * bodies + static_cast<Eigen::Index>(i)) =
        size * state.contacts[static_cast<std::size_t>(group.contacts[i])].phi;
  }
  return x;
}

void set_coordinates(const Planned& model, const Group& group, const State& from, const Eigen::VectorXd& x,
                     State& state) {
  const double size = model.plan.size;
  const auto bodies = static_cast<Eigen::Index>(group.bodies.size());
  for (Eigen::Index i = 0; i < bodies; ++i) {
    const int index = group.bodies[static_cast<std::size_t>(i)];
    BodyMotion& body = body_in(state, index);
    body.theta = x(3 * i + 2) / size;
    body.X_WB = {Rotation<double>::from_angle(body.theta), x.segment<2>(3 * i)};
  }
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    const auto index = static_cast<std::size_t>(group.contacts[i]);
    ContactMotion& motion = state.contacts[index];
    motion = from.contacts[index];
    motion.phi = x(3 * bodies + static_cast<Eigen::Index>(i)) / size;
    motion.at.n_W = unit_vector(motion.phi);
  }
}

bool group_system(const Planned& model, const Group& group, const std::vector<DriverMotion>& drivers,
                  State& state, Eigen::VectorXd& F, Eigen::MatrixXd& J, Eigen::VectorXd& F_s) {
  for (const int index : group.contacts) {
    if (!touch_at(model, model.mechanism.contacts[static_cast<std::size_t>(index)], state,
                  state.contacts[static_cast<std::size_t>(index)])) {
      return false;
    }
  }
  const std::vector<Condition> conditions = conditions_of(model, group, drivers, state);
  const auto rows = static_cast<Eigen::Index>(conditions.size());
  const auto bodies = static_cast<Eigen::Index>(group.bodies.size());
  F.resize(rows);
  F_s.resize(rows);
  J.setZero(rows, 3 * bodies + static_cast<Eigen::Index>(group.contacts.size()));
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Condition& condition = conditions[static_cast<std::size_t>(i)];
    F(i) = condition.row.value;
    F_s(i) = -condition.row.rate;
    for (std::size_t k = 0; k < condition.row.body.size(); ++k) {
      const Eigen::Vector3d& coefficient = condition.row.coefficient[k];
      const Eigen::Index column = column_of(group.bodies, condition.row.body[k]);
      if (column < 0) {
        const BodyMotion& known = body_in(state, condition.row.body[k]);
        F_s(i) += coefficient.dot(Eigen::Vector3d(known.v_WB.x(), known.v_WB.y(), known.omega));
        continue;
      }
      J(i, 3 * column) += coefficient.x();
      J(i, 3 * column + 1) += coefficient.y();
      J(i, 3 * column + 2) += coefficient.z() / model.plan.size;
    }
    if (condition.contact >= 0) {
      J(i, 3 * bodies + column_of(group.contacts, condition.contact)) += condition.per_phi / model.plan.size;
    }
  }
  return true;
}

}  // namespace higherpair
