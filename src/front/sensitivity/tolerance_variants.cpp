// Random variants within tolerances, compared with what slopes predict for them.
#include "front/analysis_impl.hpp"
#include "front/demands.hpp"
#include "front/run_settings.hpp"
#include "higherpair/front/sensitivity.hpp"
#include "higherpair/front/sweep.hpp"
#include "higherpair/numeric/stop.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

std::shared_ptr<const SweepTask> task_of(const ToleranceTask& tolerances, const SensitivityReport& report,
                                         const ToleranceVariantSettings& settings) {
  auto task = std::make_shared<SweepTask>();
  task->plan = tolerances.variants();
  task->plan.count = settings.count;
  task->plan.seed = settings.seed;
  task->in_time = report.in_time;
  task->place = tolerances.place;
  for (std::size_t i = 0; i < tolerances.tolerances.size(); ++i) {
    // Columns of a table need different names: these are named by number, as are the results.
    task->plan.variables[i].name = fmt::format("number.{}", i);
    task->units.push_back(tolerances.tolerances[i].unit);
  }
  for (std::size_t m = 0; m < report.results.size(); ++m) {
    task->results.push_back({fmt::format("result.{}", m), report.results[m].measure, false});
  }
  return task;
}

// The results of the model itself as its rows show them.
Result<std::vector<double>> values_by_rows(const Model& model, const SensitivityReport& report,
                                           RunSettings run) {
  std::vector<Measure> measures;
  for (const ResultSensitivity& result : report.results) measures.push_back(result.measure);
  return settings_for(model, measures, std::move(run))
      .and_then([&](const RunSettings& settings) { return model.start(settings); })
      .map([&](Analysis analysis) {
        MeasureSet set(measures, analysis.columns());
        Row row;
        while (analysis.next(row)) set.add(row);
        std::vector<double> values;
        for (std::size_t m = 0; m < set.size(); ++m) values.push_back(set.value(m).value);
        return values;
      });
}

// Whether a report has the slopes by these numbers, in their order.
bool is_about(const SensitivityReport& report, const ToleranceTask& tolerances) {
  return std::equal(report.numbers.begin(), report.numbers.end(), tolerances.tolerances.begin(),
                    tolerances.tolerances.end(),
                    [](const SensitivityNumber& a, const Tolerance& b) { return a.paths == b.paths; });
}

double quantile_of(std::vector<double>& values, double share) {
  const double place = share * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(place);
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(low), values.end());
  const double at = values[low];
  if (low + 1 == values.size()) {
    return at;
  }
  const double next = *std::min_element(values.begin() + static_cast<std::ptrdiff_t>(low) + 1, values.end());
  return std::lerp(at, next, place - static_cast<double>(low));
}

// The values of one result in all variants.
struct Collected {
  std::vector<double> values, linear;

  [[nodiscard]] VariantBand band(double nominal, std::optional<double> within) {
    VariantBand band;
    band.variants = static_cast<std::int64_t>(values.size());
    if (values.empty()) {
      return band;
    }
    long double sum = 0, squares = 0;
    std::int64_t inside = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      sum += values[k] - nominal;
      squares += (values[k] - nominal) * (values[k] - nominal);
      band.farthest = std::max(band.farthest, std::abs(values[k] - linear[k]));
      inside += !within || std::abs(values[k] - nominal) <= *within ? 1 : 0;
    }
    const auto count = static_cast<long double>(values.size());
    band.mean = nominal + static_cast<double>(sum / count);
    band.deviation = static_cast<double>(std::sqrt(std::max<long double>(0, squares - sum * sum / count) /
                                                   std::max<long double>(1, count - 1)));
    band.share_within = static_cast<double>(inside) / static_cast<double>(values.size());
    band.low = quantile_of(values, kBandQuantile);
    band.median = quantile_of(values, 0.5);
    band.high = quantile_of(values, 1 - kBandQuantile);
    band.linear_low = quantile_of(linear, kBandQuantile);
    band.linear_median = quantile_of(linear, 0.5);
    band.linear_high = quantile_of(linear, 1 - kBandQuantile);
    const double half = std::max(band.high - band.low, band.linear_high - band.linear_low) / 2;
    band.curved = std::max(std::abs(band.low - band.linear_low), std::abs(band.high - band.linear_high)) >
                  kCurvedShare * half;
    return band;
  }
};

}  // namespace

Result<ToleranceVariants> tolerance_variants(const Model& model, const SensitivityReport& report,
                                             const ToleranceVariantSettings& settings) {
  if (std::string fault = first_unmet({within(1, kMostToleranceVariants, "setting count", settings.count)});
      !fault.empty()) {
    return wrong(model, std::move(fault));
  }
  if (!model.profile().tolerances) {
    return wrong(model, "there is no [tolerances]: it says how far which numbers scatter");
  }
  const ToleranceTask& tolerances = *model.profile().tolerances;
  if (!is_about(report, tolerances)) {
    return wrong(
        model,
        "the report is about other numbers than those of [tolerances]: take sensitivity() without `by`");
  }
  const auto by_rows = values_by_rows(model, report, run_settings(settings, report.in_time));
  if (!by_rows) {
    return tl::unexpected(by_rows.error());
  }
  SweepSettings of_sweep;
  of_sweep.tolerance = settings.tolerance;
  of_sweep.samples = settings.samples;
  of_sweep.stop = settings.stop;
  of_sweep.task = task_of(tolerances, report, settings);
  const auto sweep = Sweep::of(model, of_sweep);
  if (!sweep) {
    return tl::unexpected(sweep.error());
  }
  const std::size_t width = sweep->columns().size(), first = sweep->first_result();
  std::vector<Collected> collected(report.results.size());
  ToleranceVariants variants;
  run_sweep(*sweep, 0, settings.threads, [&](const SweepBlock& block) {
    for (std::size_t row = 0; row * width < block.values.size(); ++row) {
      const double* values = block.values.data() + row * width;
      for (std::size_t m = 0; m < report.results.size(); ++m) {
        const ResultSensitivity& result = report.results[m];
        if (std::isnan(values[first + m]) || !block.causes[row].empty()) continue;
        double linear = result.value;
        for (std::size_t i = 0; i < tolerances.tolerances.size(); ++i) {
          const double change = values[1 + i] - tolerances.tolerances[i].value;
          const Slope& slope = result.slopes[i];
          if (slope.kind != SlopeKind::kNone) linear += slope.change(change);
        }
        collected[m].linear.push_back(linear);
        collected[m].values.push_back(values[first + m] + (result.value - (*by_rows)[m]));
      }
    }
    variants.count += block.variants;
    variants.good += block.good;
    if (settings.progress) settings.progress(variants.count);
    return !is_raised(settings.stop);
  });
  variants.stopped = variants.count < sweep->size();
  const std::vector<ToleranceBand> bands = tolerance_bands(tolerances, report);
  for (std::size_t m = 0; m < collected.size(); ++m) {
    variants.bands.push_back(collected[m].band(report.results[m].value, bands[m].within));
  }
  return variants;
}

}  // namespace higherpair
