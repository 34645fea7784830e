#include "higherpair/contact/events.hpp"

#include "contact_points.hpp"
#include "gap_derivatives.hpp"
#include "limit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace higherpair {

std::optional<ContactPosition> stroke_end(const ContactTrack& start, double u) {
  constexpr int kMaxSteps = 100;
  ContactTrack track = start;
  double low = start.at.u;
  double high = u;
  const double sign_low = start.at.dq;
  if (follow_to(track, u).status != TrackStatus::kOk || !(sign_low * track.at.dq <= 0)) {
    return std::nullopt;
  }
  // From the end with the smaller rate.
  if (std::abs(start.at.dq) < std::abs(track.at.dq)) {
    track = start;
  }
  for (int i = 0; i < kMaxSteps; ++i) {
    (track.at.dq * sign_low > 0 ? low : high) = track.at.u;
    double next = track.at.u - track.at.dq / track.at.d2q;
    if (!(next > std::min(low, high) && next < std::max(low, high))) {
      next = track.at.dq == 0 ? track.at.u : low + (high - low) / 2;
    }
    const double moved = std::abs(next - track.at.u);
    if (moved <= 1e-15 * std::abs(next) || next == low || next == high) {
      return track.at;
    }
    if (follow_to(track, next).status != TrackStatus::kOk) {
      return std::nullopt;
    }
  }
  return track.at;
}

std::optional<ContactPosition> conforming_near(const ContactPair& pair, const ContactPosition& start,
                                               double length) {
  constexpr int kMaxSteps = 40;
  if (!is_conic(pair.curve1) || !is_conic(pair.curve2)) {
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
    const double slope2 = radius_slope(placed.second, at.rho2, at.n_W);
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
    if (size <= 1e-15 || (size < 1e-9 && size >= last / 2)) {
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
