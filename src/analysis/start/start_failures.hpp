#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/contact/finder.hpp"

#include <cstddef>
#include <string>

// Messages about why a mechanism cannot be assembled at the first positions of its drivers. They name no key
// of the profile: a driver may start by `start`, `positions` or a law, which is not known here.

namespace higherpair {

/// Why a contact cannot be followed from its start.
inline constexpr const char* kTouchesAtLimit =
    "at the first driver position the two bodies touch at a limit position, or where branches cross: nothing "
    "tells which way the motion goes on; start away from it";

/// Why no contact of two bodies has been found.
[[nodiscard]] std::string why_no_contact(FindStatus status, const Contact& contact);

/// Why the bodies of group g cannot be placed. \param state  with everything that could be placed
[[nodiscard]] std::string why_unplaced(const Run& run, const State& state, std::size_t g);

}  // namespace higherpair
