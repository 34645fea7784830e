#pragma once

#include "higherpair/contact/contact_map.hpp"

#include <cstdint>
#include <optional>
#include <vector>

// How the branches of a map are placed and sampled over the driver's range.

namespace higherpair {

/// A driver coordinate at which a branch is sampled.
struct SampleTarget {
  double u = 0;
  std::optional<std::int64_t> sample;
};

/// Where to sample a branch: the samples of the range within it, by rising u, its ends only where they belong
/// to it. A branch with very few samples gets points of its own instead.
/// \param size  of the pair [m]
[[nodiscard]] std::vector<SampleTarget> sample_targets(const MapBranch& branch, const MapRange& range,
                                                       bool cyclic, double size);

/// Whole turns [rad] to add to the driver coordinates of a branch so that it contains the start of the range
/// or begins within it.
[[nodiscard]] double turns_into_range(const MapBranch& branch, double start);

/// Adds to the coordinates of a branch the whole turns that bring q into (-π, π] at the point nearest to the
/// start of the range, and returns them. \pre a turning follower, and at least one point
double choose_turn(MapBranch& branch, double start);

/// Records at each event the branches that end there, and at each such end the other branch.
void join_branches(std::vector<MapBranch>& branches, std::vector<MapEvent>& events);

}  // namespace higherpair
