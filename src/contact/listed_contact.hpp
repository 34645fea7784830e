#pragma once

#include "higherpair/contact/conic_contacts.hpp"
#include "higherpair/contact/finder.hpp"

#include <optional>

namespace higherpair {

/// What distances at a position are measured against [m]: size_of_pair() with the distance of the bodies.
[[nodiscard]] double size_at(const ContactPair& pair, double u, double q);

/// What find_contact looks for, taken from the list of all contacts: for pairs on which no safe step exists,
/// and where marching comes to rest. The list is made when it is first asked for, and then kept: it is the
/// same for every start and sense, and dearer than all the rest.
class ListedContacts {
public:
  ListedContacts(const ContactPair& pair, double u) : pair_(pair), u_(u) {}

  /// The arguments and the answer of find_contact; kUnbounded where there is no such list.
  [[nodiscard]] FindResult find(double q, int direction, bool from_overlap);
  /// Whether the list has been made.
  [[nodiscard]] bool is_known() const { return list_.has_value(); }

private:
  const ContactPair& pair_;
  double u_;
  std::optional<CurveContacts> list_;
};

}  // namespace higherpair
