#include "coupled_bodies.hpp"

#include "analysis/rates/series_motion.hpp"
#include "analysis/tolerances.hpp"
#include "coupled_system.hpp"
#include "group_kinds.hpp"
#include "group_solver.hpp"
#include "higherpair/numeric/contains.hpp"
#include "higherpair/numeric/newton.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "numeric/least_norm.hpp"
#include "numeric/lu_solver.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr int kMaxSteps = 30;

// Solves J x = b: exactly if J is square; by least squares if there are surplus conditions; with the least
// step if conditions are `repeating` and may leave some freedom.
class Solver {
public:
  explicit Solver(const Eigen::MatrixXd& J, bool repeating = false)
      : square_(J.rows() == J.cols() && !repeating), has_surplus_(J.rows() > J.cols() && !repeating) {
    if (square_) {
      lu_.compute(J);
    } else {
      least_norm_.compute(J);
    }
  }

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    if (square_) {
      return lu_.solve(b);
    }
    return least_norm_.solve(b);
  }

  // The smallest pivot with the sign of the determinant, which is that of the branch. If there are surplus
  // conditions: 1, or 0 where all of them together do not determine the bodies.
  [[nodiscard]] double determinant() const {
    if (!square_) {
      return has_surplus_ && least_norm_.rank() < least_norm_.columns() ? 0 : 1;
    }
    return lu_.sign() * lu_.pivots().cwiseAbs().minCoeff();
  }

private:
  bool square_, has_surplus_;
  LuSolver lu_;
  LeastNormSolver least_norm_{kCoupledRank};
};

void set_rank(const Solver& solver, GroupState& group) {
  group.sine = solver.determinant();
  group.mode = group.sine < 0 ? -1 : 1;
  group.noise = kCoupledRounding;
}

void predict(const Group& group, const State& from, double h, State& to) {
  for (const int index : group.bodies) {
    const BodyMotion& before = from.bodies[index];
    BodyMotion& body = to.bodies[index];
    body.theta = predicted_angle(from, index, h);
    body.X_WB = {Rotation<double>::from_angle(body.theta),
                 before.X_WB.p_WB + h * (before.v_WB + h / 2 * before.a_WB)};
  }
  for (const int index : group.contacts) {
    const ContactMotion& before = from.contacts[index];
    ContactMotion& motion = to.contacts[index];
    motion = before;
    motion.phi += h * before.rates.phi_dot;
    motion.at.n_W = Rotation<double>::from_angle(h * before.rates.phi_dot) * before.at.n_W;
  }
}

bool is_idle(const Planned& model, int body) {
  return contains(model.plan.idle_bodies, body);
}

// Removes the turn of idle bodies that rounding has left.
void hold_idle(const Planned& model, const Group& group, Eigen::VectorXd& change) {
  for (std::size_t i = 0; i < group.bodies.size(); ++i) {
    if (is_idle(model, group.bodies[i])) {
      change(static_cast<Eigen::Index>(3 * i + 2)) = 0;
    }
  }
}

// Far out on open curves the two contact points lie apart along the curves by a rounding of the normal's
// angle times the radii of curvature. One point between them is therefore used for both bodies.
Solver solver_at(const Planned& model, std::size_t g, const State& state) {
  const Group& group = model.plan.groups[g];
  std::vector<ContactMotion> contacts = state.contacts;
  for (const int index : group.contacts) {
    CommonNormal& at = contacts[index].at;
    at.p1_W = at.p2_W = at.p_W();
  }
  const std::vector<DriverMotion> drivers(model.mechanism.drivers.size());
  return Solver(jacobian_of(group, group_rows(model, group, drivers, state, contacts), model.plan.size));
}

// Number of the rows of a group's joints, which come first.
std::ptrdiff_t joint_row_count(const Mechanism& mechanism, const Group& group) {
  std::ptrdiff_t count = 0;
  for (const int index : group.joints) {
    count += row_count(mechanism.joints[index]);
  }
  return count;
}

// The residuals of the conditions of a group's contacts, differentiated `order` times, for the present
// motions of the bodies; the second derivative needs the contacts' rates. To first order the turning of the
// normal changes neither gap nor slip, and the contact points of rolling bodies differ in acceleration along
// the normal alone. The derivatives of the conditions themselves contain further terms as large as the radius
// of curvature or its derivative: far out on an open curve their difference would be rounding.
std::vector<double> contact_derivatives(const Mechanism& mechanism, const Group& group, std::size_t order,
                                        const State& state) {
  std::vector<double> values;
  for (const int index : group.contacts) {
    const Contact& contact = mechanism.contacts[index];
    const ContactMotion& motion = state.contacts[index];
    const Vector2d p_W = motion.at.p_W();
    const Vector2d& n_W = motion.at.n_W;
    const PointMotion one = motion_at_place(state.bodies[contact.first.body], p_W);
    const PointMotion two = motion_at_place(state.bodies[contact.second.body], p_W);
    const Vector2d apart = order == 1 ? Vector2d(two.v_W - one.v_W) : Vector2d(two.a_W - one.a_W);
    values.push_back(n_W.dot(apart) - (order == 1 ? 0 : motion.rates.normal_acceleration));
    if (contact.rolling) {
      values.push_back(perp(n_W).dot(apart));
    }
  }
  return values;
}

