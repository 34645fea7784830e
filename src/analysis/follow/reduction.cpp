#include "reduction.hpp"

#include "analysis/boundaries/span_ends.hpp"
#include "analysis/groups/group_kinds.hpp"
#include "analysis/groups/group_system.hpp"
#include "analysis/tolerances.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "numeric/lu_solver.hpp"
#include "numeric/singular_values.hpp"
#include "step.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr int kMaxNewton = 12;
constexpr int kMaxOuter = 25;

}  // namespace

Reduction::Reduction(Run& run, const Path& path, std::size_t g, double s)
    : run_(run), path_(path), g_(g), s_(s), unit_(unit_of(run, path)) {
  start_ = coordinates_of(model_of(run), run.plan().groups[g], run.at.state);
  usable_ = make_border();
}

bool Reduction::make_border() {
  if (start_.size() == 0 || !system_at(0, start_) || J_.rows() != J_.cols()) {
    return false;
  }
  const SingularValues svd = singular_values(J_);
  b_ = svd.U.col(J_.cols() - 1);
  c_ = svd.V.col(J_.cols() - 1);
  return b_.allFinite() && c_.allFinite();
}

bool Reduction::system_at(double ahead, const Eigen::VectorXd& x) {
  if (!solve_before(run_, path_, g_, s_, ahead)) {
    return false;
  }
  path_.motions(s_ + ahead, run_.work.motions);
  const Group& group = run_.plan().groups[g_];
  set_coordinates(model_of(run_), group, run_.at.state, x, run_.work.trial);
  return group_system(model_of(run_), group, run_.work.motions, run_.work.trial, F_, J_, F_s_);
}

void Reduction::place(const Point& point) {
  (void)system_at(point.ahead, point.x);
}

void Reduction::place_limit(const Point& limit, double at) {
  place(limit);
  run_.work.trial.groups[g_].sine = 0;
  run_.work.trial.groups[g_].sine_rate = 0;
  path_.motions(at, run_.work.motions);
  for (std::size_t later = g_ + 1; later < run_.plan().groups.size(); ++later) {
    run_.work.trial.groups[later].mode = run_.at.state.groups[later].mode;
    (void)place_group(model_of(run_), later, run_.at.state, limit.ahead, run_.work.motions, run_.work.trial);
  }
}

std::optional<Reduction::Point> Reduction::solve(const Point& guess, double lambda, double ahead) {
  const Eigen::Index n = start_.size();
  const double size = run_.plan().size;
  Point point = guess;
  point.x += (lambda - guess.lambda) * guess.x_lambda + (ahead - guess.ahead) * guess.x_s;
  point.lambda = lambda;
  point.ahead = ahead;
  Eigen::MatrixXd M(n + 1, n + 1);
  Eigen::VectorXd r(n + 1);
  double last = kInf;
  for (int i = 0; i < kMaxNewton; ++i) {
    if (!system_at(ahead, point.x)) {
      return std::nullopt;
    }
    M << J_, b_, c_.transpose(), 0;
    r << F_ + point.value * b_, c_.dot(point.x - start_) - lambda;
    const LuSolver lu(M);
    const Eigen::VectorXd step = lu.solve(-r);
    const double length = step.cwiseAbs().maxCoeff();
    if (!(length <= kReductionFarthest * size)) {
      return std::nullopt;
    }
    point.x += step.head(n);
    point.value += step(n);
    if (length <= kReductionSettled * size || (length <= kReductionNear * size && length >= last / 2)) {
      Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(n + 1, 2);
      wanted(n, 0) = 1;
      wanted.col(1).head(n) = -F_s_;
      const Eigen::MatrixXd rates = lu.solve(wanted);
      point.x_lambda = rates.col(0).head(n);
      point.per_lambda = rates(n, 0);
      point.x_s = rates.col(1).head(n);
      point.per_s = rates(n, 1);
      return point;
    }
    last = length;
  }
  return std::nullopt;
}

std::optional<Reduction::Second> Reduction::second_derivatives(const Point& at) {
  const double d_lambda = kReductionDifference * run_.plan().size;
  const double d_s = kReductionDifference * unit_;
  const auto a = solve(at, at.lambda - d_lambda, at.ahead);
  const auto b = solve(at, at.lambda + d_lambda, at.ahead);
  const auto c = solve(at, at.lambda, at.ahead - d_s);
  const auto d = solve(at, at.lambda, at.ahead + d_s);
  if (!a || !b || !c || !d) {
    return std::nullopt;
  }
  return Second{(b->per_lambda - a->per_lambda) / (2 * d_lambda), (d->per_lambda - c->per_lambda) / (2 * d_s),
                (d->per_s - c->per_s) / (2 * d_s)};
}

std::optional<Reduction::Point> Reduction::here() {
  if (!usable_) {
    return std::nullopt;
  }
  Point start;
  start.x = start_;
  start.x_lambda = start.x_s = Eigen::VectorXd::Zero(start_.size());
  return solve(start, 0, 0);
}

