#pragma once

#include "higherpair/io/diagnostic.hpp"

#include <array>
#include <string>
#include <string_view>

namespace higherpair {

/// What a measure says of the values v of its column, over all rows of a run in which it has one.
enum class MeasureKind {
  kMax,
  kMin,
  kMaxAbs,  ///< max |v|
  kRange,   ///< max v − min v
  kMean,    ///< every row counts as much as every other
  kRms,     ///< √(mean of v²), likewise
  kFirst,   ///< v in the first row of the run
  kLast,
  kAt,  ///< v in the row at a given place
};

/// The words of the key `of`, by MeasureKind.
inline constexpr std::array<std::string_view, 9> kMeasureNames = {"max", "min",   "maxabs", "range", "mean",
                                                                  "rms", "first", "last",   "at"};

[[nodiscard]] constexpr std::string_view name_of(MeasureKind kind) {
  return kMeasureNames[static_cast<std::size_t>(kind)];
}

/// One number about a run, as a profile asks for it: `{ column = "follower.alpha", of = "max" }`.
struct Measure {
  std::string column;
  MeasureKind of = MeasureKind::kMax;
  double at = 0;     ///< of kAt: position of the (first) driver, of a run in time the time; as tables show it
  Place place;       ///< of the column's name in the profile
  std::string path;  ///< of the same, "sweep.results.peak.column"
};

}  // namespace higherpair
