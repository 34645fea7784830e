#include "higherpair/contact/rolling.hpp"

#include "gap_derivatives.hpp"
#include "higherpair/contact/details.hpp"
#include "higherpair/contact/step_agreement.hpp"
#include "higherpair/contact/step_length.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/known_rotation.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "higherpair/numeric/newton.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "higherpair/numeric/tolerances.hpp"
#include "numeric/least_norm.hpp"
#include "place_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace higherpair {
namespace {

constexpr int kMaxRollSteps = 60;

using Jacobian = Eigen::Matrix<double, 3, 2>;  // of gap, tangential distance and third condition, by q and φ

double size_of(const ContactPair& pair, const ContactPosition& at) {
  return (at.p1_W - pair.motion1.p_WO).norm() + (at.p2_W - pair.motion2.p_WO).norm() + kNeverZero;
}

// Large angles have no more digits than this [rad].
double rounding_of(const RollingTrack& track) {
  const ContactPosition& at = track.at;
  const double far = std::abs(track.phi) + (track.pair.motion1.turns ? std::abs(at.u) : 0) +
                     (track.pair.motion2.turns ? std::abs(at.q) : 0);
  return kRollingUlps * std::numeric_limits<double>::epsilon() * far;
}

// Residuals of the three conditions, and their derivatives by q and φ.
struct Equations {
  Eigen::Vector3d r = Eigen::Vector3d::Zero();
  Jacobian J = Jacobian::Zero();
};

// The two conditions of a contact; where a body is a line, φ is not free.
Equations contact_equations(const ContactPair& pair, const ContactPosition& at) {
  const GapDerivatives d = gap_derivatives(pair, at);
  Equations equations;
  equations.r(0) = (at.p2_W - at.p1_W).dot(at.n_W);
  equations.J(0, 0) = d.g_q;
  if (!is_line(pair.curve1) && !is_line(pair.curve2)) {
    equations.r(1) = (at.p2_W - at.p1_W).dot(perp(at.n_W));
    equations.J.row(1) << d.g_phiq, d.g_phiphi;
  }
  return equations;
}

double arc_difference(const ContactPair& pair, const ContactPosition& at, double phi) {
  return arc_difference(pair.curve1, motion_at(pair.motion1, at.u, 0, 0), pair.curve2,
                        motion_at(pair.motion2, at.q, 0, 0), at, phi);
}

void add_arcs(const RollingTrack& track, double phi, Equations& equations) {
  const ContactPosition& at = track.at;
  equations.r(2) = arc_difference(track.pair, at, phi) - track.arc_difference;
  const double turns2 = track.pair.motion2.turns ? 1 : 0;
  if (is_line(track.pair.curve1) || is_line(track.pair.curve2)) {
    equations.J(2, 0) = perp(at.n_W).dot(velocity_per_q(track.pair.motion2, at.p2_W));
  } else {
    equations.J.row(2) << -turns2 * at.rho2, at.rho1 + at.rho2;
  }
}

// Third condition: v1 and v2 per unit of u and q are parallel at p, so that the contact can be an instant
// centre.
void add_instant_centre(const ContactPair& pair, const ContactPosition& at, Equations& equations) {
  const Vector2d t = perp(at.n_W);
  const Vector2d v1 = velocity_per_q(pair.motion1, at.p1_W);
  const Vector2d v2 = velocity_per_q(pair.motion2, at.p2_W);
  const double scale = 1 / (v1.norm() + v2.norm() + kNeverZero) *
                       (pair.motion1.turns && pair.motion2.turns ? 1 : size_of(pair, at));
  equations.r(2) = scale * cross(v1, v2);
  // Points move with φ by ρ1 t and -ρ2 t, the second with q also by v2 + ρ2 t.
  const auto derivative = [&](const Vector2d& dp1, const Vector2d& dp2) {
    const Vector2d dv1 = pair.motion1.turns ? perp(dp1) : Vector2d::Zero();
    const Vector2d dv2 = pair.motion2.turns ? perp(dp2) : Vector2d::Zero();
    return scale * (cross(dv1, v2) + cross(v1, dv2));
  };
  const double turns2 = pair.motion2.turns ? 1 : 0;
  const Vector2d none = Vector2d::Zero();
  if (is_line(pair.curve2)) {
    equations.J(2, 0) = derivative(turns2 * at.rho1 * t, turns2 * at.rho1 * t);
  } else if (is_line(pair.curve1)) {
    const Vector2d along = t.dot(v2 + turns2 * at.rho2 * t) * t;
    equations.J(2, 0) = derivative(along, along);
  } else {
    equations.J.row(2) << derivative(none, v2 + turns2 * at.rho2 * t), derivative(at.rho1 * t, -at.rho2 * t);
  }
}

// The least-squares solution of J x = -r: by the normal equations if their rank is not in doubt, else by a
// decomposition that leaves unchanged what the conditions do not determine.
Eigen::Vector2d least_squares(const Jacobian& J, const Eigen::Vector3d& r) {
  const double a = J.col(0).squaredNorm();
  const double b = J.col(0).dot(J.col(1));
  const double c = J.col(1).squaredNorm();
  const double determinant = a * c - b * b;
  if (determinant > kRollingFullRank * (a + c) * (a + c)) {
    const double x = -J.col(0).dot(r);
    const double y = -J.col(1).dot(r);
    return Eigen::Vector2d(c * x - b * y, a * y - b * x) / determinant;
  }
  return LeastNormSolver(J, kRollingRank).solve(-r);
}

// Gauss-Newton on the three conditions; not converged where a curve has no such point.
template <class AddThird>
RollingResult solve(RollingTrack& track, const AddThird& add_third) {
  RollingResult result;
  ContactPosition& at = track.at;
  const auto place = [&] {
    const Vector2d n_before = at.n_W;
    const bool placed = place_points(track.pair, at);
    track.phi += placed ? angle_between(n_before, at.n_W) : 0;
    return placed;
  };
  if (!place()) {
    return result;
  }
  const double near = std::max(kNewtonQuadratic, rounding_of(track));
  double last = kInf;
  for (int i = 0; i < kMaxRollSteps; ++i) {
    Equations equations = contact_equations(track.pair, at);
    add_third(track.phi, equations);
    // Both unknowns in comparable units: radians, or displacements relative to the size.
    const double size = size_of(track.pair, at);
    Jacobian J = equations.J / size;
    if (!track.pair.motion2.turns) {
      J.col(0) *= size;
    }
    const Eigen::Vector2d step = least_squares(J, equations.r / size);
    const double length = step.norm();
    result.mismatch = equations.r.cwiseAbs().maxCoeff();
    if (newton_has_settled(length, last, near, kRollingLeast)) {
      result.converged = true;
      return result;
    }
    const double damping = std::min(1.0, kNewtonTurn / length);
    at.q += damping * step(0) * (track.pair.motion2.turns ? 1 : size);
    const double turn = is_line(track.pair.curve1) || is_line(track.pair.curve2) ? 0 : damping * step(1);
    at.n_W = Rotation<double>::from_angle(turn) * at.n_W;
    at.n_W.normalize();
    track.phi += turn;
    if (!place()) {
      return result;
    }
    if (length < kRollingSettled && length < kRollingQuadratic * last) {
      // The next step would be of rounding size, and leave the residual of the linear equations.
      result.mismatch = (equations.r + size * (J * step)).cwiseAbs().maxCoeff();
      result.converged = true;
      return result;
    }
    last = length;
  }
  return result;
}

// Rates for du/dt = 1.
void add_rates(RollingTrack& track) {
  const ContactPair& pair = track.pair;
  ContactPosition& at = track.at;
  const Vector2d p = at.p_W();
  const Vector2d v1 = velocity_per_q(pair.motion1, p);
  const Vector2d v2 = velocity_per_q(pair.motion2, p);
  at.gap_q = v2.dot(at.n_W);
  at.dq = v1.dot(v2) / v2.squaredNorm();
  at.sliding = (at.dq * v2 - v1).dot(perp(at.n_W));
  const auto link = equivalent_link(is_line(pair.curve1), at.rho1, is_line(pair.curve2), at.rho2);
  const ContactRates rates =
      contact_rates(link, 0, pair.motion1.turns ? 1 : 0, pair.motion2.turns ? at.dq : 0);
  at.dphi = rates.phi_dot;
  const Vector2d relative = rates.normal_acceleration * at.n_W;
  const Vector2d a1 = acceleration_per_q(pair.motion1, p);
  const Vector2d a2 = at.dq * at.dq * acceleration_per_q(pair.motion2, p);
  at.d2q = (a1 + relative - a2).dot(v2) / v2.squaredNorm();
}

struct RollStep {
  RollingTrack track;
  RollingResult result;
  bool agrees = false;  // with what was predicted
};

// A step, predicted and solved. If the normal turns on by 2π and the follower by 4π, the arcs of equal
// ellipses have the same difference again: such a solution, or another one far away, is refused.
RollStep roll_step(const RollingTrack& from, double u) {
  RollStep step{from, {}};
  RollingTrack& track = step.track;
  ContactPosition& at = track.at;
  const double h = u - at.u;
  at.u = u;
  at.q += h * (at.dq + h / 2 * at.d2q);
  at.n_W = Rotation<double>::from_angle(h * at.dphi) * at.n_W;
  track.phi += h * at.dphi;
  const double q = at.q;
  step.result = solve(track, [&](double phi, Equations& equations) { add_arcs(track, phi, equations); });
  if (!step.result.converged) {
    return step;
  }
  add_rates(track);
  const double unit = track.pair.motion2.turns ? 1 : size_of(track.pair, at);
  const double turned = std::abs(track.phi - from.phi);
  const double change = turned + std::abs(at.q - from.at.q) / unit;
  step.agrees = turned <= kFarthestInnerTurn &&
                is_as_predicted(std::abs(at.q - q) / unit - rounding_of(track), change, kWalkAgreement);
  return step;
}

}  // namespace

RollingResult start_rolling(RollingTrack& track, const ContactPair& pair, double u, double q,
                            const Vector2d& n_W) {
  track = {};
  track.pair = pair;
  track.at.u = u;
  track.at.q = q;
  track.at.n_W = n_W;
  track.phi = angle_of(n_W);
  const RollingResult result = solve(
      track, [&](double, Equations& equations) { add_instant_centre(track.pair, track.at, equations); });
  if (!result.converged) {
    return result;
  }
  track.arc_difference = arc_difference(pair, track.at, track.phi);
  add_rates(track);
  return result;
}

RollingResult roll_to(RollingTrack& track, double u) {
  const double unit = track.pair.motion1.turns ? 1 : size_of(track.pair, track.at);
  StepLength length(kLargestTurn * unit);
  RollingResult result{.converged = true};
  while (track.at.u != u) {
    const auto [h, last] = length.next(u - track.at.u);
    RollStep step = roll_step(track, last ? u : track.at.u + h);
    if (step.agrees) {
      track = std::move(step.track);
      result = step.result;
      length.taken();
      continue;
    }
    length.refused(h);
    if (length.value() < shortest_step(unit, u)) {
      result.converged = false;
      return result;
    }
  }
  return result;
}

}  // namespace higherpair
