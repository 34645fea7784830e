#pragma once

#include "higherpair/drawing/plot.hpp"
#include "higherpair/front/map.hpp"
#include "higherpair/front/model.hpp"

#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// What is plotted against what.
struct PlotSettings {
  std::vector<std::string> y;    ///< names or globs of columns, at least one
  std::optional<std::string> x;  ///< a column; none: the (first) driver, in time the time
  RunSettings run;  ///< `columns` is set from the above; `forces` and `jerk` where columns need it
};

/// Columns of a run as a plot, with its events and the rows that are not ok.
struct MotionPlot {
  PlotData data;
  bool good = false;     ///< as Motion::good
  bool stopped = false;  ///< as Motion::stopped: rows are missing
  Diagnostics notes;     ///< as Analysis::notes
};

/// Runs the model and plots columns of its table. Fails as Model::run does, for a name that no column has,
/// and for columns of words.
[[nodiscard]] Result<MotionPlot> plot_of(const Model& model, const PlotSettings& settings);

/// The configuration spaces of a map's contacts, one plot each: all branches over the driver, folds marked,
/// the mechanism's own branch emphasised. A contact without a map is left out.
[[nodiscard]] std::vector<PlotData> plots_of(const MapReport& map);

}  // namespace higherpair
