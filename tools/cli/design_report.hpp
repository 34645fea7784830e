#pragma once

#include "higherpair/front/design.hpp"

#include <string>

namespace higherpair::cli {

/// The results as readable text and as JSON.
[[nodiscard]] std::string design_text(const DesignReport& report);
[[nodiscard]] std::string design_json(const DesignReport& report);

}  // namespace higherpair::cli
