#include "analysis/follow/joint_ends.hpp"
#include "analysis/tolerances.hpp"
#include "coupled_bodies.hpp"
#include "coupled_system.hpp"
#include "group_kinds.hpp"
#include "higherpair/numeric/contains.hpp"
#include "numeric/least_squares.hpp"
#include "numeric/lu_solver.hpp"
#include "numeric/singular_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include <Eigen/Cholesky>

// Finds where coupled bodies violate their conditions least, and the solution next to that place.

namespace higherpair {
namespace {

// Centre of the joints and contacts of each body of a group, in ground; the origin of its frame if it has
// none.
std::vector<Vector2d> middles_of(const Planned& model, const Group& group, const State& at) {
  std::vector<Vector2d> middles;
  for (const int body : group.bodies) {
    const std::vector<Vector2d> places = places_of(model, group, at, body);
    const Vector2d sum = std::accumulate(places.begin(), places.end(), Vector2d(0, 0));
    middles.push_back(places.empty() ? at.bodies[body].X_WB.p_WB
                                     : Vector2d(sum / static_cast<double>(places.size())));
  }
  return middles;
}

// Coordinates of bodies about the centres of their joints and contacts: (x, y) of the centre, as fractions of
// the size, and the angle. About the origin of its frame, which may be anywhere, a small turn of a body could
// move it far.
class BodyCoordinates {
public:
  BodyCoordinates(const Planned& model, const Group& group, const State& at)
      : group_(group), size_(model.plan.size), middles_(middles_of(model, group, at)) {}

  [[nodiscard]] Eigen::Index count() const { return 3 * static_cast<Eigen::Index>(group_.bodies.size()); }

  /// Moves the bodies by a change from their original position, in which they still are in `to`.
  void move(const Eigen::VectorXd& change, State& to) const {
    for (std::size_t i = 0; i < group_.bodies.size(); ++i) {
      BodyMotion& body = to.bodies[group_.bodies[i]];
      const double turn = change(first(i) + 2);
      const Vector2d lever = Rotation<double>::from_angle(turn) * Vector2d(body.X_WB.p_WB - middles_[i]);
      body.theta += turn;
      body.X_WB = {Rotation<double>::from_angle(body.theta), moved(i, change) + lever};
    }
  }

  /// Converts the columns of J from derivatives by (x, y, size·θ) to derivatives by these coordinates, after
  /// a change.
  template <class Matrix>
  void transform(const Eigen::VectorXd& change, const State& to, Matrix& J) const {
    for (std::size_t i = 0; i < group_.bodies.size(); ++i) {
      const Vector2d lever = (to.bodies[group_.bodies[i]].X_WB.p_WB - moved(i, change)) / size_;
      J.col(first(i) + 2) += lever.x() * J.col(first(i) + 1) - lever.y() * J.col(first(i));
    }
  }

  /// The change from one state, in which this object was created, to another.
  [[nodiscard]] Eigen::VectorXd change_between(const State& from, const State& to) const {
    Eigen::VectorXd change(count());
    for (std::size_t i = 0; i < group_.bodies.size(); ++i) {
      const BodyMotion& a = from.bodies[group_.bodies[i]];
      const BodyMotion& b = to.bodies[group_.bodies[i]];
      const double turn = b.theta - a.theta;
      const Vector2d lever = Rotation<double>::from_angle(turn) * Vector2d(a.X_WB.p_WB - middles_[i]);
      change.segment<3>(first(i)) << (b.X_WB.p_WB - lever - middles_[i]) / size_, turn;
    }
    return change;
  }

private:
  static Eigen::Index first(std::size_t i) { return 3 * static_cast<Eigen::Index>(i); }
  [[nodiscard]] Vector2d moved(std::size_t i, const Eigen::VectorXd& change) const {
    return middles_[i] + size_ * change.segment<2>(first(i));
  }

  const Group& group_;
  double size_;
  std::vector<Vector2d> middles_;  // centres in ground, of each body of the group
};

// The violation F of a group's conditions as a function of the change of its bodies' coordinates from `from`;
// both relative to the size.
class Violation {
public:
  Violation(const Planned& model, const Group& group, const State& from,
            const std::vector<DriverMotion>& drivers, State& to)
      : model_(model),
        group_(group),
        from_(from),
        drivers_(drivers),
        to_(to),
        coordinates_(model, group, from) {}

