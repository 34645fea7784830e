#pragma once

#include "encoding.hpp"

#include <string_view>

namespace higherpair::io_detail {

/// Explains a syntax mistake at the position where the TOML parser stopped: what was probably written, and
/// what to write instead. Falls back to the parser's message where the cause is not clear.
/// \param place    of the error in `text`
/// \param message  from the parser
[[nodiscard]] Mistake explain_syntax(std::string_view text, const Mark& place, std::string_view message);

}  // namespace higherpair::io_detail
