#pragma once

#include "higherpair/analysis/jerk.hpp"

#include <optional>
#include <span>
#include <vector>

namespace higherpair {

/// true_jerks_of() in closed form if every body is joined to ground by a driven joint, or by a free joint and
/// a slipping contact: the jerks of a cam and its followers, without the power series of a general mechanism.
/// None if the plan has other groups, a body has no rates, or a contact moves its follower along itself but
/// for so little that rounding shows.
[[nodiscard]] std::optional<std::vector<std::optional<BodyJerk>>> jerks_on_ground(
    const Run& run, std::span<const HigherRates> higher);

}  // namespace higherpair
