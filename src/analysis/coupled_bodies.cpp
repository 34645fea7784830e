#include "coupled_bodies.hpp"

#include "higherpair/geometry/newton.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>
#include <Eigen/QR>

namespace higherpair {
namespace {

constexpr int kMaxSteps = 30;
constexpr double kMaxStep = 0.3;  // of an angle [rad], or of the size
constexpr double kRankTolerance = 1e-10;
constexpr double kAllButSingular = 1e-6;  // determinant, scaled
constexpr double kSingularStep = 1e-6;    // of the size
constexpr double kClosed = 1e-14;         // of the size

Eigen::Vector3d at_rest(int /*body*/) {
  return Eigen::Vector3d::Zero();
}

// The conditions of a group as a linear system in the rates of its bodies; angles count as lengths by the
// size.
struct System {
  Eigen::MatrixXd J;      // rows by (x, y, size·θ) of the group's bodies
  Eigen::VectorXd known;  // what known bodies contribute to each row
};

std::ptrdiff_t column_of(const Group& group, int body) {
  const auto found = std::find(group.bodies.begin(), group.bodies.end(), body);
  return found == group.bodies.end() ? -1 : 3 * (found - group.bodies.begin());
}

// \param rate_of  (x, y, θ) rates of a known body
template <class F>
System make_system(const Group& group, const std::vector<ConstraintRow>& rows, double size, F rate_of) {
  const auto n = static_cast<std::ptrdiff_t>(rows.size());
  System system{Eigen::MatrixXd::Zero(n, 3 * static_cast<std::ptrdiff_t>(group.bodies.size())),
                Eigen::VectorXd::Zero(n)};
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const ConstraintRow& row = rows[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < row.body.size(); ++k) {
      const std::ptrdiff_t column = column_of(group, row.body[k]);
      if (column < 0) {
        system.known(i) += row.coefficient[k].dot(rate_of(row.body[k]));
        continue;
      }
      system.J(i, column) += row.coefficient[k].x();
      system.J(i, column + 1) += row.coefficient[k].y();
      system.J(i, column + 2) += row.coefficient[k].z() / size;
    }
  }
  return system;
}

// Solves J x = b: exactly where J is square, by least squares where conditions are in surplus, or where
// `repeating` ones may leave some freedom: then by the least step.
class Solver {
public:
  explicit Solver(const Eigen::MatrixXd& J, bool repeating = false)
      : square_(J.rows() == J.cols() && !repeating) {
    if (square_) {
      lu_.compute(J);
    } else {
      orthogonal_.setThreshold(kRankTolerance);
      orthogonal_.compute(J);
    }
  }

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    return square_ ? Eigen::VectorXd(lu_.solve(b)) : Eigen::VectorXd(orthogonal_.solve(b));
  }

  // The determinant, scaled; its sign is that of the branch. 1 where there is a surplus of conditions.
  [[nodiscard]] double determinant() const {
    if (!square_) {
      return 1;
    }
    const Eigen::MatrixXd& factors = lu_.matrixLU();
    double smallest = INFINITY;
    auto sign = static_cast<double>(lu_.permutationP().determinant());
    for (Eigen::Index i = 0; i < factors.rows(); ++i) {
      smallest = std::min(smallest, std::abs(factors(i, i)));
      sign *= factors(i, i) < 0 ? -1 : 1;
    }
    return sign * smallest;
  }

private:
  bool square_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> orthogonal_;
};

void set_rank(const Solver& solver, GroupState& group) {
  group.sine = solver.determinant();
  group.mode = group.sine < 0 ? -1 : 1;
  group.noise = 1e-14;
}

bool place_contacts(const Planned& model, const Group& group, State& to) {
  for (const int index : group.contacts) {
    const Contact& contact = model.mechanism.contacts[static_cast<std::size_t>(index)];
    ContactMotion& motion = to.contacts[static_cast<std::size_t>(index)];
    const auto at =
        find_common_normal(curve_of(model.mechanism, contact.first),
                           to.bodies[static_cast<std::size_t>(contact.first.body)].X_WB,
                           curve_of(model.mechanism, contact.second),
                           to.bodies[static_cast<std::size_t>(contact.second.body)].X_WB, motion.at.n_W);
    if (!at) {
      return false;
    }
    motion.at = *at;
    motion.phi = nearest_turn(angle_of(at->n_W), motion.phi);
  }
  return true;
}

