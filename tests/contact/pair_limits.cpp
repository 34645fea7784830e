#include "contact/pair_limits.hpp"

#include "contact/touch/contact_points.hpp"
#include "contact/touch/gap_derivatives.hpp"
#include "contact/touch/place_points.hpp"
#include "higherpair/numeric/newton.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace higherpair {
namespace {

// Derivatives of the gap g(φ, q, u) that contain the driver's coordinate.
struct DriverDerivatives {
  double g_u = 0, g_phiu = 0, g_qu = 0;
};

DriverDerivatives driver_derivatives(const ContactPair& pair, const ContactPosition& at) {
  const Vector2d t = perp(at.n_W);
  const Vector2d v1 = velocity_per_q(pair.motion1, at.p1_W);
  const double turns1 = pair.motion1.turns ? 1 : 0;
  const double turns2 = pair.motion2.turns ? 1 : 0;
  const double along = turns1 * at.rho1 - t.dot(v1);
  DriverDerivatives d;
  d.g_u = -at.n_W.dot(v1);
  if (is_line(pair.curve2)) {
    d.g_qu = turns2 * along;
  } else if (is_line(pair.curve1)) {
    d.g_qu = turns1 * (t.dot(velocity_per_q(pair.motion2, at.p2_W)) + turns2 * at.rho2);
  } else {
    d.g_phiu = along;
  }
  return d;
}

}  // namespace

std::optional<LimitPosition> limit_near(const ContactPair& pair, const ContactPosition& start,
                                        double length) {
  constexpr int kMaxSteps = 40;
  ContactPosition at = start;
  const bool has_line = is_line(pair.curve1) || is_line(pair.curve2);
  // Units of φ, q, u that make the three unknowns comparable.
  const Eigen::Vector3d unit(1, pair.motion2.turns ? 1 : length, pair.motion1.turns ? 1 : length);
  double last = INFINITY;
  for (int i = 0; i < kMaxSteps; ++i) {
    if (!place_points(pair, at)) {
      return std::nullopt;
    }
    const GapDerivatives d = gap_derivatives(pair, at);
    const DriverDerivatives by_u = driver_derivatives(pair, at);
    const Vector2d distance = at.p2_W - at.p1_W;
    Eigen::Matrix3d J;
    Eigen::Vector3d r;
    if (has_line) {
      J << length, 0, 0, 0, d.g_q, by_u.g_u, 0, d.g_qq, by_u.g_qu;
      r << 0, distance.dot(at.n_W), d.g_q;
    } else {
      const double g_phi = distance.dot(perp(at.n_W));
      J << g_phi, d.g_q, by_u.g_u, d.g_phiphi, d.g_phiq, by_u.g_phiu, d.g_phiq, d.g_qq, by_u.g_qu;
      r << distance.dot(at.n_W), g_phi, d.g_q;
    }
    J *= unit.asDiagonal();
    // ∂gap/∂q times the unit of q is a length, as the other equations are.
    J.row(2) *= unit(1);
    r(2) *= unit(1);
    const Eigen::FullPivLU<Eigen::Matrix3d> lu(J);
    const Eigen::Vector3d step = lu.solve(-r);
    const double size = step.cwiseAbs().sum();
    // Where ∂gap/∂q cannot change (a slide against a face) no step solves the system, and there is no limit.
    if (!((J * step + r).norm() <= 1e-6 * r.norm())) {
      return std::nullopt;
    }
    if (!(size < 1e3 * (1 + std::abs(at.q / unit(1)) + std::abs(at.u / unit(2))))) {
      return std::nullopt;
    }
    at.n_W = Rotation<double>::from_angle(step(0)) * at.n_W;
    at.q += step(1) * unit(1);
    at.u += step(2) * unit(2);
    if (newton_has_settled(size, last, 1e-7)) {
      return LimitPosition{at.u, at.q};
    }
    last = size;
  }
  return std::nullopt;
}

std::optional<ContactPosition> conforming_near(const ContactPair& pair, const ContactPosition& start,
                                               double length) {
  constexpr int kMaxSteps = 40;
  if (!is_curved(pair.curve1) || !is_curved(pair.curve2)) {
    return std::nullopt;
  }
  ContactPosition at = start;
  at.dq = at.d2q = at.dphi = at.sliding = 0;
  const double turns1 = pair.motion1.turns ? 1 : 0;
  const double turns2 = pair.motion2.turns ? 1 : 0;
  const Eigen::Vector3d unit(1, pair.motion2.turns ? 1 : length, pair.motion1.turns ? 1 : length);
  double last = INFINITY;
  for (int i = 0; i < kMaxSteps; ++i) {
    if (!place_points(pair, at)) {
      return std::nullopt;
    }
    const PlacedPair placed = place_pair(pair, at.u, at.q);
    const GapDerivatives d = gap_derivatives(pair, at);
    const DriverDerivatives by_u = driver_derivatives(pair, at);
    at.gap_q = d.g_q;
    const double slope1 = radius_slope(placed.first, at.rho1, at.n_W);
    const double slope2 = radius_slope(placed.second, at.rho2, -at.n_W);
    const Vector2d distance = at.p2_W - at.p1_W;
    const double g_phi = distance.dot(perp(at.n_W));
    Eigen::Matrix3d J;
    J << g_phi, d.g_q, by_u.g_u, d.g_phiphi, d.g_phiq, by_u.g_phiu, slope1 + slope2, -turns2 * slope2,
        -turns1 * slope1;
    const Eigen::Vector3d r(distance.dot(at.n_W), g_phi, at.rho1 + at.rho2);
    const Eigen::FullPivLU<Eigen::Matrix3d> lu(J * unit.asDiagonal());
    const Eigen::Vector3d step = lu.solve(-r);
    const double size = step.cwiseAbs().sum();
    if (!lu.isInvertible() || !(size < 1e3)) {
      return std::nullopt;
    }
    if (newton_has_settled(size, last, kNewtonQuadratic, 1e-15)) {
      return at;
    }
    last = size;
    const double damping = std::min(1.0, 0.2 / size);
    at.n_W = Rotation<double>::from_angle(damping * step(0)) * at.n_W;
    at.n_W.normalize();
    at.q += damping * step(1) * unit(1);
    at.u += damping * step(2) * unit(2);
  }
  return std::nullopt;
}

}  // namespace higherpair
