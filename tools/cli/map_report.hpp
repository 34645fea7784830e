#pragma once

#include "higherpair/front/contacts.hpp"

#include <string>

namespace higherpair::cli {

/// The maps as readable text, as CSV, and as JSON; the last two are empty if interruption() occurs.
[[nodiscard]] std::string map_text(const MapReport& report);
[[nodiscard]] std::string map_csv(const MapReport& report);
[[nodiscard]] std::string map_json(const MapReport& report);

}  // namespace higherpair::cli
