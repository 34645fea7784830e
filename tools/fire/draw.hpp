#pragma once

#include "higherpair/geometry/pose.hpp"

#include <cstdint>
#include <random>

namespace higherpair::fire {

/// Random numbers; a seed gives the same ones on every machine.
class Draw {
public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  int pick(int count) { return static_cast<int>(between(0, count)); }
  bool chance(double p) { return between(0, 1) < p; }
  double angle() { return between(-kPi, kPi); }

private:
  std::mt19937_64 engine_;
};

}  // namespace higherpair::fire
