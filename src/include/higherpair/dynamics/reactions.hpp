#pragma once

#include <optional>
#include <vector>

namespace higherpair {

/// Reaction of a joint on its second body; empty where the balance leaves it indeterminate. Springs, dampers
/// and the driving effort on the joint are not included.
struct JointReaction {
  std::optional<double> fx;  ///< in ground [N]
  std::optional<double> fy;  ///< [N]
  /// [N m]; prismatic joints: about the second point; gears and belts: on the second wheel.
  std::optional<double> moment;
};

/// Reaction of a contact on its second body.
struct ContactReaction {
  std::optional<double> force;  ///< along n, the outward normal of the first body [N]: > 0 pressing
  /// Along t = n turned +90° [N]: keeps a rolling contact from slipping; 0 where it slips.
  std::optional<double> friction;
  bool pulls = false;  ///< force < 0 by more than rounding: the contact opens
};

/// Effort of a driver on its joint: on the second body, positive in the sense of the joint's coordinate [N m
/// on a revolute joint, else N].
struct DriverEffort {
  std::optional<double> effort;    ///< from the balance of the bodies
  std::optional<double> by_power;  ///< from virtual power: -Σ wrench·velocity for a unit rate of this driver
};

struct Reactions {
  bool defined = false;                   ///< false: the row has no rates, or no balance; all else is empty
  std::vector<JointReaction> joints;      ///< of Mechanism::joints
  std::vector<ContactReaction> contacts;  ///< of Mechanism::contacts
  std::vector<DriverEffort> drivers;      ///< of Mechanism::drivers

  /// Whether one of the contacts pulls.
  [[nodiscard]] bool opens() const;
};

}  // namespace higherpair