// The length of a step of Newton's method: of turns [rad], and of slides as fractions of the size; of a body
// far away as a fraction of its distance, which its slides' rounding is proportional to.
double length_of(const Planned& model, const Group& group, const State& at, const Eigen::VectorXd& step) {
  const Vector2d ground = place_of_ground(model.mechanism);
  const double size = model.plan.size;
  double length = 0;
  for (std::size_t k = 0; k < group.bodies.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(3 * k);
    const double distance = (at.bodies[group.bodies[k]].X_WB.p_WB - ground).norm();
    const double unit = distance > kFarAway * size ? distance : size;
    length = std::max({length, std::abs(step(column)) / unit, std::abs(step(column + 1)) / unit,
                       std::abs(step(column + 2)) / size});
  }
  return length;
}

}  // namespace

GroupStatus place_coupled(const Planned& model, std::size_t g, const State& from, double h,
                          const std::vector<DriverMotion>& drivers, State& to,
                          const std::optional<std::vector<int>>& held) {
  const Group& group = model.plan.groups[g];
  const double size = model.plan.size;
  predict(group, from, h, to);
  double last = kInf;
  for (int i = 0; i < kMaxSteps; ++i) {
    if (!place_contacts(model, group, to)) {
      return GroupStatus::kNotConverged;
    }
    std::vector<ConstraintRow> rows = group_rows(model, group, drivers, to, to.contacts);
    if (held) {
      hold_angles(*held, from, to, size, rows);
    }
    const Eigen::MatrixXd J = jacobian_of(group, rows, size);
    const Eigen::VectorXd values = values_of(rows);
    const Solver solver(J, held.has_value());
    Eigen::VectorXd step = solver.solve(-values);
    if (!step.allFinite()) {
      step = Solver(J, true).solve(-values);
    }
    hold_idle(model, group, step);
    const double length = length_of(model, group, to, step);
    // Where the conditions have lost their rank, the steps of Newton's method fall only to the square root of
    // rounding.
    const bool singular = std::abs(solver.determinant()) <= kAllButSingular && length <= kSingularStep &&
                          values.cwiseAbs().maxCoeff() <= kCoupledClosure * size;
    if (singular || newton_has_settled(length, last, kCoupledNear)) {
      set_rank(solver, to.groups[g]);
      return values.cwiseAbs().maxCoeff() <= kCoupledResidual * size ? GroupStatus::kOk
                                                                     : GroupStatus::kOutOfReach;
    }
    last = length;
    step *= std::min(1.0, kLargestCoupledStep / length);
    for (std::size_t k = 0; k < group.bodies.size(); ++k) {
      add_step(step.segment<3>(static_cast<Eigen::Index>(3 * k)), size, to.bodies[group.bodies[k]]);
    }
  }
  return GroupStatus::kNotConverged;
}

void judge_coupled(const Planned& model, std::size_t g, State& state) {
  set_rank(solver_at(model, g, state), state.groups[g]);
}

double coupled_sine(const Planned& model, std::size_t g, const State& state) {
  return solver_at(model, g, state).determinant();
}

// With the known bodies moving and the group's bodies at rest, the conditions have a residual at each order
// of time, which the motion of the group's bodies must cancel.
void move_coupled(const Planned& model, std::size_t g, const std::vector<DriverMotion>& drivers,
                  State& state) {
  using Series = PowerSeries<double, 2>;
  const Group& group = model.plan.groups[g];
  const double size = model.plan.size;
  const Solver solver = solver_at(model, g, state);
  const Dimensions<double> dimensions = dimensions_of(model.mechanism);
  ConditionSet set = condition_set(model.plan, group);
  set.contacts.clear();
  for (const int index : group.bodies) {
    BodyMotion& body = state.bodies[index];
    body = {body.X_WB, body.theta};
  }
  Coordinates<Series> at = constant<Series>(coordinates_of(model.mechanism, state.bodies, state.contacts));
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    at.drivers[i] = series_of_driver<2>(drivers[i]);
  }
  const auto solve = [&](std::size_t order) {
    for (std::size_t i = 0; i < state.bodies.size(); ++i) {
      at.bodies[i] = series_of_body<2>(state.bodies[i]);
    }
    std::vector<Series> conditions;
    append_conditions(dimensions, set, at, size, conditions);
    std::vector<double> left;
    for (const Series& condition : conditions) {
      left.push_back(kFactorials[order] * condition.c[order]);
    }
    const std::vector<double> contacts = contact_derivatives(model.mechanism, group, order, state);
    left.insert(left.begin() + joint_row_count(model.mechanism, group), contacts.begin(), contacts.end());
    Eigen::VectorXd rates =
        solver.solve(-Eigen::Map<Eigen::VectorXd>(left.data(), static_cast<Eigen::Index>(left.size())));
    hold_idle(model, group, rates);
    return rates;
  };
  const auto set_rates = [&](const Eigen::VectorXd& rates, Vector2d BodyMotion::*linear,
                             double BodyMotion::*angular) {
    for (std::size_t i = 0; i < group.bodies.size(); ++i) {
      BodyMotion& body = state.bodies[group.bodies[i]];
      const auto column = static_cast<Eigen::Index>(3 * i);
      body.*linear = rates.segment<2>(column);
      body.*angular = rates(column + 2) / size;
    }
  };
  set_rates(solve(1), &BodyMotion::v_WB, &BodyMotion::omega);
  for (const int index : group.contacts) {
    set_contact_rates(model, index, state);
  }
  set_rates(solve(2), &BodyMotion::a_WB, &BodyMotion::alpha);
}

}  // namespace higherpair