  [[nodiscard]] Eigen::Index unknowns() const { return coordinates_.count(); }

  /// Moves the bodies of `to` by a change; false where contacts have no common normal.
  [[nodiscard]] bool lead(const Eigen::VectorXd& change) const {
    take_group(group_, from_, to_);
    coordinates_.move(change, to_);
    return place_contacts(model_, group_, to_);
  }
  [[nodiscard]] bool values(const Eigen::VectorXd& change, Eigen::VectorXd& F) const {
    if (!lead(change)) return false;
    F = values_of(rows()) / size();
    return true;
  }
  [[nodiscard]] bool linear(const Eigen::VectorXd& change, Eigen::VectorXd& F, Eigen::MatrixXd& J) const {
    if (!lead(change)) return false;
    const std::vector<ConstraintRow> all = rows();
    F = values_of(all) / size();
    J = jacobian_of(group_, all, size());
    coordinates_.transform(change, to_, J);
    return true;
  }
  /// Jᵀ weights.
  [[nodiscard]] bool gradient(const Eigen::VectorXd& change, const Eigen::VectorXd& weights,
                              Eigen::VectorXd& g) const {
    if (!lead(change)) return false;
    Eigen::RowVectorXd along = gradient_of(group_, rows(), weights, size()).transpose();
    coordinates_.transform(change, to_, along);
    g = along.transpose();
    return true;
  }
  /// How far bodies have been moved: angles [rad], and positions of joints and contacts relative to the size.
  /// The angle of a body that only rolling turns follows from its contact; that of a small roller is large.
  [[nodiscard]] double farthest() const {
    double farthest = 0;
    for (const int index : group_.bodies) {
      const auto i = static_cast<std::size_t>(index);
      const bool only_rolls = contains(model_.plan.phase_bodies, index);
      farthest = std::max(farthest, only_rolls ? 0 : std::abs(to_.bodies[i].theta - from_.bodies[i].theta));
    }
    const std::vector<Vector2d> before = places_of(model_, group_, from_);
    const std::vector<Vector2d> after = places_of(model_, group_, to_);
    for (std::size_t i = 0; i < before.size(); ++i) {
      farthest = std::max(farthest, (after[i] - before[i]).norm() / size());
    }
    return farthest;
  }

private:
  [[nodiscard]] double size() const { return model_.plan.size; }
  [[nodiscard]] std::vector<ConstraintRow> rows() const {
    return group_rows(model_, group_, drivers_, to_, to_.contacts);
  }

