#pragma once

#include "higherpair/contact/contact_pair.hpp"
#include "higherpair/mechanism/description.hpp"

#include <optional>
#include <string>

#include <tl/expected.hpp>

namespace higherpair {

/// A body on a grounded joint: its motion by one coordinate, and how the joint's coordinate relates to it.
struct GroundedBody {
  int body = 0;
  int joint = 0;
  OneFreedom freedom;
  double sign = 1;  ///< freedom coordinate = sign · joint coordinate; -1 where ground is the joint's second
                    ///< body and it turns
};

/// A follower that one slipping contact with the driver closes.
struct ContactGroup {
  int contact = 0;
  GroundedBody follower;
  ContactPair pair;  ///< body 1: the driver, body 2: the follower
  bool driver_is_first =
      true;  ///< whether the contact names the driver first; else its columns are exchanged
};

/// The order of solution: the driver, then the follower.
struct Plan {
  GroundedBody driver;
  std::optional<ContactGroup> group;
  double size = 0;  ///< largest distance between joint points and curve centres or vertices, in the poses [m]
};

/// The plan of a mechanism of a driver on ground and at most one follower on ground that touch each other.
/// Anything else is refused with a message that names what is too much or missing.
[[nodiscard]] tl::expected<Plan, std::string> make_plan(const Mechanism& mechanism);

}  // namespace higherpair
