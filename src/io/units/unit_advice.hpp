#pragma once

#include "higherpair/io/units.hpp"

#include <string>
#include <string_view>

namespace higherpair::io_detail {

/// What to write instead of a word that is no unit: ": write rev/s", " (did you mean `N m`?)", or which units
/// there are of a length. Only of what is expected; empty if that is not clear.
/// \param text     the whole unit, "Nm/deg"
/// \param unknown  the word in it, "Nm"
[[nodiscard]] std::string unit_advice(std::string_view text, std::string_view unknown,
                                      const Dimension& expected);

}  // namespace higherpair::io_detail