  const Planned& model_;
  const Group& group_;
  const State& from_;
  const std::vector<DriverMotion>& drivers_;
  State& to_;
  BodyCoordinates coordinates_;
};

bool is_all_but_zero(const Eigen::VectorXd& F) {
  return F.norm() <= kCoupledApproach;
}

// A change at which |F|² is stationary.
struct Stationary {
  Eigen::VectorXd change;
  bool is_minimum = false;
};

// That near a change by Newton's method, no farther than `farthest` from zero change. Where no solution is
// near, the remaining violation contributes as much to the curvature of |F|² as JᵀJ does, which the method of
// Levenberg and Marquardt would have to discover step by step. None where the iteration leads elsewhere.
std::optional<Stationary> stationary_near(const Violation& violation, Eigen::VectorXd change,
                                          double farthest) {
  Eigen::VectorXd F, slope, before, behind;
  Eigen::MatrixXd J;
  for (int i = 0; i < kApproachSteps; ++i) {
    if (!violation.linear(change, F, J)) return std::nullopt;
    slope = J.transpose() * F;
    Eigen::MatrixXd H = J.transpose() * J;
    for (Eigen::Index k = 0; k < change.size(); ++k) {
      Eigen::VectorXd nudged = change;
      nudged(k) = change(k) - kApproachDifference;
      if (!violation.gradient(nudged, F, before)) return std::nullopt;
      nudged(k) = change(k) + kApproachDifference;
      if (!violation.gradient(nudged, F, behind)) return std::nullopt;
      H.col(k) += (behind - before) / (2 * kApproachDifference);
    }
    const Eigen::MatrixXd symmetric = (H + H.transpose()) / 2;
    const Eigen::VectorXd step = LuSolver(symmetric).solve(-slope).col(0);
    change += step;
    if (!violation.lead(change) || !(violation.farthest() <= farthest)) return std::nullopt;
    if (step.cwiseAbs().maxCoeff() <= kApproachSettled) {
      return Stationary{change, Eigen::LLT<Eigen::MatrixXd>(symmetric).info() == Eigen::Success};
    }
  }
  return std::nullopt;
}

// A solution, or a minimum of |F|², by the method of Levenberg and Marquardt, no farther than `farthest` from
// zero change. Where that method ends in a flat valley is a matter of rounding: a place with F ≠ 0 counts
// only if it is a minimum.
std::optional<Eigen::VectorXd> least_from(const Violation& violation, const Eigen::VectorXd& start,
                                          double farthest) {
  Eigen::VectorXd F;
  LeastSquaresProblem problem;
  problem.residuals = [&](const Eigen::VectorXd& x, Eigen::VectorXd& r) { return violation.values(x, r); };
  problem.jacobian = [&](const Eigen::VectorXd& x, Eigen::MatrixXd& J) { return violation.linear(x, F, J); };
  LeastSquaresOptions options;
  options.iterations = kMostApproachSteps;
  options.rounding = kCoupledClosure;
  const LeastSquaresFit fit = least_squares(problem, start, options);
  if (!violation.lead(fit.x) || !(violation.farthest() <= farthest)) {
    return std::nullopt;
  }
  if (is_all_but_zero(fit.r)) {
    return fit.x;
  }
  const auto at = stationary_near(violation, fit.x, farthest);
  return at && at->is_minimum ? std::optional(at->change) : std::nullopt;
}

// The change with the least violation near zero change. Between two solutions or minima that have just parted
// there is a saddle: they may be far from it, and a nudge is needed to leave it. Where the minimum has
// vanished instead, what a long search would find is a matter of rounding.
std::optional<Eigen::VectorXd> least_violation(const Violation& violation, const Eigen::VectorXd& start) {
  const auto at = stationary_near(violation, start, kLargestCoupledStep);
  if (!at) {
    return least_from(violation, start, kLargestCoupledStep);
  }
  const Eigen::Index n = start.size();
  return at->is_minimum
             ? at->change
             : least_from(violation, at->change + Eigen::VectorXd::LinSpaced(n, 1, 2) * kApproachDifference,
                          kFarthestApproach);
}

// Moves `to` to the minimum of |F|² near zero change; true where that is all but 0. If it is far away, `to`
// is left where it was.
bool approach(const Violation& violation) {
  const Eigen::VectorXd start = Eigen::VectorXd::Zero(violation.unknowns());
  const auto least = least_violation(violation, start);
  Eigen::VectorXd F;
  if (!least || !violation.values(*least, F)) {
    (void)violation.lead(start);
    return false;
  }
  return is_all_but_zero(F);
}

// J at a state; it does not depend on the drivers' positions.
Eigen::MatrixXd jacobian_at(const Planned& model, const Group& group, const State& state) {
  const std::vector<DriverMotion> drivers(model.mechanism.drivers.size());
  return jacobian_of(group, group_rows(model, group, drivers, state, state.contacts), model.plan.size);
}

// J bordered by singular vectors.
LuSolver bordered(const Eigen::MatrixXd& J, const LeastViolation& continuation) {
  const Eigen::Index n = J.rows();
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n + 1, n + 1);
  M.topLeftCorner(n, n) = J;
  M.topRightCorner(n, 1) = continuation.left;
  M.bottomLeftCorner(1, n) = continuation.right.transpose();
  return LuSolver(M);
}

// The singular vectors at the last position before a limit, where J is all but singular.
LeastViolation begun_at(const Eigen::MatrixXd& J) {
  LeastViolation continuation;
  if (J.rows() == J.cols()) {
    const SingularValues svd = singular_values(J);
    continuation.left = svd.U.col(J.cols() - 1);
    continuation.right = svd.V.col(J.cols() - 1);
    continuation.sign = bordered(J, continuation).sign();
  }
  return continuation;
}

// The singular vectors farther on, from those of the position before: the next c is the x of J x + e b = 0, c
// x = 1; the next b follows likewise from Jᵀ. Where J is singular, the bordered determinant has the same sign
// with the new vectors as with the old.
LeastViolation continued(const Eigen::MatrixXd& J, LeastViolation continuation) {
  if (continuation.sign == 0) {
    return continuation;
  }
  const Eigen::Index n = J.rows();
  const LeastViolation mirrored{continuation.right, continuation.left, 0};
  const Eigen::VectorXd one = Eigen::VectorXd::Unit(n + 1, n);
  const Eigen::VectorXd right = bordered(J, continuation).solve(one).col(0).head(n).normalized();
  const Eigen::VectorXd left = bordered(J.transpose(), mirrored).solve(one).col(0).head(n).normalized();
  return left.allFinite() && right.allFinite() ? LeastViolation{left, right, continuation.sign}
                                               : LeastViolation{};
}

// Whether solutions that begin at J have the other parts of the group in the assembly in which `continuation`
// began.
bool is_same_assembly(const Eigen::MatrixXd& J, const LeastViolation& continuation) {
  return continuation.sign != 0 && bordered(J, continuation).sign() == continuation.sign;
}

// det b / det a, factor by factor.
double ratio_of_determinants(const Eigen::MatrixXd& b, const Eigen::MatrixXd& a) {
  const LuSolver of_b(b), of_a(a);
  return of_b.sign() * of_a.sign() * (of_b.pivots().array() / of_a.pivots().array()).abs().prod();
}

// Two solutions that have met in a limit differ along the direction in which the conditions change least, and
// their determinants have opposite signs. Returns two changes from one solution, at `to`, to where the other
// one should be: as far beyond the zero of the determinant, or, if the two are already far apart, beyond
// where the bodies came from.
std::array<Eigen::VectorXd, 2> changes_across(const Planned& model, const Group& group, const State& from,
                                              const State& to) {
  const BodyCoordinates coordinates(model, group, to);
  const Eigen::MatrixXd J = jacobian_at(model, group, to);
  Eigen::MatrixXd by_coordinates = J;
  coordinates.transform(Eigen::VectorXd::Zero(coordinates.count()), to, by_coordinates);
  const Eigen::MatrixXd V = singular_values(by_coordinates).V;
  const Eigen::VectorXd least = V.col(V.cols() - 1);
  State beside = to;
  coordinates.move(kApproachDifference * least, beside);
  double to_zero = 0;
  if (place_contacts(model, group, beside)) {
    const double rise = ratio_of_determinants(jacobian_at(model, group, beside), J) - 1;
    to_zero = std::abs(rise) > kApproachDifference / kFarthestApproach ? -kApproachDifference / rise : 0;
  }
  return {2 * to_zero * least, 2 * least.dot(coordinates.change_between(to, from)) * least};
}

}  // namespace

