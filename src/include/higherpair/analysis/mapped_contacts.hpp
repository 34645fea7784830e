#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/mechanism/tolerances.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// A contact of a mechanism as a pair of its own: two bodies on ground, the first of which sets the second.
struct MappedContact {
  int contact = 0;
  std::string refusal;  ///< why it is no such pair, as a sentence; empty: it is, and the rest is set
  ContactPair pair;     ///< body 1: the one that is solved first
  /// Of contacts of curves with ends or several parts: both, which belong to the mechanism; null of others.
  const Boundary* boundary1 = nullptr;
  const Boundary* boundary2 = nullptr;
  CarriedBody known;  ///< body 1, on ground
  CarriedBody follower;
  std::array<bool, 2> unbounded = {false, false};  ///< the boundary is what was kept of an unbounded curve
  bool known_is_first = true;                      ///< whether the contact names body 1 first
  int known_joint = 0;                             ///< of Mechanism::joints
  int follower_joint = 0;
  std::optional<int> driver;  ///< of Mechanism::drivers: its coordinate is u, up to the sign known.sign
  double u = 0;               ///< at the drivers' positions [rad or m]
  double posed = 0;           ///< follower's coordinate in the poses [rad or m]
  std::optional<double> q;    ///< in the present position; none where it cannot be started
  Vector2d n_W = Vector2d::UnitX();  ///< there: outward normal of body 1
};

struct MappedContacts {
  std::vector<MappedContact> contacts;  ///< of Mechanism::contacts
  std::string not_started;              ///< why the mechanism cannot be started; empty: it can
};

/// Which contacts of a mechanism are pairs with a map of their own (contact_map.hpp): slipping contacts of
/// two bodies on revolute or prismatic joints to ground, one of which is placed by the other through it.
/// Fails where the mechanism has no plan.
[[nodiscard]] tl::expected<MappedContacts, std::string> mapped_contacts(const Mechanism& mechanism,
                                                                        const std::vector<double>& drivers,
                                                                        double tolerance = kDefaultClosure);

}  // namespace higherpair
