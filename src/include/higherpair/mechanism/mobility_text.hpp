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

/// One sentence for every reason why count and rank differ or the start is singular, and the nature of the
/// mechanism if it has no freedom; empty if there is nothing to report.
[[nodiscard]] std::vector<std::string> explanations(const Mechanism& mechanism, const Mobility& mobility);

/// One sentence for each idle freedom.
[[nodiscard]] std::vector<std::string> idle_texts(const Mechanism& mechanism, const Mobility& mobility);

/// What is wrong with the number of drivers, with count and rank, and what to add or remove; none if the
/// number is right.
[[nodiscard]] std::optional<std::string> driver_objection(const Mechanism& mechanism,
                                                          const Mobility& mobility);

/// The same before a run: analyses the mechanism from its poses. None also where it cannot be assembled
/// there.
[[nodiscard]] std::optional<std::string> driver_objection(const Mechanism& mechanism,
                                                          const std::vector<double>& drivers);

/// The same for a mechanism whose plan leaves surplus conditions: whether the rank allows for them. None
/// without surplus, and for a driver and a follower that roll on each other: whether they can is only found
/// along the path, and reported there with the amount of slip.
[[nodiscard]] std::optional<std::string> surplus_objection(const Mechanism& mechanism, const Plan& plan,
                                                           const std::vector<double>& drivers);

}  // namespace higherpair
