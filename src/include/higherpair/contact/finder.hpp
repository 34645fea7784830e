#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <optional>

namespace higherpair {

enum class FindStatus {
  kFound,
  kOverlapAtStart,  ///< the bodies overlap where the follower is to start from
  kNoContact,       ///< the follower passes through its whole range and nothing touches
  kUnbounded,       ///< neither body is bounded, and their contacts cannot be listed
};

struct FindResult {
  FindStatus status = FindStatus::kNoContact;
  ContactPosition at;  ///< meaningful with kFound
  int branch = 0;      ///< sign of ∂gap/∂q there
};

/// The first touch when the follower moves from coordinate `q` in the sense `direction` (+1, -1), the driver
/// being held at u. Steps of at most (signed distance)/(largest distance of the bounded body from the
/// follower's pivot), or the signed distance itself for a sliding follower, cannot jump over a contact; close
/// to it the osculating iteration takes over. Where no such bound exists (two unbounded bodies) or the steps
/// come to rest beside a grazing position, the list of all contacts (conic_contacts.hpp) answers. A turning
/// follower searches one turn; a sliding one until the bodies are far apart.
/// \param from_overlap  true: the bodies may overlap at the start; then the position where they come apart is
///   meant
[[nodiscard]] FindResult find_contact(const ContactPair& pair, double u, double q, int direction,
                                      bool from_overlap);

/// Of the contacts that leave the interiors of the bodies disjoint the one whose coordinate is nearest to
/// `q`.
/// \param branch  if given, only contacts with this sign of ∂gap/∂q
[[nodiscard]] FindResult find_nearest_contact(const ContactPair& pair, double u, double q,
                                              std::optional<int> branch = std::nullopt);

}  // namespace higherpair
