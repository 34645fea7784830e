#pragma once

#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/measure.hpp"
#include "higherpair/sweep/variants.hpp"

#include <string>
#include <vector>

namespace higherpair {

/// A column of a sweep's table: one number about the run of each variant.
struct SweepResult {
  std::string name;
  Measure measure;
  bool where = false;  ///< a column NAME.where as well: Measured::where
};

/// What [sweep] asks for: many variants of the profile, and what of each.
struct SweepTask {
  VariantPlan plan;
  std::vector<SweepResult> results;  ///< one row a variant
  std::vector<std::string> rows;     ///< names or globs of columns; not empty: all rows of every run instead
  bool in_time = false;              ///< runs in time, as `step`
  bool counts = false;               ///< columns of how many rows have which status, and of how many events
  Place place;                       ///< of [sweep] in the profile
  std::vector<std::string> units;    ///< of each variable, as tables show them; "1" of a pure number
};

}  // namespace higherpair
