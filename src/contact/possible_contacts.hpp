#pragma once

#include "contact_equations.hpp"

#include <vector>

namespace higherpair {

/// A small box that may hold contacts.
struct PossiblePlace {
  PieceContact place;
  bool opposed = false;
};

/// The boxes, each connected set of them merged: whose normals (and turning coordinates) are, up to
/// whole turns, nearer to each other than the tolerance [rad], on the same or on neighbouring pieces.
/// \param range  of a sliding follower: the bounds of q are cut by it
[[nodiscard]] std::vector<PossibleContact> merge_places(const SupportPair& pair, const Interval& theta1,
                                                        const std::vector<PossiblePlace>& places,
                                                        const Bounds& range, double tolerance);

}  // namespace higherpair
