#pragma once

#include "higherpair/design/optimise.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace higherpair::cli {

/// The end of a search as bytes in the machine's representation: a record of the journal.
[[nodiscard]] std::string search_bytes(const DesignSearchEnd& end);

/// The end of a search; none if there are too few or too many bytes.
[[nodiscard]] std::optional<DesignSearchEnd> search_of(std::string_view bytes);

}  // namespace higherpair::cli
