#pragma once

#include <string_view>

namespace higherpair {

/// The version of the library, as "1.2.3".
[[nodiscard]] std::string_view version();

}  // namespace higherpair