void predict(const Group& group, const State& from, double h, State& to) {
  for (const int index : group.bodies) {
    const BodyMotion& before = from.bodies[static_cast<std::size_t>(index)];
    BodyMotion& body = to.bodies[static_cast<std::size_t>(index)];
    body.theta = before.theta + h * (before.omega + h / 2 * before.alpha);
    body.X_WB = {Rotation<double>::from_angle(body.theta),
                 before.X_WB.p_WB + h * (before.v_WB + h / 2 * before.a_WB)};
  }
  for (const int index : group.contacts) {
    const ContactMotion& before = from.contacts[static_cast<std::size_t>(index)];
    ContactMotion& motion = to.contacts[static_cast<std::size_t>(index)];
    motion = before;
    motion.phi += h * before.rates.phi_dot;
    motion.at.n_W = Rotation<double>::from_angle(h * before.rates.phi_dot) * before.at.n_W;
  }
}

bool is_idle(const Planned& model, int body) {
  const std::vector<int>& idle = model.plan.idle_bodies;
  return std::find(idle.begin(), idle.end(), body) != idle.end();
}

// A body whose turning nothing sets keeps its angle: size·(θ - predicted θ) = 0.
void append_idle_rows(const Planned& model, const Group& group, std::vector<ConstraintRow>& rows) {
  for (const int body : group.bodies) {
    if (is_idle(model, body)) {
      ConstraintRow row;
      row.body = {0, body};
      row.coefficient[1].z() = model.plan.size;
      rows.push_back(row);
    }
  }
}

// Takes away what rounding leaves of an idle body's turning.
void hold_idle(const Planned& model, const Group& group, Eigen::VectorXd& change) {
  for (std::size_t i = 0; i < group.bodies.size(); ++i) {
    if (is_idle(model, group.bodies[i])) {
      change(static_cast<Eigen::Index>(3 * i + 2)) = 0;
    }
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

void hold_angles(const std::vector<int>& held, const State& from, const State& to, double size,
                 std::vector<ConstraintRow>& rows) {
  for (const int body : held) {
    const auto index = static_cast<std::size_t>(body);
    ConstraintRow row;
    row.body[1] = body;
    row.coefficient[1].z() = size;
    row.value = size * (to.bodies[index].theta - from.bodies[index].theta);
    rows.push_back(row);
  }
}

Eigen::VectorXd column_of(const std::vector<ConstraintRow>& rows, double ConstraintRow::*member) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    values(static_cast<Eigen::Index>(i)) = rows[i].*member;
  }
  return values;
}

}  // namespace

void group_rows(const Planned& model, const Group& group, const std::vector<DriverMotion>& drivers,
                const State& state, std::vector<ConstraintRow>& rows) {
  const Mechanism& mechanism = model.mechanism;
  const double size = model.plan.size;
  rows.clear();
  for (const int index : group.joints) {
    append_rows(mechanism, mechanism.joints[static_cast<std::size_t>(index)], state.bodies, size, rows);
  }
  for (const int index : group.contacts) {
    append_rows(mechanism, mechanism.contacts[static_cast<std::size_t>(index)],
                state.contacts[static_cast<std::size_t>(index)], state.bodies, rows);
  }
  for (const int index : group.drivers) {
    const Driver& driver = mechanism.drivers[static_cast<std::size_t>(index)];
    const DriverMotion& motion = drivers[static_cast<std::size_t>(index)];
    append_driver_row(mechanism, mechanism.joints[static_cast<std::size_t>(driver.joint)], motion.position,
                      motion.velocity, motion.acceleration, state.bodies, size, rows);
  }
}

namespace {

Solver solver_at(const Planned& model, std::size_t g, const State& state) {
  const Group& group = model.plan.groups[g];
  std::vector<ConstraintRow> rows;
  group_rows(model, group, std::vector<DriverMotion>(model.mechanism.drivers.size()), state, rows);
  append_idle_rows(model, group, rows);
  return Solver(make_system(group, rows, model.plan.size, at_rest).J);
}

}  // namespace

