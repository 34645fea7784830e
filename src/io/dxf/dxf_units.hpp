#pragma once

#include "higherpair/io/units.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace higherpair::io_detail {

/// Values of $INSUNITS and the units of profiles that they mean; other values have no counterpart in
/// profiles.
inline constexpr std::array<std::pair<std::string_view, Unit>, 7> kDxfUnits = {{{"1", Unit::kInch},
                                                                                {"2", Unit::kFoot},
                                                                                {"4", Unit::kMillimetre},
                                                                                {"5", Unit::kCentimetre},
                                                                                {"6", Unit::kMetre},
                                                                                {"7", Unit::kKilometre},
                                                                                {"13", Unit::kMicrometre}}};

[[nodiscard]] inline std::optional<Unit> unit_of_dxf(std::string_view number) {
  const auto* const known = std::find_if(kDxfUnits.begin(), kDxfUnits.end(),
                                         [&](const auto& unit) { return unit.first == number; });
  return known == kDxfUnits.end() ? std::nullopt : std::optional(known->second);
}

/// \pre a unit of length
[[nodiscard]] inline std::string_view dxf_unit(Unit length) {
  return std::find_if(kDxfUnits.begin(), kDxfUnits.end(),
                      [&](const auto& unit) { return unit.second == length; })
      ->first;
}

}  // namespace higherpair::io_detail
