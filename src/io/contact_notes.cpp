#include "contact_notes.hpp"

#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "tolerances.hpp"
#include "tooth_notes.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

// A curve in ground, as the pose of its body places it.
struct PosedCurve {
  const Curve* curve;
  Vector2d middle_W;  // centre of a closed conic, vertex of an open one, a point of a line
  Vector2d axis_W;
  std::string name;
};

PosedCurve posed_curve(const Mechanism& mechanism, const CurveRef& ref) {
  const Body& body = mechanism.bodies[static_cast<std::size_t>(ref.body)];
  const NamedCurve& named = described_curve(mechanism, ref);
  const Pose<double> X_WB = {Rotation<double>::from_angle(body.guess_theta), body.guess_p_WB};
  const bool closed = is_conic(named.curve) && named.curve.q > 0;
  return {&named.curve, X_WB * (closed ? center(named.curve) : named.curve.vertex_B),
          X_WB.R_WB * named.curve.axis_B, body.name + "." + named.name};
}

// The radii of the largest circle within a closed curve and of the smallest one around it.
double inner_radius(const Curve& curve) {
  return is_conic(curve) ? std::min(semi_axes(curve)[0], semi_axes(curve)[1]) : 0;
}
double outer_radius(const Curve& curve) {
  return is_conic(curve) ? std::max(semi_axes(curve)[0], semi_axes(curve)[1]) : 0;
}

// Whatever touches a face lies in front of it, including its centre. If a face was drawn where it touches but
// with its normal reversed, the centre is as far behind it as it should be in front.
std::string behind_face(const PosedCurve& face, const PosedCurve& other, const Units& units) {
  const double behind = face.axis_W.dot(other.middle_W - face.middle_W);
  const double reach = other.curve->q > 0 ? inner_radius(*other.curve) / 2 : 0;
  if (!(behind > reach) || !(behind > kBehindFace * (other.middle_W.norm() + face.middle_W.norm()))) {
    return "";
  }
  return fmt::format(
      "{} lies behind the face {} in the poses, {} from it; the normal of a face points out of its "
      "body, towards what touches it: reverse it if that side is meant",
      other.name, face.name, with_unit(behind, dimension::kLength, units, 4));
}

bool is_within(const PosedCurve& inner, const PosedCurve& outer) {
  const double apart = (inner.middle_W - outer.middle_W).norm();
  return apart + outer_radius(*inner.curve) < inner_radius(*outer.curve);
}

// Whether the body is the interior of a circle or ellipse.
bool is_solid_outline(const Curve& curve) {
  return is_conic(curve) && curve.q > 0 && curve.side == Side::kInside;
}

}  // namespace

std::string contact_note(const Mechanism& mechanism, const Contact& contact, const Units& units) {
  if (std::string teeth = tooth_note(mechanism, contact, units); !teeth.empty()) {
    return teeth;
  }
  const PosedCurve first = posed_curve(mechanism, contact.first);
  const PosedCurve second = posed_curve(mechanism, contact.second);
  if (is_line(*first.curve) || is_line(*second.curve)) {
    return is_line(*first.curve) ? behind_face(first, second, units) : behind_face(second, first, units);
  }
  if (!is_solid_outline(*first.curve) || !is_solid_outline(*second.curve)) {
    return "";
  }
  const bool second_within = is_within(second, first);
  if (!second_within && !is_within(first, second)) {
    return "";
  }
  return fmt::format(
      "{} lies within {} in the poses, which is the outline of a solid body; that of a hole has side = "
      "\"outside\"",
      second_within ? second.name : first.name, second_within ? first.name : second.name);
}

}  // namespace higherpair::io_detail
