#pragma once

#include "higherpair/io/units.hpp"
#include "higherpair/mechanism/description.hpp"

#include <string>

namespace higherpair::io_detail {

/// What is probably a slip in the curves of a contact, by where the poses have them: a curve behind the flat
/// face that it touches, a disc within the outline of a solid one, teeth that interfere. Empty if nothing is.
[[nodiscard]] std::string contact_note(const Mechanism& mechanism, const Contact& contact,
                                       const Units& units);

}  // namespace higherpair::io_detail
