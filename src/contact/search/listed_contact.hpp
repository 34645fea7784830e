#pragma once

#include "higherpair/contact/conic_contacts.hpp"
#include "higherpair/contact/finder.hpp"

#include <optional>

namespace higherpair {

/// Length against which distances at a position are measured [m]: size_of_pair() with the distance of the
/// bodies instead of that of the joints.
[[nodiscard]] double size_at(const ContactPair& pair, double u, double q);

/// Answers find_contact from the list of all free contacts: for pairs without a safe step length, and where
/// the march of find_contact gets stuck. The list is made on first use and kept: it is the same for every
/// start and sense, and costs more than all the rest.
class ListedContacts {
public:
  ListedContacts(const ContactPair& pair, double u) : pair_(pair), u_(u) {}

  /// Arguments and result as of find_contact; kUnbounded where there is no such list.
  /// \param from_overlap  true: the bodies may overlap at q; the result is then where they separate
  [[nodiscard]] FindResult find(double q, int direction, bool from_overlap);
  /// Whether the list has been made.
  [[nodiscard]] bool is_known() const { return list_.has_value(); }

private:
  const ContactPair& pair_;
  double u_;
  std::optional<CurveContacts> list_;
};

}  // namespace higherpair
