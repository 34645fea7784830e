#pragma once

#include "higherpair/design/optimise.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace higherpair::cli {

/// How a search has ended as bytes, in the order of the machine: what a record of the journal holds.
[[nodiscard]] std::string search_bytes(const DesignSearchEnd& end);

/// The end; none where bytes are missing or too many.
[[nodiscard]] std::optional<DesignSearchEnd> search_of(std::string_view bytes);

}  // namespace higherpair::cli
