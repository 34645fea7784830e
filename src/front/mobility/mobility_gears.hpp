#pragma once

#include "higherpair/front/mobility.hpp"

#include <string>

#include <nlohmann/json.hpp>

namespace higherpair {

/// The key `gears` of mobility_json(). Empty where the mechanism is not assembled.
[[nodiscard]] nlohmann::ordered_json gears_json(const MobilityFindings& findings);

/// The same as text, a paragraph for each pair.
[[nodiscard]] std::string gears_text(const nlohmann::ordered_json& gears, const std::string& length_unit,
                                     const std::string& angle_unit);

}  // namespace higherpair
