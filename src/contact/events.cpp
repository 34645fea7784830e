#include "higherpair/contact/events.hpp"

#include "contact_points.hpp"
#include "gap_derivatives.hpp"
#include "higherpair/geometry/newton.hpp"
#include "higherpair/geometry/roots.hpp"
#include "limit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace higherpair {

std::optional<ContactPosition> stroke_end(const ContactTrack& start, double u) {
  ContactTrack track = start;
  const double h = u - start.at.u;
  const auto rate_at = [&](double x) {
    return follow_to(track, start.at.u + x).status == TrackStatus::kOk ? track.at.dq : NAN;
  };
  const auto x = root_between(rate_at, start.at.dq, h, rate_at(h));
  return x && std::isfinite(rate_at(*x)) ? std::optional(track.at) : std::nullopt;
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
    at.gap_q = d.g_q;
    const double slope1 = radius_slope(placed.first, at.rho1, at.n_W);
    const double slope2 = radius_slope(placed.second, at.rho2, -at.n_W);
    const Vector2d distance = at.p2_W - at.p1_W;
    const double g_phi = distance.dot(perp(at.n_W));
    Eigen::Matrix3d J;
    J << g_phi, d.g_q, d.g_u, d.g_phiphi, d.g_phiq, d.g_phiu, slope1 + slope2, -turns2 * slope2,
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
