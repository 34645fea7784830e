#pragma once

#include "higherpair/contact/contact_map.hpp"

#include <cstdint>
#include <optional>
#include <vector>

// How the branches of a map lie over the driver's range.

namespace higherpair {

/// A driver coordinate at which a branch gets a point.
struct SampleTarget {
  double u = 0;
  std::optional<std::int64_t> sample;
};

/// The samples within a branch, by rising u; its ends only where they belong to it. A branch between two
/// samples, or hardly more, gets points of its own.
/// \param size  of the pair [m]
[[nodiscard]] std::vector<SampleTarget> sample_targets(const MapBranch& branch, const MapRange& range,
                                                       bool cyclic, double size);

/// Whole turns of the driver after which a branch holds the start of the range or begins within it [rad].
[[nodiscard]] double turns_into_range(const MapBranch& branch, double start);

/// The whole turns that bring q into (-π, π] at the point nearest to the start of the range; they are added
/// to the coordinates of the branch. \pre a turning follower, and at least one point
double choose_turn(MapBranch& branch, double start);

/// Tells the events which branches end at them, and the ends which other branch does.
void join_branches(std::vector<MapBranch>& branches, std::vector<MapEvent>& events);

}  // namespace higherpair
