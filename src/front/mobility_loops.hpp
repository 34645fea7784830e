#pragma once

#include "higherpair/front/mobility.hpp"

#include <nlohmann/json.hpp>

namespace higherpair {

/// The keys `four_bars` and `slider_cranks` of mobility_json().
[[nodiscard]] nlohmann::ordered_json four_bars_json(const MobilityFindings& findings);
[[nodiscard]] nlohmann::ordered_json slider_cranks_json(const MobilityFindings& findings);

}  // namespace higherpair
