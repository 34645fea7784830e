#pragma once

#include "higherpair/io/profile.hpp"
#include "io/document/table_reader.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace higherpair::io_detail {

/// A note on a tolerance, at the path of the number.
struct FlankNote {
  std::string tolerance;  ///< its name
  std::string text;
};

/// Notes on tolerances of numbers for which the flank of a cam is cut: the roller's radius, the joints and
/// poses of the two bodies. Each variant has a flank of its own, cut for its own numbers, so these have no
/// influence on the motion.
[[nodiscard]] std::vector<FlankNote> flank_notes(const Table& document, const Profile& profile);

/// A note on a driver, given by its index, whose start and end are both beyond the same end of a flank on the
/// body that it moves: the follower would touch nothing but that end. Empty if there is nothing to note.
[[nodiscard]] std::string unreached_flank_note(const Profile& profile, std::size_t driver);

}  // namespace higherpair::io_detail
