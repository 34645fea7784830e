#include "coupled_system.hpp"

#include "analysis/rates/series_motion.hpp"
#include "group_kinds.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

// Column of a body's x; < 0 if the body is not one of the group.
Eigen::Index column_of(const Group& group, int body) {
  const auto found = std::find(group.bodies.begin(), group.bodies.end(), body);
  return found == group.bodies.end() ? -1 : 3 * (found - group.bodies.begin());
}

}  // namespace

void take_group(const Group& group, const State& from, State& to) {
  for (const int index : group.bodies) {
    to.bodies[index] = from.bodies[index];
  }
  for (const int index : group.contacts) {
    to.contacts[index] = from.contacts[index];
  }
}

bool place_contacts(const Planned& model, const Group& group, State& to) {
  for (const int index : group.contacts) {
    const Contact& contact = model.mechanism.contacts[index];
    if (!place_contact(model.mechanism, contact, to.bodies, to.contacts[index])) {
      return false;
    }
  }
  return true;
}

void hold_angles(const std::vector<int>& held, const State& in, const State& to, double size,
                 std::vector<ConstraintRow>& rows) {
  for (const int body : held) {
    rows.push_back(angle_row(to.bodies, body, in.bodies[body].theta, size));
  }
}

std::vector<ConstraintRow> group_rows(const Planned& model, const Group& group,
                                      const std::vector<DriverMotion>& drivers, const State& state,
                                      const std::vector<ContactMotion>& contacts) {
  const Mechanism& mechanism = model.mechanism;
  const double size = model.plan.size;
  std::vector<ConstraintRow> rows;
  for (const int index : group.joints) {
    append_rows(mechanism, mechanism.joints[index], state.bodies, size, rows);
  }
  for (const int index : group.contacts) {
    append_rows(mechanism, mechanism.contacts[index], contacts[index], state.bodies, rows);
  }
  for (const int index : group.drivers) {
    const auto i = static_cast<std::size_t>(index);
    append_driver_row(mechanism, driven_joint(mechanism, i), drivers[i].position, state.bodies, size, rows);
  }
  hold_angles(idle_bodies_of(model.plan, group), state, state, size, rows);
  return rows;
}

std::vector<Vector2d> places_of(const Planned& model, const Group& group, const State& state,
                                std::optional<int> body) {
  const auto counts = [&](int index) { return !body || index == *body; };
  std::vector<Vector2d> places;
  for (const int index : group.joints) {
    const Joint& joint = model.mechanism.joints[index];
    for (const PointRef& point : {joint.first, joint.second}) {
      if (!couples_turning(joint.type) && counts(point.body)) {
        places.push_back(state.bodies[point.body].X_WB * point_of(model.mechanism, point));
      }
    }
  }
  for (const int index : group.contacts) {
    const Contact& contact = model.mechanism.contacts[index];
    if (counts(contact.first.body) || counts(contact.second.body)) {
      places.push_back(state.contacts[index].at.p_W());
    }
  }
  return places;
}

Eigen::VectorXd gradient_of(const Group& group, const std::vector<ConstraintRow>& rows,
                            const Eigen::VectorXd& weights, double size) {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(group.bodies.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ConstraintRow weighted = rows[i];
    for (Eigen::Vector3d& coefficient : weighted.coefficient) {
      coefficient *= weights(static_cast<Eigen::Index>(i));
    }
    add_coefficients(
        weighted, size, [&](std::size_t k) { return column_of(group, rows[i].body[k]); }, gradient);
  }
  return gradient;
}

Eigen::MatrixXd jacobian_of(const Group& group, const std::vector<ConstraintRow>& rows, double size) {
  return jacobian_of(rows, size, 3 * static_cast<Eigen::Index>(group.bodies.size()),
                     [&](int body) { return column_of(group, body); });
}

Vector2d place_of_ground(const Mechanism& mechanism) {
  for (const Joint& joint : mechanism.joints) {
    for (const PointRef& point : {joint.first, joint.second}) {
      if (point.body == 0 && !couples_turning(joint.type)) {
        return point_of(mechanism, point);
      }
    }
  }
  return Vector2d::Zero();
}

double farthest_coupled(const Planned& model, const State& state) {
  const Vector2d ground = place_of_ground(model.mechanism);
  double farthest = 0;
  for (const Group& group : model.plan.groups) {
    if (!traits_of(group).coupled) continue;
    for (const Vector2d& p_W : places_of(model, group, state)) {
      const double distance = (p_W - ground).norm();
      farthest = std::max(farthest, std::isnan(distance) ? kInf : distance);
    }
  }
  return farthest;
}

}  // namespace higherpair
