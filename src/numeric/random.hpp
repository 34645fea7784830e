#pragma once

#include <algorithm>
#include <cstdint>
#include <random>

namespace higherpair {

/// Random numbers that are the same on every machine, with a sequence of its own for each number of a search.
class Random {
public:
  Random(std::uint64_t seed, int number) {
    std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                           static_cast<std::uint32_t>(number)};
    engine_.seed(sequence);
  }
  /// From 0 up to but not including 1.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// A whole number from 0 to n - 1.
  int below(int n) { return std::min(n - 1, static_cast<int>(uniform() * n)); }
  std::uint64_t number() { return engine_(); }

private:
  std::mt19937_64 engine_;
};

}  // namespace higherpair
