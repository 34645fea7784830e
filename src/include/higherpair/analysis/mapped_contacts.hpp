#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/mechanism/tolerances.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// A contact of a mechanism considered by itself: two bodies on ground, the first of which moves the second.
struct MappedContact {
  int contact = 0;
  /// Why it is no such pair, as a sentence; empty if it is, and the other members are set.
  std::string refusal;
  ContactPair pair;  ///< body 1: the one that is solved first
  /// For contacts of curves with ends or several parts: both boundaries, owned by the mechanism; otherwise
  /// null.
  const Boundary* boundary1 = nullptr;
  const Boundary* boundary2 = nullptr;
  CarriedBody known;  ///< body 1, on ground
  CarriedBody follower;
  std::array<bool, 2> unbounded = {false, false};  ///< the boundary is the part kept of an unbounded curve
  bool known_is_first = true;                      ///< whether the contact names body 1 first
  int known_joint = 0;                             ///< of Mechanism::joints
  int follower_joint = 0;
  std::optional<int> driver;  ///< of Mechanism::drivers: its coordinate is u, up to the sign known.sign
  double u = 0;               ///< its value at the drivers' positions [rad or m]
  double posed = 0;           ///< coordinate of the follower in the poses [rad or m]
  std::optional<double> q;  ///< the same in the present position; none where the mechanism cannot be started
  Vector2d n_W = Vector2d::UnitX();  ///< outward normal of body 1 there
};

struct MappedContacts {
  std::vector<MappedContact> contacts;  ///< of Mechanism::contacts
  std::string not_started;              ///< why the mechanism cannot be started; empty if it can
};

/// Which contacts of a mechanism are pairs with a map of their own (contact_map.hpp): slipping contacts of
/// two bodies on revolute or prismatic joints to ground, one of which is placed by the other through it.
/// Fails where the mechanism has no plan.
[[nodiscard]] tl::expected<MappedContacts, std::string> mapped_contacts(const Mechanism& mechanism,
                                                                        const std::vector<double>& drivers,
                                                                        double tolerance);

}  // namespace higherpair
