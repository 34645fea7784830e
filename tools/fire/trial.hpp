#pragma once

#include "case.hpp"

#include <string>

namespace higherpair::fire {

struct Counts {
  long cases = 0;
  long found = 0;
  long rows = 0;
  long flagged = 0;   ///< rows that are reported as not ok
  long compared = 0;  ///< rates tested against differences
  long runs = 0;      ///< runs of whole profiles
  long refused = 0;   ///< profiles refused by the reader
  long failed = 0;

  Counts& operator+=(const Counts& other);
};

struct Failure {
  std::string law;  ///< empty: none
  std::string detail;
  int row = 0;

  explicit operator bool() const { return !law.empty(); }
};

struct Trial {
  Counts counts;
  Failure failure;  ///< the first one
};

/// How much of a case is tested.
enum class Depth {
  kPair,   ///< finding and following the contact
  kWhole,  ///< also reading and running the profile of the whole case
};

/// Finds and follows the contact of the pair, then reads and runs the profile of the whole case. Every row
/// that is ok is tested against laws that do not depend on how it was computed.
[[nodiscard]] Trial try_case(const Case& one, Depth depth);

/// A smaller case that fails by the same law: with fewer rows and rounder numbers.
[[nodiscard]] Case shrink(Case one, const std::string& law, Depth depth);

}  // namespace higherpair::fire
