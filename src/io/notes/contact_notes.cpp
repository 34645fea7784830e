#include "contact_notes.hpp"

#include "higherpair/geometry/involute_span.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "io/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

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
  const Body& body = mechanism.bodies[ref.body];
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

// The involutes of one side of a contact, all about one centre, which is pivoted on ground.
struct Flanks {
  std::string name;
  double base_radius = 0;
  Bounds roll;
  int count = 0;  // of involutes
  Vector2d pivot_W = Vector2d::Zero();
};

// The point of ground to which a point of a body is pinned.
std::optional<Vector2d> ground_pivot(const Mechanism& mechanism, int body, const Vector2d& p_B, double near) {
  for (const Joint& joint : mechanism.joints) {
    const bool second = joint.first.body == 0;
    const PointRef& own = second ? joint.second : joint.first;
    const PointRef& ground = second ? joint.first : joint.second;
    if (joint.type == JointType::kRevolute && ground.body == 0 && own.body == body &&
        (point_of(mechanism, own) - p_B).norm() <= near) {
      return point_of(mechanism, ground);
    }
  }
  return std::nullopt;
}

std::optional<Flanks> flanks_of(const Mechanism& mechanism, const CurveRef& ref) {
  const Body& body = mechanism.bodies[ref.body];
  const NamedCurve& named = described_curve(mechanism, ref);
  const std::vector<int> curves = named.parts.empty() ? std::vector<int>{ref.curve} : named.parts;
  std::optional<Involute> all;
  int count = 0;
  for (const int index : curves) {
    const auto& boundary = body.curves[index].boundary;
    for (const SpanPtr& span : boundary ? boundary->spans() : std::vector<SpanPtr>()) {
      const Involute* own = involute_of(*span);
      if (own == nullptr) {
        continue;
      }
      const double near = kSameBaseRadius * own->base_radius;
      if (all && (std::abs(all->base_radius - own->base_radius) > near ||
                  (all->center_B - own->center_B).norm() > near)) {
        return std::nullopt;
      }
      ++count;
      const Bounds before = all ? all->roll : own->roll;
      all = *own;
      all->roll = {std::min(before.low, own->roll.low), std::max(before.high, own->roll.high)};
    }
  }
  const auto pivot =
      all ? ground_pivot(mechanism, ref.body, all->center_B, kSameBaseRadius * all->base_radius)
          : std::nullopt;
  if (!pivot) {
    return std::nullopt;
  }
  return Flanks{named.parts.empty() ? body.name + "." + named.name : body.name, all->base_radius, all->roll,
                count, *pivot};
}

// At a contact the two rolls span the common tangent of the base circles: r1 φ1 + r2 φ2 = √(a² - (r1 + r2)²).
std::string interference(const Flanks& root, const Flanks& tip, double tangent, const Units& units) {
  const double met = (tangent - tip.base_radius * tip.roll.high) / root.base_radius;
  if (met >= root.roll.low - kSameBaseRadius) {
    return "";
  }
  const Scaling angle = from_si(dimension::kAngle, units);
  const std::string past = met < 0
                               ? fmt::format(", {} past its base circle",
                                             with_unit(-met * root.base_radius, dimension::kLength, units, 4))
                               : "";
  const double most = (tangent - root.base_radius * root.roll.low) / tip.base_radius;
  const std::string shorter = most > tip.roll.low
                                  ? fmt::format("let the `roll` of {} end at {:.5g}, or ", tip.name,
                                                std::floor(angle.apply(most) * 1e3) / 1e3)
                                  : "";
  return fmt::format(
      "interference: the tips of {} come to where the roll of {} is {:.5g} {}{}, but its involute begins at "
      "{:.5g}: "
      "the contact would leave it at its root; {}give {} more teeth or `profile_shift`",
      tip.name, root.name, angle.apply(met), name_of(units.angle), past, angle.apply(root.roll.low), shorter,
      root.name);
}

// Wheels mesh only if their teeth are equally far apart along the base circles. \pre all teeth of both are
// there
std::string other_pitch(const Flanks& first, const Flanks& second, const Units& units) {
  const auto pitch = [](const Flanks& flanks) { return 4 * kPi * flanks.base_radius / flanks.count; };
  const double a = pitch(first), b = pitch(second);
  return std::abs(a - b) <= kSameBasePitch * a
             ? ""
             : fmt::format(
                   "the teeth of {} are {} apart along the base circle, those of {} {}: wheels that mesh "
                   "have the same `module` and `pressure_angle`",
                   first.name, with_unit(a, dimension::kLength, units, 4), second.name,
                   with_unit(b, dimension::kLength, units, 4));
}

// Interference in a contact of involutes whose base circles turn about two pivots on ground: the tips of one
// reach beyond the start of the other's flanks. Empty if there is none, and for all other contacts.
std::string tooth_note(const Mechanism& mechanism, const Contact& contact, const Units& units) {
  const auto first = flanks_of(mechanism, contact.first);
  const auto second = first ? flanks_of(mechanism, contact.second) : std::nullopt;
  if (!second) {
    return "";
  }
  const auto is_whole = [&](const CurveRef& ref) {
    const auto& boundary = described_curve(mechanism, ref).boundary;
    return boundary && boundary->is_closed();
  };
  if (is_whole(contact.first) && is_whole(contact.second)) {
    if (std::string pitch = other_pitch(*first, *second, units); !pitch.empty()) return pitch;
  }
  const double distance = (second->pivot_W - first->pivot_W).norm();
  const double sum = first->base_radius + second->base_radius;
  if (!(distance > sum)) {
    return "";
  }
  const double tangent = std::sqrt((distance - sum) * (distance + sum));
  const std::string text = interference(*first, *second, tangent, units);
  return text.empty() ? interference(*second, *first, tangent, units) : text;
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
