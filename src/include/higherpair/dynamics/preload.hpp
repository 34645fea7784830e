#pragma once

#include "higherpair/mechanism/plan.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace higherpair {

/// A constant addition that presses contacts together: to the tension of a spring, or as an effort on a
/// joint.
struct Preload {
  enum class On { kSpring, kJoint } on = On::kSpring;
  int index = 0;  ///< of Mechanism::springs or Mechanism::joints
};

/// What can be preloaded: the springs that have a stiffness; if there are none, the joints that carry the
/// followers of contacts: revolute or prismatic, between a body of the contact's group and a preceding body.
[[nodiscard]] std::vector<Preload> preloads_of(const Mechanism& mechanism, const Plan& plan);

struct ContactForces;

/// How preloads are rounded to numbers that can be printed.
struct PreloadRounding {
  /// For every preload: `round` changes it by no more [N, or N m where it turns].
  std::vector<double> margin;
  std::function<double(std::size_t, double)> round;  ///< rounded value of the preload with this index
};

/// The smallest additions to the preloads that keep all contacts closed along the whole path: of a single one
/// if that is sufficient, otherwise of several together (least sum, torques divided by the mechanism's size).
/// The free length of a spring between two points cannot become negative. None where no preload suffices.
///
/// The contact forces are linear in the preloads, so this is a linear programme with a condition at every
/// position. It is solved by exchange: first for a few positions, then with the worst position of that
/// solution added, until no position violates its condition. With a rounding, the additions are rounded, and
/// the contacts are closed for the rounded numbers. \return one addition for each of forces.preloads [N, or N
/// m where it turns]
[[nodiscard]] std::optional<std::vector<double>> smallest_preloads(const ContactForces& forces,
                                                                   const Mechanism& mechanism, double size,
                                                                   const PreloadRounding* rounding = nullptr);

/// The factor on all velocities of the drivers (its square on their accelerations) up to which every contact
/// stays closed along the whole path: least sqrt(-rest/inertia). Infinite where no speed opens one, 0 where
/// one opens at rest already. None where it is not known: dampers act, a force is not defined on the whole
/// path, or falls below 0 next to a singular position.
[[nodiscard]] std::optional<double> highest_speed(const ContactForces& forces);

}  // namespace higherpair
