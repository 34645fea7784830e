#include "higherpair/contact/details.hpp"

#include "higherpair/geometry/arc_length.hpp"

#include <cmath>

namespace higherpair {
namespace {

bool is_line(const Curve& curve) {
  return curve.kind == CurveKind::kLine;
}

// `normal_angle` is that of the body's own outward normal, `sense` +1 if t of body 1 is that normal turned
// +90°.
ContactSide side_of(const Curve& curve, const OneFreedom& freedom, double q, const Vector2d& p_W,
                    const Vector2d& n_W, double rho, double normal_angle, double sense) {
  ContactSide side;
  if (is_line(curve)) {
    const Pose<double> X_WB = pose_at(freedom, q);
    side.arc = sense * perp(n_W).dot(p_W - X_WB * curve.vertex_B);
    return side;
  }
  side.rho = rho;
  side.center_W = p_W - rho * n_W;
  const double theta = freedom.turns ? q : freedom.theta;
  const double psi = normal_angle - theta - vertex_normal_angle(curve);
  if (curve.side == Side::kInside) {
    side.arc = sense * arc_length(curve, curve.q > 0 ? psi : nearest_turn(psi, 0));
  } else {
    // Inward normals of the convex side; the point moves against t when the normal turns on.
    const double turned = psi - kPi;
    side.arc = -sense * arc_length(curve, curve.q > 0 ? turned : nearest_turn(turned, 0));
  }
  return side;
}

double angle_between(const Vector2d& a, const Vector2d& b) {
  return std::atan2(std::abs(cross(a, b)), std::abs(a.dot(b)));
}

std::optional<double> transmission(const ContactSide& side, const OneFreedom& freedom, const Vector2d& n_W) {
  if (!freedom.turns || !side.center_W) {
    return std::nullopt;
  }
  const Vector2d arm = *side.center_W - freedom.p_WO;
  return arm.norm() > 0 ? std::optional(angle_between(n_W, arm)) : std::nullopt;
}

std::optional<double> arm(const ContactSide& side, const OneFreedom& freedom) {
  if (!freedom.turns || !side.center_W) {
    return std::nullopt;
  }
  return (*side.center_W - freedom.p_WO).norm();
}

// Offset of the pivot from the line along which the other body's centre slides.
std::optional<double> offset(const Vector2d& pivot_W, const ContactSide& sliding, const OneFreedom& slide) {
  if (!sliding.center_W) {
    return std::nullopt;
  }
  return perp(slide.direction_W).dot(pivot_W - *sliding.center_W);
}

void add_linkage(const ContactPair& pair, ContactDetails& details) {
  const OneFreedom& m1 = pair.motion1;
  const OneFreedom& m2 = pair.motion2;
  const bool flat1 = is_line(pair.curve1);
  const bool flat2 = is_line(pair.curve2);
  auto& [r1, r2, r3, r4] = details.lengths;
  if (!flat1 && !flat2) {
    r3 = std::abs(*details.side1.rho + *details.side2.rho);
  }
  if (m1.turns && m2.turns) {
    details.linkage = flat1 || flat2 ? "inverted slider-crank" : "four-bar";
    r1 = (m2.p_WO - m1.p_WO).norm();
    r2 = arm(details.side1, m1);
    r4 = arm(details.side2, m2);
  } else if (!m1.turns && !m2.turns) {
    details.linkage = flat1 || flat2 ? "wedge" : "double slider";
  } else {
    const bool first_turns = m1.turns;
    const bool turning_is_flat = first_turns ? flat1 : flat2;
    const bool sliding_is_flat = first_turns ? flat2 : flat1;
    details.linkage = sliding_is_flat ? "scotch yoke" : turning_is_flat ? "rapson slide" : "slider-crank";
    r1 = first_turns ? offset(m1.p_WO, details.side2, m2) : offset(m2.p_WO, details.side1, m1);
    r2 = first_turns ? arm(details.side1, m1) : arm(details.side2, m2);
  }
}

}  // namespace

ContactDetails details_of(const ContactPair& pair, const ContactPosition& at, double phi) {
  ContactDetails details;
  const Vector2d n = at.n_W;
  details.side1 = side_of(pair.curve1, pair.motion1, at.u, at.p1_W, n, at.rho1, phi, 1);
  details.side2 = side_of(pair.curve2, pair.motion2, at.q, at.p2_W, -n, at.rho2, phi + kPi, -1);
  details.pressure1 = angle_between(n, velocity_per_q(pair.motion1, at.p1_W));
  details.pressure2 = angle_between(n, velocity_per_q(pair.motion2, at.p2_W));
  details.transmission1 = transmission(details.side1, pair.motion1, n);
  details.transmission2 = transmission(details.side2, pair.motion2, n);
  add_linkage(pair, details);
  return details;
}

}  // namespace higherpair
