#pragma once

#include "higherpair/io/profile.hpp"
#include "table_reader.hpp"

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

}  // namespace higherpair::io_detail
