#pragma once

#include "higherpair/front/mobility.hpp"

#include <string>

#include <nlohmann/json.hpp>

namespace higherpair::cli {

/// The gears whose teeth are known, in the profile's units: [{`joint`, `first`, `second` (bodies),
/// `pitch_radii` [two], `pressure_angle`, `module` (null if not given), `teeth` [two] (null where they are no
/// whole numbers), `mesh`}]. `mesh`, of outer gears with whole teeth, else null: {`approach`, `recess`,
/// `length` of the path of contact, `contact_ratio`, `past_base` [two] (> 0: interference at that wheel's
/// root), `least_teeth` (fewer are undercut by a rack)}. Empty where the mechanism is not assembled.
[[nodiscard]] nlohmann::ordered_json gears_json(const MobilityFindings& findings);

/// The same as readable text, a paragraph for each pair.
[[nodiscard]] std::string gears_text(const nlohmann::ordered_json& gears, const std::string& length_unit,
                                     const std::string& angle_unit);

}  // namespace higherpair::cli
