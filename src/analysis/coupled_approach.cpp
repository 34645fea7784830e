#include "coupled_bodies.hpp"
#include "coupled_system.hpp"
#include "numeric/least_squares.hpp"
#include "numeric/singular_values.hpp"
#include "tolerances.hpp"

#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Cholesky>

// Where coupled bodies violate their conditions least, and the solution next to it.

namespace higherpair {
namespace {

// The sum of squares of a group's conditions over the change of its bodies' coordinates from where they are
// in `from`, both of the size.
class Violation {
public:
  Violation(const Planned& model, const Group& group, const State& from, const std::vector<double>& drivers,
            State& to)
      : model_(model), group_(group), from_(from), drivers_(drivers), to_(to) {}

  [[nodiscard]] Eigen::Index unknowns() const { return 3 * static_cast<Eigen::Index>(group_.bodies.size()); }

  /// Leads the bodies of `to` there; false where contacts have no common normal.
  [[nodiscard]] bool lead(const Eigen::VectorXd& change) const {
    take_group(group_, from_, to_);
    add_step(group_, size() * change, size(), to_);
    return place_contacts(model_, group_, to_);
  }
  [[nodiscard]] bool values(const Eigen::VectorXd& change, Eigen::VectorXd& r) const {
    if (!lead(change)) return false;
    r = values_of(rows()) / size();
    return true;
  }
  [[nodiscard]] bool jacobian(const Eigen::VectorXd& change, Eigen::MatrixXd& J) const {
    if (!lead(change)) return false;
    J = jacobian_of(group_, rows(), size());
    return true;
  }

private:
  [[nodiscard]] double size() const { return model_.plan.size; }
  [[nodiscard]] std::vector<ConstraintRow> rows() const {
    return group_rows(model_, group_, drivers_, to_, to_.contacts);
  }

  const Planned& model_;
  const Group& group_;
  const State& from_;
  const std::vector<double>& drivers_;
  State& to_;
};

// Newton's method from no change: where no solution is near, conditions that are left over bend the sum of
// squares as much as their derivatives do, which the method of Levenberg and Marquardt has to find out step
// by step. None where it leads elsewhere than to a least sum.
std::optional<Eigen::VectorXd> least_nearby(const Violation& violation) {
  Eigen::VectorXd change = Eigen::VectorXd::Zero(violation.unknowns());
  Eigen::VectorXd r;
  Eigen::MatrixXd J, beside;
  for (int i = 0; i < kApproachSteps; ++i) {
    if (!violation.values(change, r) || !violation.jacobian(change, J)) return std::nullopt;
    Eigen::MatrixXd H = J.transpose() * J;
    for (Eigen::Index k = 0; k < change.size(); ++k) {
      Eigen::VectorXd nudged = change;
      nudged(k) += kApproachDifference;
      if (!violation.jacobian(nudged, beside)) return std::nullopt;
      H.col(k) += (beside - J).transpose() * r / kApproachDifference;
    }
    const Eigen::LLT<Eigen::MatrixXd> factor((H + H.transpose()) / 2);
    if (factor.info() != Eigen::Success) return std::nullopt;
    const Eigen::VectorXd step = -factor.solve(J.transpose() * r);
    const double length = step.cwiseAbs().maxCoeff();
    if (!(length <= kLargestCoupledStep)) return std::nullopt;
    change += step;
    if (length <= kApproachSettled) return change;
  }
  return std::nullopt;
}

// True where the least sum of squares near no change is all but 0; `to` is there. Where it is far away, `to`
// is not moved.
bool approach(const Violation& violation) {
  Eigen::VectorXd r;
  if (const auto change = least_nearby(violation)) {
    return violation.values(*change, r) && r.norm() <= kCoupledApproach;
  }
  LeastSquaresProblem problem;
  problem.residuals = [&](const Eigen::VectorXd& x, Eigen::VectorXd& out) {
    return violation.values(x, out);
  };
  problem.jacobian = [&](const Eigen::VectorXd& x, Eigen::MatrixXd& J) { return violation.jacobian(x, J); };
  LeastSquaresOptions options;
  options.rounding = kCoupledClosure;
  const LeastSquaresFit fit = least_squares(problem, Eigen::VectorXd::Zero(violation.unknowns()), options);
  if (!(fit.x.cwiseAbs().maxCoeff() <= kFarthestApproach)) {
    (void)violation.lead(Eigen::VectorXd::Zero(violation.unknowns()));
    return false;
  }
  return violation.lead(fit.x) && fit.sum <= kCoupledApproach * kCoupledApproach;
}

// Where a group's bodies have gone from `from` to `to`: (x, y, size·θ) of each.
Eigen::VectorXd change_between(const Group& group, const State& from, const State& to, double size) {
  Eigen::VectorXd change(3 * static_cast<Eigen::Index>(group.bodies.size()));
  for (std::size_t i = 0; i < group.bodies.size(); ++i) {
    const BodyMotion& a = from.bodies[static_cast<std::size_t>(group.bodies[i])];
    const BodyMotion& b = to.bodies[static_cast<std::size_t>(group.bodies[i])];
    const Vector2d moved = b.X_WB.p_WB - a.X_WB.p_WB;
    change.segment<3>(static_cast<Eigen::Index>(3 * i)) << moved, size * (b.theta - a.theta);
  }
  return change;
}

// Two solutions that have met in a limit differ along the direction in which the conditions change least, and
// have determinants of opposite signs. From one of them, at `to`, to where the other one should be: as far
// beyond where the determinant is 0, or, if they are far apart already, beyond where the bodies came from.
std::array<Eigen::VectorXd, 2> ways_across(const Planned& model, std::size_t g, const State& from,
                                           const std::vector<double>& drivers, const State& to) {
  const Group& group = model.plan.groups[g];
  const double size = model.plan.size;
  const Eigen::MatrixXd J = jacobian_of(group, group_rows(model, group, drivers, to, to.contacts), size);
  const Eigen::MatrixXd V = singular_values(J).V;
  const Eigen::VectorXd least = V.col(V.cols() - 1);
  State beside = to;
  add_step(group, size * kApproachDifference * least, size, beside);
  const double sine = coupled_sine(model, g, to);
  const bool touches = place_contacts(model, group, beside);
  const double rise = touches ? coupled_sine(model, g, beside) - sine : 0;
  const double to_zero = rise * sine < 0 ? -kApproachDifference * sine / rise : 0;
  return {2 * size * to_zero * least, -2 * least.dot(change_between(group, from, to, size)) * least};
}

}  // namespace

GroupStatus place_coupled_anew(const Planned& model, std::size_t g, const State& from,
                               const std::vector<double>& drivers, State& to) {
  const Group& group = model.plan.groups[g];
  const int mode = to.groups[g].mode;
  if (!approach(Violation(model, group, from, drivers, to))) {
    return GroupStatus::kOutOfReach;
  }
  State near = to;
  const auto place_from = [&](const State& state) { return place_coupled(model, g, state, 0, drivers, to); };
  if (place_from(near) != GroupStatus::kOk) {
    take_group(group, near, to);
    return GroupStatus::kOutOfReach;
  }
  if (to.groups[g].mode == mode) {
    return GroupStatus::kOk;
  }
  take_group(group, to, near);
  for (const Eigen::VectorXd& way : ways_across(model, g, from, drivers, near)) {
    State across = near;
    add_step(group, way, model.plan.size, across);
    if (place_from(across) == GroupStatus::kOk && to.groups[g].mode == mode) {
      return GroupStatus::kOk;
    }
  }
  take_group(group, from, to);
  return GroupStatus::kNotConverged;
}

}  // namespace higherpair
