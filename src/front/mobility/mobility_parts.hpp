#pragma once

#include "higherpair/front/mobility.hpp"

#include <string>

#include <nlohmann/json.hpp>

namespace higherpair {

/// The JSON whose text mobility_json() returns.
[[nodiscard]] nlohmann::ordered_json json_of(const MobilityFindings& findings);

/// What every part of mobility_json() is written from.
struct MobilityParts {
  const MobilityFindings& findings;
  const Mechanism& mechanism = findings.model.mechanism();
  Scaling length = from_si(dimension::kLength, findings.model.units());
  Scaling angle = from_si(dimension::kAngle, findings.model.units());

  [[nodiscard]] const std::string& body(int index) const { return mechanism.bodies[index].name; }
};

/// The keys `four_bars` and `slider_cranks` of mobility_json().
[[nodiscard]] nlohmann::ordered_json four_bars_json(const MobilityFindings& findings);
[[nodiscard]] nlohmann::ordered_json slider_cranks_json(const MobilityFindings& findings);

/// The key `gears` of mobility_json(). Empty where the mechanism is not assembled.
[[nodiscard]] nlohmann::ordered_json gears_json(const MobilityFindings& findings);

/// The same as text, a paragraph for each pair.
[[nodiscard]] std::string gears_text(const nlohmann::ordered_json& gears, const std::string& length_unit,
                                     const std::string& angle_unit);

}  // namespace higherpair
