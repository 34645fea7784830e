#include "limit.hpp"

#include "contact_points.hpp"
#include "gap_derivatives.hpp"
#include "higherpair/geometry/newton.hpp"

#include <cmath>

#include <Eigen/LU>

namespace higherpair {

bool place_points(const ContactPair& pair, ContactPosition& at) {
  const ContactPoints points = points_at(pair, place_pair(pair, at.u, at.q), at.n_W);
  at.n_W = points.n_W;
  if (points.exist) {
    static_cast<CommonNormal&>(at) = points;
  }
  return points.exist;
}

std::optional<LimitPosition> limit_near(const ContactPair& pair, const ContactPosition& start,
                                        double length) {
  constexpr int kMaxSteps = 40;
  ContactPosition at = start;
  const bool has_line = is_line(pair.curve1) || is_line(pair.curve2);
  // Of φ, q, u: so that the three unknowns are of one size.
  const Eigen::Vector3d unit(1, pair.motion2.turns ? 1 : length, pair.motion1.turns ? 1 : length);
  double last = INFINITY;
  for (int i = 0; i < kMaxSteps; ++i) {
    if (!place_points(pair, at)) {
      return std::nullopt;
    }
    const GapDerivatives d = gap_derivatives(pair, at);
    const Vector2d distance = at.p2_W - at.p1_W;
    Eigen::Matrix3d J;
    Eigen::Vector3d r;
    if (has_line) {
      J << length, 0, 0, 0, d.g_q, d.g_u, 0, d.g_qq, d.g_qu;
      r << 0, distance.dot(at.n_W), d.g_q;
    } else {
      const double g_phi = distance.dot(perp(at.n_W));
      J << g_phi, d.g_q, d.g_u, d.g_phiphi, d.g_phiq, d.g_phiu, d.g_phiq, d.g_qq, d.g_qu;
      r << distance.dot(at.n_W), g_phi, d.g_q;
    }
    J *= unit.asDiagonal();
    // The last equation is a length only for a turning follower.
    J.row(2) *= length / unit(1);
    r(2) *= length / unit(1);
    const Eigen::FullPivLU<Eigen::Matrix3d> lu(J);
    const Eigen::Vector3d step = lu.solve(-r);
    const double size = step.cwiseAbs().sum();
    // Where ∂gap/∂q cannot change (a slide against a face) no step is left, and no limit.
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

}  // namespace higherpair
