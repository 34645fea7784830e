#include "column_scales.hpp"
#include "front/analysis_impl.hpp"
#include "front/columns/column_set.hpp"
#include "front/tolerances.hpp"
#include "higherpair/front/pictures.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/numeric/contains.hpp"
#include "plot_marks.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace higherpair {
namespace {

using Names = std::vector<std::string>;

// Replaces the run's setting `columns` in errors by that of the plot.
Error renamed(Error error, const std::string& x) {
  for (Diagnostic& diagnostic : error.diagnostics) {
    const std::string before = "setting columns ";
    if (diagnostic.place.source.starts_with(before)) {
      const std::string name = diagnostic.place.source.substr(before.size());
      diagnostic.place.source = (name == x ? "setting x " : "setting y ") + name;
    }
  }
  return error;
}

// Columns of forces and jerk are computed only where they are asked for.
Result<Analysis> started(const Model& model, const RunSettings& settings) {
  auto first = model.start(settings);
  if (first || first.error().kind != ErrorKind::kInput) {
    return first;
  }
  const auto more = settings_with_columns(model.data(), settings);
  return more ? model.start(*more) : std::move(first);
}

Result<Names> y_columns(const std::vector<Column>& columns, const Names& globs) {
  Names names;
  for (const std::string& glob : globs) {
    bool found = false;
    for (const Column& column : columns) {
      if (!column.words.empty() || !matches(glob, column.name)) continue;
      found = true;
      if (!contains(names, column.name)) names.push_back(column.name);
    }
    if (!found) {
      return wrong(Place{"setting y " + glob}, "this column holds words; a plot needs numbers");
    }
  }
  return names;
}

// Values that are tiny may be so in their unit, or be what rounding has left of 0: that shows beside the
// other columns of this unit, which are computed only then.
void set_noise(const Model& model, RunSettings run, std::vector<PlotSeries>& all) {
  const auto is_tiny = [](const PlotSeries& series) {
    const double largest = largest_of(series.y);
    return largest > 0 && largest < series.noise;
  };
  if (std::none_of(all.begin(), all.end(), is_tiny)) {
    return;
  }
  run = settings_with_columns(model.data(), run).value_or(run);
  run.columns.clear();
  const auto motion = model.run(run);
  if (!motion) {
    return;
  }
  const std::vector<Column>& columns = motion->columns();
  std::vector<double> largest;
  for (const Column& column : columns) largest.push_back(largest_of(motion->column(column.name).values));
  const std::vector<double> scales = scales_of(columns, largest);
  for (PlotSeries& series : all) {
    if (is_tiny(series)) series.noise = kColumnNoise * scales[column_slot(columns, series.name)];
  }
}

}  // namespace

Result<MotionPlot> plot_of(const Model& model, const PlotSettings& settings) {
  if (auto refusal = refuse_to_start(model.data())) {
    return tl::unexpected(*std::move(refusal));
  }
  const std::string driver_column = driver_name(model.mechanism().drivers.front());
  const std::string x_name = settings.x.value_or(settings.run.in_time ? "time" : driver_column);
  if (settings.y.empty()) {
    return wrong(Place{"setting y"}, "names no column; expected at least one, such as `driver.velocity`");
  }
  if (x_name.find_first_of("*?") != std::string::npos) {
    return wrong(Place{"setting x " + x_name}, "expected the name of one column");
  }
  RunSettings run = settings.run;
  run.columns = settings.y;
  run.columns.push_back(x_name);
  run.columns.push_back(driver_column);
  auto analysis = started(model, run);
  if (!analysis) {
    return tl::unexpected(renamed(std::move(analysis.error()), x_name));
  }
  const Result<Names> names = y_columns(analysis->columns(), settings.y);
  if (!names) {
    return tl::unexpected(names.error());
  }
  if (!analysis->columns()[column_slot(analysis->columns(), x_name)].words.empty()) {
    return wrong(Place{"setting x " + x_name}, "this column holds words; a plot needs numbers");
  }
  MotionPlot plot;
  const Motion motion(*std::move(analysis));
  plot.notes = motion.notes();
  plot.good = motion.good();
  plot.stopped = motion.stopped();
  if (motion.size() == 0 || plot.stopped) {
    return plot;
  }
  const ColumnValues x = motion.column(x_name);
  plot.data.title = model.mechanism().title;
  plot.data.x = {x_name, std::string(x.unit)};
  const std::vector<double> xs(x.begin(), x.end());
  for (const std::string& name : *names) {
    const ColumnValues y = motion.column(name);
    plot.data.series.push_back({name, std::string(y.unit), xs, {y.begin(), y.end()}});
  }
  set_noise(model, run, plot.data.series);
  const ColumnValues driver = motion.column(driver_column);
  const XColumn column = x_column(x);
  add_ranges(motion, column, driver, plot.data);
  add_breaks(motion, column, plot.data);
  add_events(motion, column, driver, plot.data);
  return plot;
}

}  // namespace higherpair
