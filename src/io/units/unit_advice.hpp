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

/// What to write instead of a number with a decimal comma or with separators of thousands, 30,5 or 1 000, to
/// the end of `text`, its unit or a comment. Empty for all else, and for a number that is right.
[[nodiscard]] std::string separator_advice(std::string_view text);

}  // namespace higherpair::io_detail
