#include "coupled_system.hpp"

#include "higherpair/mechanism/joint_motion.hpp"
#include "series_motion.hpp"

#include <algorithm>

namespace higherpair {

void take_group(const Group& group, const State& from, State& to) {
  for (const int index : group.bodies) {
    to.bodies[static_cast<std::size_t>(index)] = from.bodies[static_cast<std::size_t>(index)];
  }
  for (const int index : group.contacts) {
    to.contacts[static_cast<std::size_t>(index)] = from.contacts[static_cast<std::size_t>(index)];
  }
}

void add_step(const Group& group, const Eigen::VectorXd& step, double size, State& to) {
  for (std::size_t i = 0; i < group.bodies.size(); ++i) {
    BodyMotion& body = to.bodies[static_cast<std::size_t>(group.bodies[i])];
    const auto column = static_cast<Eigen::Index>(3 * i);
    body.X_WB.p_WB += step.segment<2>(column);
    body.theta += step(column + 2) / size;
    body.X_WB.R_WB = Rotation<double>::from_angle(body.theta);
  }
}

bool place_contacts(const Planned& model, const Group& group, State& to) {
  for (const int index : group.contacts) {
    const Contact& contact = model.mechanism.contacts[static_cast<std::size_t>(index)];
    if (!place_contact(model.mechanism, contact, to.bodies, to.contacts[static_cast<std::size_t>(index)])) {
      return false;
    }
  }
  return true;
}

void hold_angles(const std::vector<int>& held, const State& in, const State& to, double size,
                 std::vector<ConstraintRow>& rows) {
  for (const int body : held) {
    rows.push_back(angle_row(to.bodies, body, in.bodies[static_cast<std::size_t>(body)].theta, size));
  }
}

std::vector<ConstraintRow> group_rows(const Planned& model, const Group& group,
                                      const std::vector<double>& drivers, const State& state,
                                      const std::vector<ContactMotion>& contacts) {
  const Mechanism& mechanism = model.mechanism;
  const double size = model.plan.size;
  std::vector<ConstraintRow> rows;
  for (const int index : group.joints) {
    append_rows(mechanism, mechanism.joints[static_cast<std::size_t>(index)], state.bodies, size, rows);
  }
  for (const int index : group.contacts) {
    append_rows(mechanism, mechanism.contacts[static_cast<std::size_t>(index)],
                contacts[static_cast<std::size_t>(index)], state.bodies, rows);
  }
  for (const int index : group.drivers) {
    const Driver& driver = mechanism.drivers[static_cast<std::size_t>(index)];
    append_driver_row(mechanism, mechanism.joints[static_cast<std::size_t>(driver.joint)],
                      drivers[static_cast<std::size_t>(index)], state.bodies, size, rows);
  }
  hold_angles(condition_set(model.plan, group).idle_bodies, state, state, size, rows);
  return rows;
}

Eigen::VectorXd values_of(const std::vector<ConstraintRow>& rows) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    values(static_cast<Eigen::Index>(i)) = rows[i].value;
  }
  return values;
}

Eigen::MatrixXd jacobian_of(const Group& group, const std::vector<ConstraintRow>& rows, double size) {
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()),
                                            3 * static_cast<Eigen::Index>(group.bodies.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto column_of = [&](std::size_t k) -> Eigen::Index {
      const auto found = std::find(group.bodies.begin(), group.bodies.end(), rows[i].body[k]);
      return found == group.bodies.end() ? -1 : 3 * (found - group.bodies.begin());
    };
    add_coefficients(rows[i], size, column_of, J.row(static_cast<Eigen::Index>(i)));
  }
  return J;
}

}  // namespace higherpair
