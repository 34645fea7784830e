#pragma once

#include "case.hpp"

#include <string>

namespace higherpair::fire {

struct Counts {
  long cases = 0;
  long found = 0;
  long rows = 0;
  long flagged = 0;   ///< rows that say themselves that they are not ok
  long compared = 0;  ///< rates held against differences
  long runs = 0;      ///< of whole profiles
  long refused = 0;   ///< profiles that the reader does not take
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
  Failure failure;  ///< the first
};

/// How much of a case is tried.
enum class Depth {
  kPair,   ///< the contact is found and followed
  kWhole,  ///< and the profile of the whole case is read and run
};

/// Finds and tracks the contact of the pair, then reads and runs the profile of the whole case; every row
/// that counts as ok is held against laws that know nothing of how it was found.
[[nodiscard]] Trial try_case(const Case& one, Depth depth);

/// A smaller case that fails by the same law: fewer rows, rounder numbers.
[[nodiscard]] Case shrink(Case one, const std::string& law, Depth depth);

}  // namespace higherpair::fire
