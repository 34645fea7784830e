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

/// Calls `use` with the dyad or the driven body of a group. \pre the group is not an OvalContact
// std::visit would define functions that throw, in objects compiled for wide registers as well.
template <class Use>
inline void visit_links(const ChainGroup& group, const Use& use) {
  if (const auto* rrr = std::get_if<RrrDyad>(&group.kind)) {
    use(*rrr);
  } else if (const auto* rrp = std::get_if<RrpDyad>(&group.kind)) {
    use(*rrp);
  } else if (const auto* rpr = std::get_if<RprDyad>(&group.kind)) {
    use(*rpr);
  } else if (const auto* driven = std::get_if<DrivenBody>(&group.kind)) {
    use(*driven);
  }
}

/// How a chain solves a group. None where it cannot: groups of other kinds, and contacts that roll, may part,
/// or have curves other than convex circles and ellipses.
/// \param link  index of the link that represents the group's contact
[[nodiscard]] std::optional<ChainGroup> chain_group(const Mechanism& mechanism, const Group& group, int link);

}  // namespace higherpair
