#include "higherpair/contact/common_normal.hpp"

#include "higherpair/geometry/newton.hpp"
#include "higherpair/geometry/support.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr int kMaxSteps = 60;
constexpr double kMaxTurn = 0.3;  // of the normal in one step [rad]

Vector2d foot_on(const PlacedCurve<double>& line, const Vector2d& p_W) {
  return p_W - (p_W - line.vertex_W).dot(line.axis_W) * line.axis_W;
}

std::optional<CommonNormal> points_at(const PlacedCurve<double>& first, const PlacedCurve<double>& second,
                                      const Vector2d& n_W) {
  const Vector2d inward = -n_W;
  if (!has_point(first, n_W) || !has_point(second, inward)) {
    return std::nullopt;
  }
  const SupportPoint<double> s1 = support_point(first, n_W);
  const SupportPoint<double> s2 = support_point(second, inward);
  return CommonNormal{n_W, s1.p_W, s2.p_W, s1.rho, s2.rho};
}

std::optional<CommonNormal> normal_of_line(const PlacedCurve<double>& line, bool line_is_first,
                                           const PlacedCurve<double>& other) {
  CommonNormal at;
  at.n_W = line_is_first ? Vector2d(-line.axis_W) : line.axis_W;
  const Vector2d outward = line.axis_W;  // of the other body: into the material of the line's
  if (!has_point(other, outward)) {
    return std::nullopt;
  }
  const SupportPoint<double> s = support_point(other, outward);
  const Vector2d foot = foot_on(line, s.p_W);
  at.p1_W = line_is_first ? foot : s.p_W;
  at.p2_W = line_is_first ? s.p_W : foot;
  at.rho1 = line_is_first ? 0 : s.rho;
  at.rho2 = line_is_first ? s.rho : 0;
  return at;
}

}  // namespace

std::optional<CommonNormal> find_common_normal(const Curve& curve1, const Pose<double>& X_W1,
                                               const Curve& curve2, const Pose<double>& X_W2,
                                               const Vector2d& n_W) {
  const PlacedCurve<double> first = place(curve1, X_W1);
  const PlacedCurve<double> second = place(curve2, X_W2);
  if (is_line(curve1) || is_line(curve2)) {
    return normal_of_line(is_line(curve1) ? first : second, is_line(curve1),
                          is_line(curve1) ? second : first);
  }
  std::optional<CommonNormal> at = points_at(first, second, n_W);
  double last = INFINITY;
  for (int i = 0; at && i < kMaxSteps; ++i) {
    const double tangential = (at->p2_W - at->p1_W).dot(perp(at->n_W));
    const double slope = -(at->rho1 + at->rho2) - at->gap();
    const double step = std::clamp(slope == 0 ? 0 : -tangential / slope, -kMaxTurn, kMaxTurn);
    if (newton_has_settled(std::abs(step), last, 1e-9)) {
      return at;
    }
    last = std::abs(step);
    at = points_at(first, second, Vector2d(Rotation<double>::from_angle(step) * at->n_W).normalized());
    if (step == 0) {
      return at;
    }
  }
  return std::nullopt;
}

EquivalentLink equivalent_link(const Curve& curve1, double rho1, const Curve& curve2, double rho2) {
  if (is_line(curve2)) {
    return {1, 0, 0, rho1};
  }
  if (is_line(curve1)) {
    return {0, 1, 0, rho2};
  }
  const double w = 1 / (rho1 + rho2);
  return {rho2 * w, rho1 * w, w, rho1 * rho2 * w};
}

ContactRates contact_rates(const EquivalentLink& link, const CommonNormal& at, const BodyMotion& body1,
                           const BodyMotion& body2) {
  const Vector2d p_W = (at.p1_W + at.p2_W) / 2;
  const Vector2d v1 = body1.v_WB + body1.omega * perp(Vector2d(p_W - body1.X_WB.p_WB));
  const Vector2d v2 = body2.v_WB + body2.omega * perp(Vector2d(p_W - body2.X_WB.p_WB));
  const double omega_r = body2.omega - body1.omega;
  ContactRates rates;
  rates.sliding = (v2 - v1).dot(perp(at.n_W));
  rates.along1 = link.z * omega_r + link.w2 * rates.sliding;
  rates.along2 = link.z * omega_r - link.w1 * rates.sliding;
  rates.phi_dot = body1.omega + link.w1 * omega_r + link.w * rates.sliding;
  rates.normal_acceleration =
      body2.omega * rates.along2 - body1.omega * rates.along1 - rates.sliding * rates.phi_dot;
  return rates;
}

}  // namespace higherpair
