#pragma once

#include "higherpair/mechanism/description.hpp"

#include <string>

namespace higherpair {

/// The name of a driver in tables, results and pictures: "driver", or "driver.NAME" if it has a name.
[[nodiscard]] inline std::string driver_name(const Driver& driver) {
  std::string name = "driver";
  if (!driver.name.empty()) {
    name.append(1, '.').append(driver.name);
  }
  return name;
}

/// The path of its table in a profile: "driver", or "drivers.NAME".
[[nodiscard]] inline std::string driver_path(const Driver& driver) {
  return driver.name.empty() ? "driver" : "drivers." + driver.name;
}

}  // namespace higherpair
