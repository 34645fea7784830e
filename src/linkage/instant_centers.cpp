#include "higherpair/linkage/instant_centers.hpp"

#include "higherpair/linkage/tolerances.hpp"

#include <algorithm>

namespace higherpair {
namespace {

/// Largest angular velocity and velocity of a list of bodies.
struct Fastest {
  double omega = 0;  ///< [rad/s]
  double v = 0;      ///< [m/s]
  double size = 0;   ///< [m]
};

Fastest fastest_of(std::span<const BodyMotion> bodies, double size) {
  Fastest fastest;
  fastest.size = size;
  double distance = 0;
  for (const BodyMotion& body : bodies) {
    fastest.omega = std::max(fastest.omega, std::abs(body.omega));
    fastest.v = std::max(fastest.v, body.v_WB.norm());
    distance = std::max(distance, (body.X_WB.p_WB - bodies.front().X_WB.p_WB).norm());
  }
  fastest.v = std::max(fastest.v, fastest.omega * distance);
  return fastest;
}

/// The centre of two bodies; the caller sets their indices.
InstantCenter center_of(const BodyMotion& body_i, const BodyMotion& body_j, const Fastest& fastest) {
  const Vector2d& o = body_j.X_WB.p_WB;
  const double omega = body_j.omega - body_i.omega;
  const Vector2d v = body_j.v_WB - body_i.v_WB - body_i.omega * perp(Vector2d(o - body_i.X_WB.p_WB));

  InstantCenter center;
  const bool turns = std::abs(omega) * fastest.size > kPoleTolerance * fastest.v;
  if (turns && std::abs(omega) > kPoleTolerance * fastest.omega) {
    center.kind = InstantCenterKind::kPoint;
    center.p_W = o + perp(v) / omega;
  } else if (v.norm() > kPoleTolerance * fastest.v) {
    center.kind = InstantCenterKind::kAtInfinity;
    center.u_W = perp(v).normalized();
  }
  return center;
}

}  // namespace

std::vector<InstantCenter> instant_centers(std::span<const BodyMotion> bodies, double size) {
  const Fastest fastest = fastest_of(bodies, size);
  std::vector<InstantCenter> centers;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      centers.push_back(center_of(bodies[i], bodies[j], fastest));
      centers.back().i = i;
      centers.back().j = j;
    }
  }
  return centers;
}

}  // namespace higherpair
