#include "chain_group.hpp"

#include "analysis/tolerances.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/mechanism/description.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/joint_sides.hpp"

namespace higherpair {
namespace {

std::optional<Oval> oval_of(const Curve& curve) {
  if (is_point(curve)) {
    return Oval{curve.vertex_B, {}, 0, 0};
  }
  const bool oval = curve.kind == CurveKind::kCircle || curve.kind == CurveKind::kEllipse;
  if (!oval || curve.side != Side::kInside || !(curve.q >= kSlenderestOval)) {
    return std::nullopt;
  }
  const auto [along, across] = semi_axes(curve);
  return Oval{center(curve), {curve.axis_B.x(), curve.axis_B.y()}, along, across};
}

// The two centres keep a constant distance, the sum of the radii: a link between them.
std::optional<ChainGroup> dyad_of_discs(OvalContact contact) {
  const double length = contact.on_known.along + contact.on_body.along;
  if (!(length > 0)) {
    return std::nullopt;
  }
  ChainTouch& touch = contact.touch;
  touch.p_x = contact.on_known.along;
  const OneFreedom& freedom = touch.freedom;
  const Vector2d arm = contact.on_body.center_B - freedom.p_BO;
  const BodyPoint A{touch.known, contact.on_known.center_B};
  if (freedom.turns) {
    if (!(arm.norm() > 0)) {
      return std::nullopt;
    }
    RrrDyad dyad;
    dyad.A = A;
    dyad.B = {touch.carrier, freedom.p_WO};
    dyad.link_a = touch.link;
    dyad.link_b = touch.body;
    dyad.a_pC = Vector2d(length, 0);
    dyad.b_pB = freedom.p_BO;
    dyad.b_pC = contact.on_body.center_B;
    dyad.length_a = length;
    dyad.length_b = arm.norm();
    dyad.along_b = direction_of(arm);
    return ChainGroup{dyad, true, contact};
  }
  RrpDyad dyad;
  dyad.A = A;
  dyad.link = touch.link;
  dyad.pC = Vector2d(length, 0);
  dyad.length = length;
  dyad.line = {touch.carrier, freedom.p_WO + freedom.R_WB * arm, direction_of(freedom.direction_W)};
  dyad.slider = Rider{touch.body, touch.carrier, contact.on_body.center_B, freedom.theta, freedom.R_WB};
  return ChainGroup{dyad, true, contact};
}

std::optional<ChainGroup> group_of_contact(const Mechanism& mechanism, const PlacingContact& placing,
                                           int link) {
  const Contact& contact = mechanism.contacts[placing.contact];
  if (contact.rolling || contact.by_boundary || contact.keep != Keep::kTouching) {
    return std::nullopt;
  }
  const CarriedBody& follower = *placing.follower;
  const CurveRef& known = end_off(contact, follower.body);
  const auto on_known = oval_of(curve_of(mechanism, known));
  const auto on_body = oval_of(curve_of(mechanism, end_on(contact, follower.body)));
  if (!on_known || !on_body) {
    return std::nullopt;
  }
  const ChainTouch touch{placing.contact, link, 0, known.body, follower.body, follower.carrier,
                         follower.freedom};
  const OvalContact ovals{touch, *on_known, *on_body};
  if (on_known->along == on_known->across && on_body->along == on_body->across) {
    return dyad_of_discs(ovals);
  }
  return follower.freedom.turns || follower.carrier == kGround ? std::optional(ChainGroup{ovals, false, {}})
                                                               : std::nullopt;
}

}  // namespace

std::optional<ChainGroup> chain_group(const Mechanism& mechanism, const Group& group, int link) {
  if (!group.ended_joints.empty()) {
    return std::nullopt;
  }
  if (const auto placing = placing_contact(group)) {
    return group_of_contact(mechanism, *placing, link);
  }
  return std::visit(
      [](const auto& kind) -> std::optional<ChainGroup> {
        if constexpr (requires { kind.links(); }) {
          return ChainGroup{kind, true, {}};
        } else if constexpr (requires { kind.carried; }) {
          return kind.carried.carrier == kGround ? std::optional(ChainGroup{kind, false, {}}) : std::nullopt;
        } else {
          return std::nullopt;
        }
      },
      group.kind);
}

}  // namespace higherpair
