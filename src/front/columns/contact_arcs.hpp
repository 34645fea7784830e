#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/contact/details.hpp"
#include "higherpair/geometry/boundary_arcs.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>

namespace higherpair {

/// Where a contact is on both curves.
struct ArcPoint {
  std::array<double, 2> arcs{};          ///< those of ContactDetails [m]; not used with boundaries
  std::array<BoundaryPlace, 2> place{};  ///< for contacts by_boundary
  std::array<double, 2> normal_angle{};  ///< of the outward normals in the bodies' frames, continuous [rad]
};

[[nodiscard]] ArcPoint arc_point(const Run& run, std::size_t contact, const ContactDetails& details);

/// The arcs that a contact point has run along both curves. May be asked from several threads.
class ContactArcs {
public:
  ContactArcs(const Mechanism& mechanism, const Contact& contact);

  /// Both > 0 along t of the contact [m].
  [[nodiscard]] std::array<double, 2> between(const ArcPoint& from, const ArcPoint& to) const;

private:
  std::array<std::shared_ptr<const Boundary>, 2> boundaries_;  // null: the arcs of ContactDetails
  mutable std::once_flag once_;
  mutable std::array<std::optional<BoundaryArcs>, 2> lengths_;  // made when they are asked for
};

}  // namespace higherpair