GroupStatus place_coupled(const Planned& model, std::size_t g, const State& from, double h,
                          const std::vector<double>& drivers, State& to,
                          const std::optional<std::vector<int>>& held) {
  const Group& group = model.plan.groups[g];
  const double size = model.plan.size;
  std::vector<DriverMotion> targets(drivers.size());
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    targets[i].position = drivers[i];
  }
  predict(group, from, h, to);
  std::vector<ConstraintRow> rows;
  double last = INFINITY;
  for (int i = 0; i < kMaxSteps; ++i) {
    if (!place_contacts(model, group, to)) {
      return GroupStatus::kNotConverged;
    }
    group_rows(model, group, targets, to, rows);
    if (held) {
      hold_angles(*held, from, to, size, rows);
    }
    append_idle_rows(model, group, rows);
    const System system = make_system(group, rows, size, at_rest);
    const Eigen::VectorXd values = column_of(rows, &ConstraintRow::value);
    const Solver solver(system.J, held.has_value());
    Eigen::VectorXd step = solver.solve(-values);
    if (!step.allFinite()) {
      step = Solver(system.J, true).solve(-values);
    }
    hold_idle(model, group, step);
    const double length = step.cwiseAbs().maxCoeff() / size;
    // Where the conditions have lost their rank the steps fall to the root of rounding only.
    const bool singular = std::abs(solver.determinant()) <= kAllButSingular && length <= kSingularStep &&
                          values.cwiseAbs().maxCoeff() <= kClosed * size;
    if (singular || newton_has_settled(length, last, 1e-9)) {
      set_rank(solver, to.groups[g]);
      return column_of(rows, &ConstraintRow::value).cwiseAbs().maxCoeff() <= 1e-9 * size
                 ? GroupStatus::kOk
                 : GroupStatus::kOutOfReach;
    }
    last = length;
    step *= std::min(1.0, kMaxStep / length);
    add_step(group, step, size, to);
  }
  return GroupStatus::kNotConverged;
}

void judge_coupled(const Planned& model, std::size_t g, State& state) {
  set_rank(solver_at(model, g, state), state.groups[g]);
}

double coupled_sine(const Planned& model, std::size_t g, const State& state) {
  return solver_at(model, g, state).determinant();
}

void move_coupled(const Planned& model, std::size_t g, const std::vector<DriverMotion>& drivers,
                  State& state) {
  const Group& group = model.plan.groups[g];
  const double size = model.plan.size;
  for (const int index : group.bodies) {
    BodyMotion& body = state.bodies[static_cast<std::size_t>(index)];
    body.v_WB.setZero();
    body.omega = 0;
    body.a_WB.setZero();
    body.alpha = 0;
  }
  const auto body_at = [&](int index) -> BodyMotion& {
    return state.bodies[static_cast<std::size_t>(index)];
  };
  std::vector<ConstraintRow> rows;
  group_rows(model, group, drivers, state, rows);
  append_idle_rows(model, group, rows);
  const System velocity = make_system(group, rows, size, [&](int body) {
    return Eigen::Vector3d(body_at(body).v_WB.x(), body_at(body).v_WB.y(), body_at(body).omega);
  });
  const Solver solver(velocity.J);
  // The rates of the group's bodies, from what the conditions want of them.
  const auto solve = [&](const Eigen::VectorXd& wanted, const auto& set) {
    Eigen::VectorXd rates = solver.solve(wanted);
    hold_idle(model, group, rates);
    for (std::size_t i = 0; i < group.bodies.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(3 * i);
      set(body_at(group.bodies[i]), rates.segment<2>(column), rates(column + 2) / size);
    }
  };
  solve(column_of(rows, &ConstraintRow::rate) - velocity.known,
        [](BodyMotion& body, const Vector2d& v_W, double omega) {
          body.v_WB = v_W;
          body.omega = omega;
        });
  for (const int index : group.contacts) {
    set_contact_rates(model, index, state);
  }
  group_rows(model, group, drivers, state, rows);
  append_idle_rows(model, group, rows);
  const System acceleration = make_system(group, rows, size, [&](int body) {
    return Eigen::Vector3d(body_at(body).a_WB.x(), body_at(body).a_WB.y(), body_at(body).alpha);
  });
  solve(-column_of(rows, &ConstraintRow::gamma) - acceleration.known,
        [](BodyMotion& body, const Vector2d& a_W, double alpha) {
          body.a_WB = a_W;
          body.alpha = alpha;
        });
}

}  // namespace higherpair
