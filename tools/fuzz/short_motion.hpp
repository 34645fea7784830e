#pragma once

#include <cstddef>
#include <cstdint>

namespace higherpair::fuzz {

struct ShortMotion {
  int rows = 6;
  double step = 0.1;  ///< of each driver, from row to row [rad or m]
  bool forces = true;
};

/// Reads a text as a profile, starts it if it can be read, and moves it by a few rows. Aborts if a row is not
/// finite, or is ok without satisfying closure.
void run_short_motion(const std::uint8_t* data, std::size_t size, const ShortMotion& motion);

}  // namespace higherpair::fuzz
