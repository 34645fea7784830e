#pragma once

#include "higherpair/mechanism/plan.hpp"

#include <optional>
#include <variant>
#include <vector>

namespace higherpair {

/// A circle or an ellipse in its body's frame, with the body inside; or a point, whose semi-axes are 0.
struct Oval {
  Vector2d center_B = Vector2d::Zero();
  Rotation<double> axis_B;  ///< direction of the first semi-axis
  double along = 0;         ///< semi-axes [m]
  double across = 0;
};

/// A contact, represented among the bodies of a chain by a link of its own, whose x axis is the common
/// normal.
struct ChainTouch {
  int contact = 0;  ///< index of Mechanism::contacts
  int link = 0;     ///< index of that link
  double p_x = 0;   ///< the contact point on the link's x axis [m]
  int known = 0;    ///< the known body; the normal points out of it
  int body = 0;     ///< the body that the contact places
  int carrier = 0;
  OneFreedom freedom;  ///< of that body, in the carrier's frame
};

/// A body on a joint to a known one, placed by the contact of its oval with an oval of another known body.
struct OvalContact {
  ChainTouch touch;  ///< the contact point is the link's origin; a body that slides does so on ground
  Oval on_known;
  Oval on_body;
};

/// What places the bodies of one group. Discs that touch are replaced by the dyad of their equivalent
/// linkage.
struct ChainGroup {
  std::variant<DrivenBody, RrrDyad, RrpDyad, RprDyad, OvalContact> kind;
  bool two_modes = false;
  std::optional<OvalContact> discs;  ///< set if the dyad replaces the contact of two discs
};

/// The contact of a group, if it has one.
[[nodiscard]] inline const OvalContact* contact_of(const ChainGroup& group) {
  const auto* ovals = std::get_if<OvalContact>(&group.kind);
  return ovals == nullptr && group.discs ? &*group.discs : ovals;
}
[[nodiscard]] inline const ChainTouch* touch_of(const ChainGroup& group) {
  const OvalContact* contact = contact_of(group);
  return contact == nullptr ? nullptr : &contact->touch;
}

/// How a chain solves a group. None where it cannot: groups of other kinds, and contacts that roll, may part,
/// or have curves other than convex circles and ellipses.
/// \param link  index of the link that represents the group's contact
[[nodiscard]] std::optional<ChainGroup> chain_group(const Mechanism& mechanism, const Group& group, int link);

}  // namespace higherpair
