#pragma once

#include "higherpair/io/units.hpp"
#include "higherpair/mechanism/description.hpp"

#include <string>

namespace higherpair::io_detail {

/// Names a probable mistake in the curves of a contact, judged by the bodies' poses: a curve behind the flat
/// face that it touches, a disc within the outline of a solid one, teeth that interfere. Empty if there is
/// none.
[[nodiscard]] std::string contact_note(const Mechanism& mechanism, const Contact& contact,
                                       const Units& units);

}  // namespace higherpair::io_detail
