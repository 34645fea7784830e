#pragma once

#include "higherpair/front/mobility.hpp"

#include <nlohmann/json.hpp>

namespace higherpair {

/// The JSON whose text mobility_json() returns.
[[nodiscard]] nlohmann::ordered_json json_of(const MobilityFindings& findings);

}  // namespace higherpair
