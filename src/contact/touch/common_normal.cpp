#include "higherpair/contact/common_normal.hpp"

#include "contact_points.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "higherpair/numeric/newton.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr int kMaxNormalSteps = 60;

}  // namespace

std::optional<CommonNormal> find_common_normal(const Curve& curve1, const Pose<double>& X_W1,
                                               const Curve& curve2, const Pose<double>& X_W2,
                                               const Vector2d& n_W) {
  const bool line1 = is_line(curve1);
  const bool line2 = is_line(curve2);
  const PlacedPair placed{place(curve1, X_W1), place(curve2, X_W2)};
  ContactPoints at = points_at(line1, line2, placed, n_W);
  double last = kInf;
  for (int i = 0; at.exist && i < kMaxNormalSteps; ++i) {
    const double slope = -(at.rho1 + at.rho2) - at.g;
    const double step = std::clamp(slope == 0 ? 0 : -at.s / slope, -kNewtonTurn, kNewtonTurn);
    if (line1 || line2 || step == 0 || newton_has_settled(std::abs(step), last)) {
      return at;
    }
    last = std::abs(step);
    at = points_at(line1, line2, placed, Vector2d(Rotation<double>::from_angle(step) * at.n_W).normalized());
  }
  return std::nullopt;
}

ContactRates contact_rates(const EquivalentLink& link, const CommonNormal& at, const BodyMotion& body1,
                           const BodyMotion& body2) {
  const Vector2d p_W = at.p_W();
  const Vector2d v_12 = velocity_at(body2, p_W) - velocity_at(body1, p_W);
  return contact_rates(link, v_12.dot(perp(at.n_W)), body1.omega, body2.omega);
}

}  // namespace higherpair