GroupStatus place_coupled_anew(const Planned& model, std::size_t g, const State& from,
                               const std::vector<DriverMotion>& drivers, State& to,
                               std::optional<LeastViolation>& continuation) {
  const Group& group = model.plan.groups[g];
  const int mode = to.groups[g].mode;
  const Violation violation(model, group, from, drivers, to);
  const bool is_near = approach(violation);
  State near = to;
  const auto place_from = [&](const State& state) { return place_coupled(model, g, state, 0, drivers, to); };
  if (!is_near || place_from(near) != GroupStatus::kOk) {
    take_group(group, near, to);
    continuation = continued(jacobian_at(model, group, to),
                             continuation ? *continuation : begun_at(jacobian_at(model, group, from)));
    return GroupStatus::kOutOfReach;
  }
  const auto is_found = [&] {
    return to.groups[g].mode == mode && violation.farthest() <= kFarthestApproach &&
           (!continuation || is_same_assembly(jacobian_at(model, group, to), *continuation));
  };
  bool found = is_found();
  if (!found && to.groups[g].mode != mode) {
    take_group(group, to, near);
    for (const Eigen::VectorXd& across : changes_across(model, group, from, near)) {
      State other = near;
      BodyCoordinates(model, group, near).move(across, other);
      found = found || (place_from(other) == GroupStatus::kOk && is_found());
    }
  }
  if (!found) {
    take_group(group, from, to);
    return GroupStatus::kNotConverged;
  }
  continuation.reset();
  return joint_beyond_end(model, g, to) ? GroupStatus::kOutOfReach : GroupStatus::kOk;
}

}  // namespace higherpair
