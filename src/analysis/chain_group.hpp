#pragma once

#include "higherpair/mechanism/plan.hpp"

#include <optional>
#include <variant>
#include <vector>

namespace higherpair {

/// A circle or an ellipse in its body's frame, the body inside; or a point, whose semi-axes are 0.
struct Oval {
  Vector2d center_B = Vector2d::Zero();
  Rotation<double> axis_B;  ///< direction of the first semi-axis
  double along = 0;         ///< semi-axes [m]
  double across = 0;
};

/// A body on a joint to a known one, of which an oval touches an oval of another known body.
struct OvalContact {
  int contact = 0;  ///< index of Mechanism::contacts
  int known = 0;    ///< the other body
  Oval on_known;
  int body = 0;
  Oval on_body;
  int carrier = 0;     ///< ground where the body slides
  OneFreedom freedom;  ///< of the body, in the carrier's frame
};

/// What places the bodies of one group. Discs that touch are the dyad of their equivalent linkage: the link
/// between their centres is a body of its own.
struct ChainGroup {
  std::variant<DrivenBody, RrrDyad, RrpDyad, RprDyad, OvalContact> kind;
  bool two_modes = false;
  std::optional<int> disc;  ///< of a dyad that stands for the contact of two discs: the body it places
};

/// How a chain solves a group. None where it cannot: another kind, a contact that rolls, may part, or whose
/// curves are others than convex circles and ellipses.
/// \param link  index of the body between the centres, if there is to be one
[[nodiscard]] std::optional<ChainGroup> chain_group(const Mechanism& mechanism, const Group& group, int link);

}  // namespace higherpair
