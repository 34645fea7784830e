#pragma once

#include "encoding.hpp"

#include <string_view>

namespace higherpair::io_detail {

/// What was probably done, and what to do instead, at the place where the parser of TOML stopped; its own
/// message where that is not clear.
/// \param place    of the error in `text`
/// \param message  the parser's own
[[nodiscard]] TextMistake explain_syntax(std::string_view text, const Mark& place, std::string_view message);

}  // namespace higherpair::io_detail
