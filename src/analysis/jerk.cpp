#include "higherpair/analysis/jerk.hpp"

#include <algorithm>

#include <Eigen/LU>
#include <Eigen/QR>

namespace higherpair {
namespace {

constexpr double kRankTolerance = 1e-12;  // of the largest pivot

using Jerks = std::vector<std::optional<BodyJerk>>;

// The rows of a group and their third derivatives.
struct Conditions {
  std::vector<ConstraintRow> rows;
  std::vector<double> deltas;
  std::vector<bool> along_tangent;  // of a rolling contact
};

void drop_tangential(Conditions& conditions) {
  Conditions kept;
  for (std::size_t i = 0; i < conditions.rows.size(); ++i) {
    if (!conditions.along_tangent[i]) {
      kept.rows.push_back(conditions.rows[i]);
      kept.deltas.push_back(conditions.deltas[i]);
    }
  }
  conditions = std::move(kept);
}

Conditions conditions_of(const Run& run, const Group& group, ContactShape shape) {
  const Mechanism& mechanism = run.mechanism;
  const std::vector<BodyMotion>& bodies = run.row.bodies;
  const double size = run.plan.size;
  Conditions conditions;
  for (const int index : group.joints) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
    append_rows(mechanism, joint, bodies, size, conditions.rows);
    append_jerk_terms(mechanism, joint, bodies, conditions.deltas);
  }
  conditions.along_tangent.assign(conditions.rows.size(), false);
  for (const int index : group.contacts) {
    const Contact& contact = mechanism.contacts[static_cast<std::size_t>(index)];
    const ContactMotion& motion = run.row.contacts[static_cast<std::size_t>(index)];
    append_rows(mechanism, contact, motion, bodies, conditions.rows);
    append_jerk_terms(mechanism, contact, motion, bodies, shape, conditions.deltas);
    conditions.along_tangent.push_back(false);
    conditions.along_tangent.resize(conditions.rows.size(), true);
  }
  for (const int index : group.drivers) {
    const int driven = mechanism.drivers[static_cast<std::size_t>(index)].joint;
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(driven)];
    append_driver_row(mechanism, joint, 0, 0, 0, bodies, size, conditions.rows);
    append_driver_jerk_term(mechanism, joint, bodies, conditions.deltas);
  }
  // A body whose turning nothing sets keeps its angle.
  for (const int body : run.plan.idle_bodies) {
    if (std::find(group.bodies.begin(), group.bodies.end(), body) != group.bodies.end()) {
      ConstraintRow hold;
      hold.body = {0, body, 0};
      hold.coefficient[1].z() = size;
      conditions.rows.push_back(hold);
      conditions.deltas.push_back(0);
    }
  }
  conditions.along_tangent.resize(conditions.rows.size(), false);
  return conditions;
}

// J x = b for the jerks x = (j_x, j_y, size·α̇) of the group's bodies, those of the others being known.
struct System {
  Eigen::MatrixXd J;
  Eigen::VectorXd b;
};

