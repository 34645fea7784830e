#pragma once

#include "higherpair/front/check.hpp"

#include <string>

namespace higherpair::cli {

/// The report as a table with at most 80 characters per line, as CSV, and as JSON.
[[nodiscard]] std::string check_text(const CheckReport& report);
[[nodiscard]] std::string check_csv(const CheckReport& report);
[[nodiscard]] std::string check_json(const CheckReport& report);

}  // namespace higherpair::cli
