#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <optional>

namespace higherpair {

enum class FindStatus {
  kFound,
  kOverlapAtStart,  ///< the bodies overlap in the follower's start position
  kNoContact,       ///< the follower passes through its whole range without touching
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
/// to it the osculating iteration takes over. Where no such bound exists (two unbounded bodies), or the steps
/// stall next to a grazing position, the list of all contacts (conic_contacts.hpp) is used. A turning
/// follower is searched over one turn, a sliding one until the bodies are far apart.
[[nodiscard]] FindResult find_contact(const ContactPair& pair, double u, double q, int direction);

/// The contact nearest to coordinate `q` among those that leave the interiors of the bodies disjoint.
/// \param branch  if given, only contacts with this sign of ∂gap/∂q
[[nodiscard]] FindResult find_nearest_contact(const ContactPair& pair, double u, double q,
                                              std::optional<int> branch = std::nullopt);

/// How far a follower moves from `q` in the sense of `direction` (+1, -1) to the contact at coordinate
/// `contact` [rad or m]: less than a whole turn if it turns, else < 0 where the contact is behind.
/// \param near  a contact that is behind by no more than this is at q: 0
[[nodiscard]] double distance_ahead(const OneFreedom& follower, double q, int direction, double contact,
                                    double near);

}  // namespace higherpair
