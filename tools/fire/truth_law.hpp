#pragma once

#include "higherpair/io/profile.hpp"
#include "trial.hpp"

namespace higherpair::fire {

/// The truth law: the first limit and the rows before it are those of an independent follower (all conditions
/// at once, by the arc length of the solution curve, in short steps). `analyze` at 61 rows; a case that the
/// follower gives up passes, and one whose contact changes over to another.
[[nodiscard]] Failure truth_law(const Profile& profile);

/// The same of a boundary: all bodies move, with velocities and accelerations, as those of a mechanism that
/// does it by other means, up to the first limit.
[[nodiscard]] Failure twin_law(const Profile& profile, const Profile& twin);

}  // namespace higherpair::fire
