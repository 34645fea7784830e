#pragma once

#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/measure.hpp"
#include "higherpair/sweep/variants.hpp"

#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// A number of the profile that is made with a tolerance. All numbers are in the unit in which the number
/// stands in the profile.
struct Tolerance {
  std::string name;
  std::vector<std::string> paths;  ///< as --set names them; several have one value
  double value = 0;                ///< as the profile has it
  double minus = 0;                ///< the zone is from value − minus …
  double plus = 0;                 ///< … to value + plus; −minus < plus, either may be negative
  std::string unit;                ///< "mm"; "1" of a pure number
  DistributionKind kind = DistributionKind::kNormal;  ///< about the middle of the zone; not kValues
  double sigmas =
      3;  ///< of a normal one: the ends of the zone are so many standard deviations from its middle
  Place place;

  [[nodiscard]] double middle() const { return value + (plus - minus) / 2; }
  /// Half the width of the zone, > 0.
  [[nodiscard]] double half() const { return (plus + minus) / 2; }
  [[nodiscard]] double deviation() const;
  /// As variants draw it. A normal one is not cut off at the ends of the zone.
  [[nodiscard]] Distribution distribution() const;
};

/// A number about the run that tolerances move.
struct ToleranceResult {
  std::string name;
  Measure measure;
  std::optional<double> within;  ///< it shall not move by more, in the unit of tables; > 0
};

/// What [tolerances] says: which numbers scatter, and what of the run is wanted.
struct ToleranceTask {
  std::vector<Tolerance> tolerances;      ///< at least one
  std::vector<Correlation> correlations;  ///< between tolerances, both normal
  std::vector<ToleranceResult> results;   ///< may be empty
  bool in_time = false;                   ///< runs in time, as `step`
  Place place;

  /// Random variants that scatter so; how many is left open.
  [[nodiscard]] VariantPlan variants() const;
};

}  // namespace higherpair
