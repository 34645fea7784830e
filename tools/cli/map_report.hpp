#pragma once

#include "higherpair/front/map.hpp"

#include <string>

#include <nlohmann/json.hpp>

namespace higherpair::cli {

/// The maps as readable text, as CSV, and as JSON.
[[nodiscard]] std::string map_text(const MapReport& report);
[[nodiscard]] std::string map_csv(const MapReport& report);
[[nodiscard]] nlohmann::ordered_json map_json(const MapReport& report);

}  // namespace higherpair::cli