System system_of(const Group& group, const Conditions& conditions, double size, const Jerks& known) {
  const auto n = static_cast<Eigen::Index>(conditions.rows.size());
  System system{Eigen::MatrixXd::Zero(n, 3 * static_cast<Eigen::Index>(group.bodies.size())),
                Eigen::VectorXd::Zero(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const ConstraintRow& row = conditions.rows[static_cast<std::size_t>(i)];
    system.b(i) = -conditions.deltas[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < row.body.size(); ++k) {
      const Eigen::Vector3d& c = row.coefficient[k];
      const auto found = std::find(group.bodies.begin(), group.bodies.end(), row.body[k]);
      if (found != group.bodies.end()) {
        system.J.block<1, 3>(i, 3 * (found - group.bodies.begin())) +=
            Eigen::RowVector3d(c.x(), c.y(), c.z() / size);
      } else if (const auto& jerk = known[static_cast<std::size_t>(row.body[k])]) {
        system.b(i) -= c.dot(Eigen::Vector3d(jerk->j_WB.x(), jerk->j_WB.y(), jerk->angular));
      }
    }
  }
  return system;
}

// By least squares where conditions are in surplus, which they then repeat; none where they leave freedom.
std::optional<Eigen::VectorXd> solve(const System& system) {
  if (system.J.rows() < system.J.cols()) {
    return std::nullopt;
  }
  Eigen::VectorXd x;
  if (system.J.rows() == system.J.cols()) {
    Eigen::FullPivLU<Eigen::MatrixXd> lu(system.J);
    lu.setThreshold(kRankTolerance);
    if (!lu.isInvertible()) {
      return std::nullopt;
    }
    x = lu.solve(system.b);
  } else {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(system.J);
    qr.setThreshold(kRankTolerance);
    if (qr.rank() < system.J.cols()) {
      return std::nullopt;
    }
    x = qr.solve(system.b);
  }
  return x.allFinite() ? std::optional(x) : std::nullopt;
}

// A body on a pin whose turning nothing sets.
BodyJerk idle_jerk(const Run& run, const IdleBody& idle, const Jerks& known) {
  const auto carrier = static_cast<std::size_t>(idle.pin.body);
  return {point_jerk(run.row.bodies[carrier], known[carrier].value_or(BodyJerk{}), idle.pin.p_B), 0};
}

// False where the jerks are not defined.
bool add_group(const Run& run, const Group& group, ContactShape shape, Jerks& jerks) {
  if (const auto* idle = std::get_if<IdleBody>(&group.kind)) {
    jerks[static_cast<std::size_t>(idle->body)] = idle_jerk(run, *idle, jerks);
    return true;
  }
  Conditions conditions = conditions_of(run, group, shape);
  // Two joints to ground and a contact that rolls: only the curves themselves fulfil all four rows, and the
  // link takes the place of the condition along n.
  if (shape == ContactShape::kFrozen && conditions.rows.size() > 3 * group.bodies.size()) {
    drop_tangential(conditions);
  }
  const auto x = solve(system_of(group, conditions, run.plan.size, jerks));
  for (std::size_t i = 0; x && i < group.bodies.size(); ++i) {
    const Eigen::Vector3d jerk = x->segment<3>(static_cast<Eigen::Index>(3 * i));
    jerks[static_cast<std::size_t>(group.bodies[i])] = BodyJerk{jerk.head<2>(), jerk.z() / run.plan.size};
  }
  return x.has_value();
}

Jerks jerks_with(const Run& run, ContactShape shape) {
  const MotionRow& row = run.row;
  Jerks jerks(row.bodies.size());
  jerks.front() = BodyJerk{};
  for (const Group& group : run.plan.groups) {
    const bool has_rates = std::all_of(group.bodies.begin(), group.bodies.end(), [&](int body) {
      return row.has_rates[static_cast<std::size_t>(body)];
    });
    // What comes after may hang on it.
    if (!has_rates || !add_group(run, group, shape, jerks)) {
      break;
    }
  }
  return jerks;
}

}  // namespace

JerkRow jerks_of(const Run& run) {
  if (run.row.status == RowStatus::kNotAssemblable) {
    const Jerks none(run.row.bodies.size());
    return {none, none};
  }
  JerkRow jerks{jerks_with(run, ContactShape::kTrue), {}};
  jerks.linkage = run.mechanism.contacts.empty() ? jerks.bodies : jerks_with(run, ContactShape::kFrozen);
  return jerks;
}

std::optional<double> joint_jerk(const Run& run, int joint,
                                 const std::vector<std::optional<BodyJerk>>& bodies) {
  // The row of a driver on this joint is its coordinate.
  const Joint& at = run.mechanism.joints[static_cast<std::size_t>(joint)];
  std::vector<ConstraintRow> rows;
  std::vector<double> deltas;
  append_driver_row(run.mechanism, at, 0, 0, 0, run.row.bodies, 1, rows);
  append_driver_jerk_term(run.mechanism, at, run.row.bodies, deltas);
  double value = deltas.front();
  for (std::size_t k = 0; k < rows.front().body.size(); ++k) {
    const auto& jerk = bodies[static_cast<std::size_t>(rows.front().body[k])];
    if (!jerk) {
      return std::nullopt;
    }
    value += rows.front().coefficient[k].dot(Eigen::Vector3d(jerk->j_WB.x(), jerk->j_WB.y(), jerk->angular));
  }
  return value;
}

}  // namespace higherpair
