#pragma once

#include "higherpair/io/units.hpp"
#include "higherpair/mechanism/description.hpp"

#include <string>

namespace higherpair::io_detail {

/// Interference in a contact of involutes whose base circles turn about two pivots on ground: the tips of one
/// reach beyond the start of the other's flanks. Empty if there is none, and for all other contacts.
[[nodiscard]] std::string tooth_note(const Mechanism& mechanism, const Contact& contact, const Units& units);

}  // namespace higherpair::io_detail
