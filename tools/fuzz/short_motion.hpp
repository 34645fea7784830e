#pragma once

#include <cstddef>
#include <cstdint>

namespace higherpair::fuzz {

struct ShortMotion {
  int rows = 6;
  double step = 0.1;  ///< of a driver from row to row [rad or m]
  bool forces = true;
};

/// Reads a text as a profile, starts what can be read and moves it by a few rows. Ends the program where a
/// row is not finite, or counts as ok and does not close.
void run_short_motion(const std::uint8_t* data, std::size_t size, const ShortMotion& motion);

}  // namespace higherpair::fuzz
