#pragma once

#include "higherpair/dynamics/path_extremes.hpp"
#include "higherpair/front/measure.hpp"
#include "path_columns.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace higherpair {

/// Where the path has an extreme: there the result is `weight` times the column.
struct ExtremePlace {
  PathPlace place;
  double weight = 1;
};

/// What a measure comes to on a path, and which places its derivative depends on.
struct PathResult {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::optional<PathPlace> where;
  std::optional<double> rival;  ///< see ResultSensitivity
  std::optional<PathPlace> rival_where;
  std::size_t column = 0;  ///< of PathColumns
  /// Of extremes: value = factor · Σ over parts of the largest weight · column of their places, which are all
  /// those where it is largest. Empty of other measures.
  std::vector<std::vector<ExtremePlace>> parts;
  double factor = 1;
  bool jumps = false;  ///< the column has a jump or a kink at one of the places: they move with the numbers
  bool grows = false;  ///< without bounds, towards a singular position
  bool constant = false;  ///< an extreme of a column that does not change along the path
  double rounding = 0;    ///< of an extreme [unit of the column]; 0 where forces or masses are in it
};

/// Measures on a run, each of which has a column there.
class PathResults {
public:
  /// Runs through the analysis, which has no row yet.
  /// \param ties  whether all places of an extreme are looked for, and rivals; else the first one alone
  PathResults(Analysis& analysis, PathColumns& columns, std::span<const Measure> measures, bool ties);

  [[nodiscard]] const std::vector<PathResult>& results() const { return results_; }

private:
  struct Extreme;
  class Sampled;

  void take_rows(Analysis& analysis, std::span<const Measure> measures);
  void take_extremes(std::span<const Measure> measures, bool ties);
  [[nodiscard]] PathResult extreme_result(const Measure& measure, std::size_t column,
                                          const std::vector<PathRange>& ranges, Sampled* sampled);
  [[nodiscard]] Extreme extreme(std::size_t column, double sign, const std::optional<PathExtreme>& found,
                                Sampled* sampled);
  [[nodiscard]] bool jumps_at(std::size_t column, const PathExtreme& found, double spread);

  PathColumns& columns_;
  std::vector<PathResult> results_;
  std::vector<double> low_, high_;  // of every column over the rows
};

[[nodiscard]] constexpr bool is_extreme(MeasureKind kind) {
  return kind == MeasureKind::kMax || kind == MeasureKind::kMin || kind == MeasureKind::kMaxAbs ||
         kind == MeasureKind::kRange;
}

}  // namespace higherpair
