#pragma once

#include "higherpair/front/mobility.hpp"

#include <nlohmann/json.hpp>

namespace higherpair {

/// What mobility_json() is the text of.
[[nodiscard]] nlohmann::ordered_json json_of(const MobilityFindings& findings);

}  // namespace higherpair
