#include "free_assembly.hpp"

#include "higherpair/mechanism/condition_system.hpp"
#include "higherpair/mechanism/constraint_rows.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "higherpair/mechanism/tolerances.hpp"
#include "higherpair/numeric/newton.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "numeric/least_norm.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

constexpr int kNewtonTurns = 80;

Eigen::MatrixXd jacobian_of(const SizedMechanism& sized, const std::vector<ConstraintRow>& rows) {
  return jacobian_of(rows, sized.size, sized.columns(), column_of);
}

void append_driver_rows(const SizedMechanism& sized, const std::vector<double>& positions,
                        const MechanismPosition& at, std::vector<ConstraintRow>& rows) {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    append_driver_row(sized.mechanism, driven_joint(sized.mechanism, i), positions[i], at.bodies, sized.size,
                      rows);
  }
}

// Moves all contacts to their common normals; false if there is none near the last one.
bool place_contacts(const Mechanism& mechanism, MechanismPosition& at) {
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    if (!place_contact(mechanism, mechanism.contacts[i], at.bodies, at.contacts[i])) {
      return false;
    }
  }
  return true;
}

MechanismPosition posed(const SizedMechanism& sized) {
  const Mechanism& mechanism = sized.mechanism;
  MechanismPosition at{posed_bodies(mechanism), {}};
  for (const Contact& contact : mechanism.contacts) {
    at.contacts.push_back(facing_motion(mechanism, contact, at.bodies[contact.first.body].X_WB,
                                        at.bodies[contact.second.body].X_WB, sized.size));
  }
  return at;
}

SizedMechanism sized_mechanism(const Mechanism& mechanism) {
  return {mechanism, size_of(mechanism)};
}

// Assembles by steps that reduce the errors of the conditions.
template <class StepOf>
std::optional<MechanismPosition> iterate(const SizedMechanism& sized, const Held& held,
                                         MechanismPosition position, const StepOf& step_of) {
  double last = kInf;
  for (int i = 0; i < kNewtonTurns; ++i) {
    if (!place_contacts(sized.mechanism, position)) {
      return std::nullopt;
    }
    const LinearConditions conditions = conditions_at(sized, held, position);
    if (conditions.values.size() == 0) {
      return position;
    }
    Eigen::VectorXd step = step_of(conditions);
    if (!step.allFinite()) {
      return std::nullopt;
    }
    const double length = step.size() == 0 ? 0 : step.cwiseAbs().maxCoeff() / sized.size;
    if (newton_has_settled(length, last, kNewtonQuadratic, kLeastFreeStep)) {
      const double error = conditions.values.cwiseAbs().maxCoeff();
      return error <= kClosedMechanism * sized.size ? std::optional(std::move(position)) : std::nullopt;
    }
    last = length;
    step *= std::min(1.0, kNewtonTurn / length);
    add_step(sized, step, position);
  }
  return std::nullopt;
}

// Assembles without the conditions of rolling and starts the arcs there: nothing has been travelled yet.
std::optional<MechanismPosition> begin_to_roll(const SizedMechanism& sized,
                                               const std::vector<double>& drivers,
                                               const MechanismPosition& near) {
  auto position = assemble_from(sized, {false, drivers}, near);
  if (!position) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < position->contacts.size(); ++i) {
    start_arcs(sized.mechanism, sized.mechanism.contacts[i], position->bodies, position->contacts[i]);
  }
  return position;
}

}  // namespace

LinearConditions conditions_at(const SizedMechanism& sized, const Held& held,
                               const MechanismPosition& position) {
  const Mechanism& mechanism = sized.mechanism;
  std::vector<ConstraintRow> rows;
  for (const Joint& joint : mechanism.joints) {
    append_rows(mechanism, joint, position.bodies, sized.size, rows);
  }
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    append_rows(mechanism, mechanism.contacts[i], position.contacts[i], position.bodies, rows);
    if (mechanism.contacts[i].rolling && !held.arcs) {
      rows.pop_back();
    }
  }
  append_driver_rows(sized, held.drivers, position, rows);
  return {jacobian_of(sized, rows), values_of(rows)};
}

Eigen::MatrixXd driver_rows(const SizedMechanism& sized, const MechanismPosition& position) {
  std::vector<ConstraintRow> rows;
  append_driver_rows(sized, std::vector<double>(sized.mechanism.drivers.size(), 0.0), position, rows);
  return jacobian_of(sized, rows);
}

std::optional<MechanismPosition> assemble_from(const SizedMechanism& sized, const Held& held,
                                               MechanismPosition position) {
  return iterate(sized, held, std::move(position), [](const LinearConditions& conditions) {
    return LeastNormSolver(conditions.J, kRepeatedConditions).solve(-conditions.values);
  });
}

// Levenberg-Marquardt with a damping in proportion to the error: it vanishes fast enough for quadratic
// convergence, and more slowly than what such conditions contribute to J^T J.
std::optional<MechanismPosition> assemble_beside(const SizedMechanism& sized, MechanismPosition position) {
  return iterate(sized, {}, std::move(position), [&](const LinearConditions& conditions) {
    const Eigen::Index rows = conditions.J.rows(), columns = conditions.J.cols();
    Eigen::MatrixXd J(rows + columns, columns);
    J << conditions.J,
        Eigen::MatrixXd::Identity(columns, columns) * std::sqrt(conditions.values.norm() / sized.size);
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero(rows + columns);
    wanted.head(rows) = -conditions.values;
    return LeastNormSolver(J).solve(wanted);
  });
}

void add_step(const SizedMechanism& sized, const Eigen::VectorXd& step, MechanismPosition& position) {
  for (std::size_t b = 1; b < position.bodies.size(); ++b) {
    add_step(step.segment<3>(column_of(static_cast<int>(b))), sized.size, position.bodies[b]);
  }
}

Eigen::VectorXd step_between(const SizedMechanism& sized, const MechanismPosition& from,
                             const MechanismPosition& to) {
  Eigen::VectorXd step(sized.columns());
  for (std::size_t b = 1; b < from.bodies.size(); ++b) {
    const Eigen::Index column = column_of(static_cast<int>(b));
    step.segment<2>(column) = to.bodies[b].X_WB.p_WB - from.bodies[b].X_WB.p_WB;
    step(column + 2) = sized.size * (to.bodies[b].theta - from.bodies[b].theta);
  }
  return step;
}

std::optional<MechanismPosition> assemble_near(const Mechanism& mechanism,
                                               const MechanismPosition& position) {
  return begin_to_roll(sized_mechanism(mechanism), {}, position);
}

std::optional<MechanismPosition> assemble_near_poses(const Mechanism& mechanism,
                                                     const std::vector<double>& drivers) {
  const SizedMechanism sized = sized_mechanism(mechanism);
  return begin_to_roll(sized, drivers, posed(sized));
}

}  // namespace higherpair
