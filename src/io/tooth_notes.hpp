#pragma once

#include "higherpair/io/units.hpp"
#include "higherpair/mechanism/description.hpp"

#include <string>

namespace higherpair::io_detail {

/// Interference of a contact of involutes whose base circles turn about two pivots on ground: the tips of one
/// reach past where the flanks of the other begin. Empty if they do not, and of other contacts.
[[nodiscard]] std::string tooth_note(const Mechanism& mechanism, const Contact& contact, const Units& units);

}  // namespace higherpair::io_detail
