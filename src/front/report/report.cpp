#include "front/analysis_impl.hpp"
#include "front/columns/column_set.hpp"
#include "front/demands.hpp"
#include "front/model_data.hpp"
#include "front/pictures/column_scales.hpp"
#include "front/pictures/reach.hpp"
#include "front/run_settings.hpp"
#include "front/tolerances.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/front/pictures.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/numeric/stop.hpp"
#include "report_data.hpp"
#include "report_page.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr std::string_view kDataMark = "@REPORT_DATA@";

// Whether a driver changes its position during the run.
bool moves(const Model& model, std::size_t driver, bool in_time) {
  const DriverProgram& program = model.profile().programs[driver];
  if (program.law) return true;
  if (in_time) return program.velocity != 0 || program.acceleration != 0;
  if (!program.positions.empty()) return program.positions.size() > 1;
  return program.end ? *program.end != program.start : driver_turns(model.mechanism(), driver);
}

// The first driver that moves, or the first of all.
std::size_t shown_driver(const Model& model, bool in_time) {
  for (std::size_t i = 0; i < model.profile().programs.size(); ++i) {
    if (moves(model, i, in_time)) return i;
  }
  return 0;
}

void note(std::vector<ColumnExtremes>& extremes, const Row& row, double driver) {
  for (std::size_t k = 0; k < extremes.size(); ++k) {
    const double value = row.values[k];
    if (std::isnan(value)) {
      continue;
    }
    auto& [low, high] = extremes[k];
    if (!(low.value <= value)) low = {value, driver, row.number};
    if (!(high.value >= value)) high = {value, driver, row.number};
  }
}

// Of values that are equal to within rounding the first one of the page is named.
void name_first(ReportData& data, std::size_t driver) {
  for (std::size_t k = 0; k < data.extremes.size(); ++k) {
    auto& [low, high] = data.extremes[k];
    const double rounding = kColumnNoise * std::max(std::abs(low.value), std::abs(high.value));
    for (ColumnExtremes::Value* extreme : {&low, &high}) {
      const auto first = std::find_if(data.rows.begin(), data.rows.end(), [&](const Row& row) {
        return std::abs(row.values[k] - extreme->value) <= rounding;
      });
      if (first != data.rows.end() && first->number < extreme->row) {
        *extreme = {extreme->value, first->values[driver], first->number};
      }
    }
  }
}

// Number of rows of the run from one row of the page to the next.
std::int64_t stride_of(std::int64_t size, const ReportSettings& settings) {
  const std::int64_t gaps = settings.most_rows - 1;
  return std::max<std::int64_t>(1, (size - 1 + gaps - 1) / gaps);
}

ReportData collect(const Model& model, Analysis& analysis, const ReportSettings& settings) {
  ReportData data;
  data.columns = analysis.columns();
  data.extremes.resize(data.columns.size());
  data.size = analysis.size();
  data.driver = shown_driver(model, settings.in_time);
  const std::int64_t stride = stride_of(data.size, settings);
  const std::size_t driver = column_slot(data.columns, driver_name(model.mechanism().drivers[data.driver]));
  Row row;
  while (analysis.next(row)) {
    note(data.extremes, row, row.values[driver]);
    if (row.number % stride == 0 || row.number == data.size - 1) {
      data.rows.push_back(row);
      data.motions.push_back(analysis.impl().run.row);
      if (const Reactions* reactions = analysis.impl().reactions) data.reactions.push_back(*reactions);
    }
    if (settings.progress) {
      settings.progress(row.number, data.size);
    }
  }
  data.events = analysis.events();
  data.good = analysis.good();
  std::vector<double> largest;
  for (const auto& [low, high] : data.extremes) {
    largest.push_back(std::isnan(low.value) ? 0 : std::max(std::abs(low.value), std::abs(high.value)));
  }
  data.scales = scales_of(data.columns, largest);
  name_first(data, driver);
  return data;
}

std::string filled(std::string_view page, std::string_view json) {
  const std::size_t at = page.find(kDataMark);
  std::string html(page.substr(0, at));
  html += json;
  html += page.substr(at + kDataMark.size());
  return html;
}

}  // namespace

std::size_t page_row(const ReportData& data, std::int64_t row) {
  const auto found =
      std::lower_bound(data.rows.begin(), data.rows.end(), row,
                       [](const Row& one, std::int64_t number) { return one.number < number; });
  return std::min(static_cast<std::size_t>(found - data.rows.begin()), data.rows.size() - 1);
}

Result<Report> report_of(const Model& model, const ReportSettings& settings) {
  if (report_page().empty()) {
    return wrong(model,
                 fmt::format("report: this program was built without the page of reports: {}; install nodejs "
                             "and npm (tools/setup does) and build again with -DHIGHERPAIR_REPORT=ON",
                             report_page_missing()));
  }
  constexpr std::int64_t kFewest = 2;
  if (std::string fault = first_unmet({at_least(kFewest, "setting most_rows", settings.most_rows)});
      !fault.empty()) {
    return wrong(model, std::move(fault));
  }
  RunSettings run = run_settings(settings, settings.in_time);
  run.forces = has_forces(model.mechanism());
  auto analysis = model.start(run);
  if (!analysis) {
    return tl::unexpected(std::move(analysis.error()));
  }
  Report report;
  const ReportData data = collect(model, *analysis, settings);
  report.notes = analysis->notes();
  report.events = data.events;
  report.good = data.good;
  report.size = data.size;
  report.every = stride_of(data.size, settings);
  report.stopped = is_raised(settings.stop);
  if (!data.rows.empty() && !report.stopped) {
    if (auto error = nothing_to_draw(model, data.motions)) {
      return tl::unexpected(*std::move(error));
    }
    const std::string json = json_of(model, data, settings.source, settings.stop);
    report.stopped = is_raised(settings.stop);
    report.html = report.stopped ? "" : filled(report_page(), json);
  }
  report.good = report.good && !report.stopped;
  return report;
}

}  // namespace higherpair
