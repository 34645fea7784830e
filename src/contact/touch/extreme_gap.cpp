#include "higherpair/contact/extreme_gap.hpp"

#include "gap_derivatives.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "higherpair/numeric/newton.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "place_points.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace higherpair {

std::optional<ExtremeGap> extreme_gap(const ContactPair& pair, const ContactPosition& near) {
  constexpr int kMaxSteps = 60;
  ContactPosition at = near;
  const bool has_line = is_line(pair.curve1) || is_line(pair.curve2);
  double last = kInf;
  for (int i = 0; i < kMaxSteps; ++i) {
    if (!place_points(pair, at)) {
      return std::nullopt;
    }
    const GapDerivatives d = gap_derivatives(pair, at);
    const Vector2d distance = at.p2_W - at.p1_W;
    const double gap = distance.dot(at.n_W);
    Eigen::Matrix2d J;
    Eigen::Vector2d r;
    if (has_line) {
      J << 1, 0, 0, d.g_qq;
      r << 0, d.g_q;
    } else {
      J << d.g_phiphi, d.g_phiq, d.g_phiq, d.g_qq;
      r << distance.dot(perp(at.n_W)), d.g_q;
    }
    Eigen::Vector2d step = J.fullPivLu().solve(-r);
    const double lever = velocity_per_q(pair.motion2, at.p2_W).norm() + std::abs(at.rho1) + std::abs(at.rho2);
    const double size = std::abs(step(0)) + std::abs(step(1)) / (pair.motion2.turns ? 1 : lever);
    if (!step.allFinite()) {
      return std::nullopt;
    }
    if (newton_has_settled(size, last, kExtremeQuadratic)) {
      return ExtremeGap{gap, at};
    }
    last = size;
    step *= std::min(1.0, kNewtonTurn / size);
    at.n_W = Rotation<double>::from_angle(step(0)) * at.n_W;
    at.n_W.normalize();
    at.q += step(1);
  }
  return std::nullopt;
}

}  // namespace higherpair
