#include "higherpair/contact/jerk.hpp"

#include "contact_points.hpp"

namespace higherpair {
namespace {

// Of the body's material at a point.
Vector2d acceleration_at(const BodyMotion& body, const Vector2d& p_W) {
  const Vector2d r_W = p_W - body.X_WB.p_WB;
  return body.a_WB + body.alpha * perp(r_W) - body.omega * body.omega * r_W;
}

// dκ/ds along n turned +90°, n being the curve's outward normal; 0 for a point.
double curvature_slope(const Curve& curve, const BodyMotion& body, double rho, const Vector2d& n_W) {
  return is_curved(curve) ? -radius_slope(place(curve, body.X_WB), rho, n_W) / (rho * rho * rho)
                          : curve.slope;
}

}  // namespace

ContactJerk contact_jerk(const Curve& curve1, const Curve& curve2, const CommonNormal& at,
                         const BodyMotion& body1, const BodyMotion& body2) {
  const auto link = equivalent_link(is_line(curve1), at.rho1, is_line(curve2), at.rho2);
  const ContactRates rates = contact_rates(link, at, body1, body2);
  const Vector2d p_W = at.p_W();
  const double a_s = (acceleration_at(body2, p_W) - acceleration_at(body1, p_W)).dot(perp(at.n_W));
  const double alpha_r = body2.alpha - body1.alpha;
  const double u1 = rates.along1, u2 = rates.along2;
  const double bend1 = curvature_slope(curve1, body1, at.rho1, at.n_W) * u1 * u1;
  const double bend2 = curvature_slope(curve2, body2, at.rho2, -at.n_W) * u2 * u2;

  // Of the linkage with constant lengths; the curvatures' rates contribute only what is added to its jerk.
  const double along1 = link.z * alpha_r + link.w2 * a_s;
  const double along2 = link.z * alpha_r - link.w1 * a_s;
  const double phi_ddot = body1.alpha + link.w1 * alpha_r + link.w * a_s;
  ContactJerk jerk;
  jerk.linkage_normal_jerk = 2 * (body2.alpha * rates.along2 - body1.alpha * rates.along1) +
                             body2.omega * along2 - body1.omega * along1 - 2 * rates.phi_dot * a_s -
                             rates.sliding * phi_ddot;
  jerk.rate_of_curvature = {-bend1 * u1, bend2 * u2};
  return jerk;
}

}  // namespace higherpair
