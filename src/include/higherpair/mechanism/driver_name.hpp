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

}  // namespace higherpair