// Newton's method on ε = ε_λ = 0, or on ε_λ = ε_s = 0. The second derivatives are differences; their error
// makes the convergence linear, with a factor of kReductionDifference².
std::optional<Reduction::Point> Reduction::root_of(Kind kind, const Point& from, double farthest) {
  const double size = run_.plan().size;
  Point at = from;
  double last = kInf;
  for (int i = 0; i < kMaxOuter; ++i) {
    const auto second = second_derivatives(at);
    if (!second) {
      return std::nullopt;
    }
    Eigen::Matrix2d A;
    Eigen::Vector2d r;
    if (kind == Kind::kLimit) {
      A << at.per_lambda, at.per_s, second->lambda_lambda, second->lambda_s;
      r << at.value, at.per_lambda;
    } else {
      A << second->lambda_lambda, second->lambda_s, second->lambda_s, second->s_s;
      r << at.per_lambda, at.per_s;
    }
    const Eigen::Vector2d step = -A.inverse() * r;
    const double length = std::abs(step(0)) / size + std::abs(step(1)) / unit_;
    const double lambda = at.lambda + step(0);
    const double ahead = at.ahead + step(1);
    if (!(length < kReductionFarthest) || !(std::abs(lambda) < kReductionFarthest * size) ||
        !(std::abs(ahead) <= farthest)) {
      return std::nullopt;
    }
    const auto next = solve(at, lambda, ahead);
    if (!next) {
      return std::nullopt;
    }
    at = *next;
    if (length <= kReductionNoStep || (length <= kReductionNearRoot && length >= last / 2)) {
      at.is_saddle = second->lambda_lambda * second->s_s < second->lambda_s * second->lambda_s;
      return at;
    }
    last = length;
  }
  return std::nullopt;
}

std::optional<Reduction::Point> Reduction::limit_ahead(double h) {
  const auto first = here();
  const auto limit = first ? root_of(Kind::kLimit, *first, kFarAhead * std::abs(h)) : std::nullopt;
  if (!limit || !(limit->ahead * h > 0)) {
    return std::nullopt;
  }
  // The limit is on this branch if the branch up to it is a parabola, whose slope ds/dλ falls linearly to 0.
  const double slope = -first->per_lambda / first->per_s;
  const Eigen::VectorXd tangent = first->x_lambda + slope * first->x_s;
  const Eigen::VectorXd moved = limit->x - first->x;
  const Eigen::VectorXd missed = moved - limit->lambda / 2 * (tangent + limit->x_lambda);
  const bool parabola =
      std::abs(limit->ahead - limit->lambda * slope / 2) <= kLimitParabola * std::abs(limit->ahead) &&
      missed.lpNorm<1>() <= kLimitParabola * moved.lpNorm<1>();
  return parabola && system_at(limit->ahead, limit->x) && stays_on_faces() ? limit : std::nullopt;
}

// Whether contacts on flat spans, which the conditions take for whole lines, are within their ends in
// run.work.trial.
bool Reduction::stays_on_faces() const {
  for (const int index : run_.plan().groups[g_].contacts) {
    const Contact& contact = run_.mechanism().contacts[index];
    const ContactMotion& motion = run_.work.trial.contacts[index];
    for (std::size_t side = 0; contact.by_boundary && side < 2; ++side) {
      const Boundary& boundary = boundary_at(run_, static_cast<std::size_t>(index), side);
      const BoundaryPlace& place = motion.place[side];
      if (!is_flat(boundary, place)) continue;
      const Vector2d& p_W = side == 0 ? motion.at.p1_W : motion.at.p2_W;
      const SpanPoint from = boundary.at(place);
      const Vector2d p_B = run_.work.trial.bodies[ref_of(contact, side).body].X_WB.inverse_times(p_W);
      const double t = place.t + (p_B - from.p_B).dot(perp(from.n_B)) / from.speed;
      if (!range_of(boundary, place.span).contains(t)) return false;
    }
  }
  return true;
}

std::optional<Reduction::Point> Reduction::crossing_within(double h) {
  const auto first = here();
  const auto crossing = first ? root_of(Kind::kCrossing, *first, 2 * std::abs(h)) : std::nullopt;
  if (!crossing || !crossing->is_saddle || !(std::abs(crossing->value) <= kCrosses * run_.plan().size)) {
    return std::nullopt;
  }
  const double margin = kAtStepEnd * unit_;
  const double along = crossing->ahead * (h > 0 ? 1 : -1);
  return along >= -margin && along <= std::abs(h) + margin ? crossing : std::nullopt;
}

std::optional<Reduction::Point> Reduction::singular_point(double distance) {
  const auto first = here();
  if (!first) {
    return std::nullopt;
  }
  auto crossing = root_of(Kind::kCrossing, *first, distance);
  if (crossing && std::abs(crossing->value) <= kCrosses * run_.plan().size) {
    return crossing;
  }
  return root_of(Kind::kLimit, *first, distance);
}

// From the second-order Taylor polynomial, refined by Newton's method in λ.
std::vector<Reduction::Point> Reduction::positions_at(double ahead) {
  std::vector<Point> found;
  const auto first = here();
  const auto second = first ? second_derivatives(*first) : std::nullopt;
  if (!second) {
    return found;
  }
  const double a = second->lambda_lambda / 2;
  const double b = first->per_lambda + second->lambda_s * ahead;
  const double c = first->value + ahead * (first->per_s + second->s_s * ahead / 2);
  const double discriminant = b * b - 4 * a * c;
  if (!(discriminant > 0)) {
    return found;
  }
  const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
  for (const double guess : {q / a, c / q}) {
    auto at = std::isfinite(guess) ? solve(*first, guess, ahead) : std::nullopt;
    for (int i = 0; i < kMaxNewton && at; ++i) {
      at = solve(*at, at->lambda - at->value / at->per_lambda, ahead);
    }
    if (at && std::abs(at->value) <= kCrosses * run_.plan().size) {
      found.push_back(*at);
    }
  }
  return found;
}

}  // namespace higherpair
