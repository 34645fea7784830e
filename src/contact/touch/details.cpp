#include "higherpair/contact/details.hpp"

#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/curve_queries.hpp"

#include <cmath>

namespace higherpair {
namespace {

// Arc coordinate of a boundary point of a body, growing along its outward normal turned +90° [m]: on a line
// the distance from its given point, otherwise from the vertex. \param normal_angle  of n_W, continuous [rad]
double arc_at(const Curve& curve, const BodyMotion& body, const Vector2d& p_W, const Vector2d& n_W,
              double normal_angle) {
  if (is_line(curve)) {
    return perp(n_W).dot(p_W - body.X_WB * anchor(curve));
  }
  return is_conic(curve) && curve.q <= 0 ? arc_to_point(curve, body.X_WB.inverse_times(p_W))
                                         : arc_to_normal(curve, normal_angle - body.theta);
}

// `sense`: +1 if t of body 1 is the outward normal n_W of this body turned +90°, else -1.
ContactSide side_of(const ContactBody& body, const Vector2d& p_W, const Vector2d& n_W, double rho,
                    double normal_angle, double sense) {
  ContactSide side;
  side.arc = sense * arc_at(body.curve, body.motion, p_W, n_W, normal_angle);
  if (!is_line(body.curve)) {
    side.rho = rho;
    side.center_W = p_W - rho * n_W;
  }
  return side;
}

// Acute angle between two directions [rad], 0 … π/2.
double acute_angle(const Vector2d& a, const Vector2d& b) {
  return std::atan2(std::abs(cross(a, b)), std::abs(a.dot(b)));
}

bool turns(const ContactBody& body) {
  return body.grounded != nullptr && body.grounded->turns;
}

std::optional<double> transmission(const ContactSide& side, const ContactBody& body, const Vector2d& n_W) {
  if (!turns(body) || !side.center_W) {
    return std::nullopt;
  }
  const Vector2d arm = *side.center_W - body.grounded->p_WO;
  const double lengths = side.center_W->norm() + body.grounded->p_WO.norm() + std::abs(side.rho.value_or(0));
  return arm.norm() > kDirectionless * lengths ? std::optional(acute_angle(n_W, arm)) : std::nullopt;
}

std::optional<double> arm(const ContactSide& side, const ContactBody& body) {
  if (!turns(body) || !side.center_W) {
    return std::nullopt;
  }
  return (*side.center_W - body.grounded->p_WO).norm();
}

// Offset of the pivot from the line along which the other body's centre slides.
std::optional<double> offset(const Vector2d& pivot_W, const ContactSide& sliding, const OneFreedom& slide) {
  if (!sliding.center_W) {
    return std::nullopt;
  }
  return perp(slide.direction_W).dot(pivot_W - *sliding.center_W);
}

void add_linkage(const ContactBody& body1, const ContactBody& body2, ContactDetails& details) {
  const bool flat1 = is_line(body1.curve);
  const bool flat2 = is_line(body2.curve);
  auto& [r1, r2, r3, r4] = details.lengths;
  if (!flat1 && !flat2) {
    r3 = std::abs(*details.side1.rho + *details.side2.rho);
  }
  if (body1.grounded == nullptr || body2.grounded == nullptr) {
    details.linkage = "link";
    return;
  }
  const OneFreedom& m1 = *body1.grounded;
  const OneFreedom& m2 = *body2.grounded;
  if (m1.turns && m2.turns) {
    details.linkage = flat1 || flat2 ? "inverted slider-crank" : "four-bar";
    r1 = (m2.p_WO - m1.p_WO).norm();
    r2 = arm(details.side1, body1);
    r4 = arm(details.side2, body2);
  } else if (!m1.turns && !m2.turns) {
    details.linkage = flat1 || flat2 ? "wedge" : "double slider";
  } else {
    const bool turning_is_flat = m1.turns ? flat1 : flat2;
    const bool sliding_is_flat = m1.turns ? flat2 : flat1;
    details.linkage = sliding_is_flat ? "scotch yoke" : turning_is_flat ? "rapson slide" : "slider-crank";
    r1 = m1.turns ? offset(m1.p_WO, details.side2, m2) : offset(m2.p_WO, details.side1, m1);
    r2 = m1.turns ? arm(details.side1, body1) : arm(details.side2, body2);
  }
}

}  // namespace

double arc_difference(const Curve& curve1, const BodyMotion& body1, const Curve& curve2,
                      const BodyMotion& body2, const CommonNormal& at, double phi) {
  return arc_at(curve1, body1, at.p1_W, at.n_W, phi) + arc_at(curve2, body2, at.p2_W, -at.n_W, phi + kPi);
}

std::optional<double> pressure_angle(const BodyMotion& body, const OneFreedom* grounded, const Vector2d& p_W,
                                     const Vector2d& n_W) {
  Vector2d direction;
  double size = 1;
  if (grounded != nullptr) {
    direction = velocity_per_q(*grounded, p_W);
    size = grounded->turns ? p_W.norm() + grounded->p_WO.norm() : 1;
  } else {
    const Vector2d turning = body.omega * perp(Vector2d(p_W - body.X_WB.p_WB));
    direction = body.v_WB + turning;
    size = body.v_WB.norm() + turning.norm();
  }
  return direction.norm() > kDirectionless * size ? std::optional(acute_angle(n_W, direction)) : std::nullopt;
}

ContactDetails details_of(const ContactBody& body1, const ContactBody& body2, const CommonNormal& at,
                          double phi) {
  ContactDetails details;
  const Vector2d n = at.n_W;
  details.side1 = side_of(body1, at.p1_W, n, at.rho1, phi, 1);
  details.side2 = side_of(body2, at.p2_W, -n, at.rho2, phi + kPi, -1);
  details.pressure = pressure_angle(body2.motion, body2.grounded, at.p2_W, n);
  details.transmission = transmission(details.side2, body2, n);
  add_linkage(body1, body2, details);
  return details;
}

ContactDetails details_of(const ContactPair& pair, const ContactPosition& at, double phi) {
  const BodyMotion motion1 = motion_at(pair.motion1, at.u, 0, 0);
  const BodyMotion motion2 = motion_at(pair.motion2, at.q, 0, 0);
  return details_of({pair.curve1, motion1, &pair.motion1}, {pair.curve2, motion2, &pair.motion2}, at, phi);
}

}  // namespace higherpair
