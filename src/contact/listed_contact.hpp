#pragma once

#include "higherpair/contact/finder.hpp"

namespace higherpair {

/// What find_contact looks for, taken from the list of all contacts: for pairs on which no safe step exists,
/// and where marching comes to rest. kUnbounded where there is no such list.
[[nodiscard]] FindResult find_listed_contact(const ContactPair& pair, double u, double q, int direction,
                                             bool from_overlap);

}  // namespace higherpair
