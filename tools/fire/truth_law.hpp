#pragma once

#include "higherpair/io/profile.hpp"
#include "trial.hpp"

namespace higherpair::fire {

/// The truth law: the first limit and the rows before it agree with those of an independent path follower,
/// which solves all constraints at once and steps along the arc length of the solution curve. Tests `analyze`
/// with 61 rows. Passes if the follower gives up or a contact changes over to another.
[[nodiscard]] Failure truth_law(const Profile& profile);

/// The same for boundaries: up to the first limit all bodies have the same positions, velocities and
/// accelerations as in a mechanism that moves in the same way by other means.
[[nodiscard]] Failure twin_law(const Profile& profile, const Profile& twin);

}  // namespace higherpair::fire
