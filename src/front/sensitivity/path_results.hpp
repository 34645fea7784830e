#pragma once

#include "front/columns/path_columns.hpp"
#include "higherpair/dynamics/path_extremes.hpp"
#include "higherpair/front/measure.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <optional>
#include <span>
#include <vector>

namespace higherpair {

class SampledColumns;

/// A place of an extreme on the path: there the result is `weight` times the column.
struct ExtremePlace {
  PathPlace place;
  double weight = 1;
  /// Above 0: number of a stretch of the path on which the column keeps to the extreme. Its places follow one
  /// another.
  int stretch = 0;
};

/// The value of a measure on a path, and the places on which its derivative depends.
struct PathResult {
  double value = kNoValue;
  std::optional<PathPlace> where;
  std::optional<double> rival;  ///< see ResultSensitivity
  std::optional<PathPlace> rival_where;
  std::size_t column = 0;  ///< index in PathColumns
  /// value = factor · Σ over parts of the largest weight · column among the places of the part; for an
  /// extreme these are all places where it is largest. Empty for means.
  std::vector<std::vector<ExtremePlace>> parts;
  double factor = 1;
  bool jumps = false;  ///< the column has a jump or a kink at one of the places, which move with the numbers
  bool grows = false;  ///< unbounded, towards a singular position
  bool grows_with_other_sign = false;  ///< the same, but with the other sign than the value
  std::optional<PathPlace> grows_at;   ///< the same at a place that is not that of the extreme
  bool constant = false;               ///< an extreme of a column that is constant along the path
  double rounding = 0;                 ///< of a value of the column [its unit]; 0 if it depends on forces
};

/// Rounding of a column [its unit]; 0 where forces or masses are in it.
[[nodiscard]] double rounding_of(const PathColumns& columns, std::size_t column);

/// Measures on a run, each of a column of the run.
class PathResults {
public:
  /// Runs through the analysis, of which no row has been computed yet.
  /// \param ties  whether to find all places of an extreme, and rivals; else only the first place
  PathResults(Analysis& analysis, PathColumns& columns, std::span<const Measure> measures, bool ties);

  [[nodiscard]] const std::vector<PathResult>& results() const { return results_; }
  /// Where extremes are sought no further, as cut_to_examined() returns it.
  [[nodiscard]] std::optional<double> end() const { return end_; }

private:
  struct Extreme;

  void take_rows(Analysis& analysis, std::span<const Measure> measures);
  void take_extremes(std::span<const Measure> measures, bool ties);
  [[nodiscard]] PathResult extreme_result(const Measure& measure, std::size_t column,
                                          const std::vector<PathRange>& ranges, SampledColumns* sampled);
  [[nodiscard]] Extreme extreme(std::size_t column, double sign, const std::optional<PathExtreme>& found,
                                SampledColumns* sampled);
  [[nodiscard]] bool jumps_at(std::size_t column, const PathExtreme& found, double spread);

  PathColumns& columns_;
  DriverPath path_;  // as far as extremes are sought on it
  std::optional<double> end_;
  std::vector<PathResult> results_;
  std::vector<double> low_, high_;  // of each column over the rows
};

[[nodiscard]] constexpr bool is_extreme(MeasureKind kind) {
  return kind == MeasureKind::kMax || kind == MeasureKind::kMin || kind == MeasureKind::kMaxAbs ||
         kind == MeasureKind::kRange;
}

}  // namespace higherpair
