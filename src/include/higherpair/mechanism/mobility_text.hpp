#pragma once

#include "higherpair/mechanism/mobility.hpp"
#include "higherpair/mechanism/plan.hpp"

#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// "n = 4 bodies with ground, j = 4 joints and contacts (4 revolute joints of 1 freedom), sum f = 4".
[[nodiscard]] std::string elements_text(const MobilityCount& count);

/// "M = 3 (n - j - 1) + sum f = 3 (4 - 4 - 1) + 4 = 1".
[[nodiscard]] std::string formula_text(const MobilityCount& count);

/// The rank in words: "the 8 conditions on 9 coordinates have rank 8: freedom 1".
[[nodiscard]] std::string rank_text(const Mobility& mobility);

/// One sentence for every reason for which count and rank differ or the start is singular, and what the
/// mechanism is if it has no freedom; nothing where there is nothing to say.
[[nodiscard]] std::vector<std::string> explanations(const Mechanism& mechanism, const Mobility& mobility);

/// One sentence for each idle freedom.
[[nodiscard]] std::vector<std::string> idle_texts(const Mechanism& mechanism, const Mobility& mobility);

/// What is wrong with the number of drivers, the count and the rank behind it, and what to add or remove;
/// none if they fit.
[[nodiscard]] std::optional<std::string> driver_objection(const Mechanism& mechanism,
                                                          const Mobility& mobility);

/// The same for whoever starts a run: analyses the mechanism from its poses. None also where it cannot be
/// assembled there.
[[nodiscard]] std::optional<std::string> driver_objection(const Mechanism& mechanism,
                                                          const std::vector<double>& drivers);

/// The same for a mechanism that a plan places with conditions left over: whether the rank has room for them.
/// None without surplus, and for a driver and a follower that are to roll on each other: whether they can is
/// seen along the path, and how far they slip is said then.
[[nodiscard]] std::optional<std::string> surplus_objection(const Mechanism& mechanism, const Plan& plan,
                                                           const std::vector<double>& drivers);

}  // namespace higherpair
