#include "higherpair/front/sensitivity.hpp"

#include "arena.hpp"
#include "higherpair/io/tolerance_task.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "number_slopes.hpp"
#include "path_results.hpp"
#include "sensitivity_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>

namespace higherpair {
namespace {

// Change of a result by a change of a number over its whole scale, of the largest value of its column: less
// is rounding.
constexpr double kNoSlope = 1e-10;

// Slopes at places where a column is equally large that differ by less are equal, of the larger one.
constexpr double kSameSlope = 1e-7;

constexpr double kKink = 0.75;          // of the bend with two steps: with one step as much is a kink
constexpr double kKinkOf = 1e-3;        // of the slope: less is no kink
constexpr double kKinkRounding = 1e-8;  // of the result: nor is less than that
constexpr std::size_t kChunk = 64;      // rows that are differentiated at once

// A run that has moved to a place.
struct Stop {
  PathPlace place;
  Run run;
};

// Everything that the slopes of one report are made from.
class Differentiator {
public:
  Differentiator(const Model& model, const SensitivitySettings& settings, std::vector<Measure> measures,
                 RunSettings run, std::vector<ProfileNumber> numbers)
      : model_(model),
        settings_(settings),
        measures_(std::move(measures)),
        run_(std::move(run)),
        numbers_(std::move(numbers)) {}

  // The run itself; then all slopes.
  [[nodiscard]] std::optional<Error> work(SensitivityReport& report) {
    auto analysis = model_.start(run_);
    if (!analysis) return analysis.error();
    columns_.emplace(*analysis, run_);
    const PathResults results(*analysis, *columns_, measures_, true);
    results_ = results.results();
    report.events = analysis->events();
    report.good = analysis->good();
    report.notes = analysis->notes();
    report.where_unit = where_unit(*columns_);
    put_values(report);
    if (auto error = make_models()) return error;
    for (std::size_t i = 0; i < models_.size(); ++i) report.numbers[i].scale = models_[i]->scale();
    if (!stopped()) take_places();
    if (!stopped()) take_rows();
    if (!stopped()) combine(report);
    if (!stopped()) differences(report);
    report.stopped = stopped();
    return std::nullopt;
  }

  [[nodiscard]] static std::string where_unit(const PathColumns& columns) {
    const DriverSchedule& schedule = columns.drivers().schedule();
    return unit_text(schedule.is_timed() && columns.settings().in_time
                         ? dimension::kTime
                         : driver_dimension(columns.data().profile.mechanism),
                     columns.units());
  }

private:
  [[nodiscard]] bool stopped() const { return run_.stop != nullptr && run_.stop->load(); }

  [[nodiscard]] double where(const PathPlace& place) const {
    return run_.in_time ? columns_->drivers().time(place)
                        : columns_->drivers().at(place).front().profile.position;
  }

  void put_values(SensitivityReport& report) const {
    for (std::size_t m = 0; m < results_.size(); ++m) {
      ResultSensitivity& to = report.results[m];
      const PathResult& from = results_[m];
      to.unit = columns_->columns()[from.column].unit;
      to.value = from.value;
      if (from.where) to.where = where(*from.where);
      to.rival = from.rival;
      if (from.rival_where) to.rival_where = where(*from.rival_where);
      if (std::isnan(from.value)) to.remark = "it has no value on this run";
      if (from.constant) to.remark = "it is the same everywhere on the path";
      if (from.grows) to.remark = "it still grows there, towards a limit position or dead point";
    }
  }

  [[nodiscard]] std::optional<Error> make_models() {
    const double size = columns_->start().plan().size;
    slopes_.resize(numbers_.size());
    for (const ProfileNumber& number : numbers_) {
      auto models = NumberModels::of(model_, number, size);
      if (!models) return models.error();
      models_.push_back(std::make_unique<NumberModels>(*std::move(models)));
    }
    for_each_on_threads(numbers_.size(), settings_.threads, [&](std::size_t i) {
      if (!stopped()) slopes_[i] = std::make_unique<NumberSlopes>(*columns_, *models_[i]);
    });
    return std::nullopt;
  }

  [[nodiscard]] bool is_exact(std::size_t m) const {
    return has_exact_slope(columns_->columns()[results_[m].column]) && !results_[m].jumps;
  }

  // Slopes of all columns at every place of an extreme, by every number.
  void take_places() {
    std::vector<PathPlace> places;
    for (std::size_t m = 0; m < results_.size(); ++m) {
      for (const auto& part : results_[m].parts) {
        for (const ExtremePlace& extreme : part) places.push_back(extreme.place);
      }
    }
    std::sort(places.begin(), places.end(), [](auto& a, auto& b) { return a.row < b.row; });
    const auto same = [](auto& a, auto& b) { return a.row == b.row; };
    places.erase(std::unique(places.begin(), places.end(), same), places.end());
    std::vector<Stop> stops;
    PathWalk walk(*columns_);
    for (const PathPlace& place : places) {
      if (stopped()) return;
      stops.push_back({place, walk.go_to(place)});
      place_index_[place.row] = stops.size() - 1;
    }
    at_places_.resize(numbers_.size());
    for_each_on_threads(numbers_.size(), settings_.threads, [&](std::size_t i) {
      for (const Stop& stop : stops) {
        if (stopped()) return;
        at_places_[i].push_back(slopes_at(i, stop));
      }
    });
  }

  [[nodiscard]] std::vector<double> slopes_at(std::size_t number, const Stop& stop) const {
    const std::size_t count = columns_->columns().size();
    switch (slopes_[number]->state()) {
      case NumberSlopes::State::kNoInfluence:
        return std::vector<double>(count, 0.0);
      case NumberSlopes::State::kExact:
        return slopes_[number]->at(stop.run, stop.place).value_or(std::vector<double>(count, kNoValue));
      default:
        return std::vector<double>(count, kNoValue);
    }
  }

  // Of means: over all rows that have a value.
  void take_rows() {
    const bool needed = std::any_of(measures_.begin(), measures_.end(), [](const Measure& measure) {
      return measure.of == MeasureKind::kMean || measure.of == MeasureKind::kRms;
    });
    means_.assign(numbers_.size(), std::vector<double>(measures_.size(), 0.0));
    std::vector<std::int64_t> counted(measures_.size(), 0);
    const std::int64_t rows = columns_->drivers().schedule().size();
    PathWalk walk(*columns_);
    std::vector<double> values;
    for (std::int64_t row = 0; needed && row < rows && !stopped();) {
      std::vector<Stop> stops;
      std::vector<std::vector<double>> at;
      for (; row < rows && stops.size() < kChunk && !stopped(); ++row) {
        const PathPlace place{static_cast<double>(row), columns_->parameter_of(row)};
        stops.push_back({place, walk.go_to(place)});
        columns_->values(stops.back().run, place, values);
        at.push_back(values);
        for (std::size_t m = 0; m < measures_.size(); ++m) {
          counted[m] += std::isnan(values[results_[m].column]) ? 0 : 1;
        }
      }
      for_each_on_threads(numbers_.size(), settings_.threads, [&](std::size_t i) {
        for (std::size_t k = 0; k < stops.size() && !stopped(); ++k) add_means(i, stops[k], at[k]);
      });
    }
    for (std::vector<double>& means : means_) {
      for (std::size_t m = 0; m < means.size(); ++m) means[m] /= static_cast<double>(counted[m]);
    }
  }

  void add_means(std::size_t number, const Stop& stop, const std::vector<double>& values) {
    const std::vector<double> slopes = slopes_at(number, stop);
    for (std::size_t m = 0; m < measures_.size(); ++m) {
      const std::size_t column = results_[m].column;
      if (std::isnan(values[column])) continue;
      const double weight = measures_[m].of == MeasureKind::kRms
                                ? (results_[m].value > 0 ? values[column] / results_[m].value : 0)
                                : 1;
      means_[number][m] += weight * slopes[column];
    }
  }

  void combine(SensitivityReport& report) const {
    for (std::size_t m = 0; m < results_.size(); ++m) {
      for (std::size_t i = 0; i < numbers_.size(); ++i) {
        Slope& slope = report.results[m].slopes[i];
        slope = exact_slope(i, m);
        snap(slope, i, m);
      }
    }
  }

  [[nodiscard]] Slope exact_slope(std::size_t number, std::size_t m) const {
    const PathResult& result = results_[m];
    Slope slope;
    if (std::isnan(result.value)) {
      return slope;
    }
    if (result.parts.empty()) {
      slope.down = slope.up = means_[number][m];
    } else {
      slope.down = slope.up = 0;
      for (const auto& part : result.parts) {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const ExtremePlace& extreme : part) {
          const double one =
              extreme.weight * at_places_[number][place_index_.at(extreme.place.row)][result.column];
          least = std::isnan(one) ? one : std::min(least, one);
          most = std::isnan(one) ? one : std::max(most, one);
          if (std::isnan(one)) break;
        }
        slope.down += result.factor * least;
        slope.up += result.factor * most;
      }
    }
    const bool kink =
        std::abs(slope.up - slope.down) > kSameSlope * std::max(std::abs(slope.up), std::abs(slope.down));
    slope.kind = std::isnan(slope.up) || std::isnan(slope.down) ? SlopeKind::kNone
                 : kink                                         ? SlopeKind::kKink
                                                                : SlopeKind::kExact;
    return slope;
  }

  // What is rounding becomes 0.
  void snap(Slope& slope, std::size_t number, std::size_t m) const {
    const double least = kNoSlope * largest(m) / models_[number]->scale();
    if (std::abs(slope.up) <= least && std::abs(slope.down) <= least) {
      slope.up = slope.down = 0;
      if (slope.kind == SlopeKind::kKink) slope.kind = SlopeKind::kExact;
    }
  }

  [[nodiscard]] double largest(std::size_t m) const {
    return std::max(std::abs(results_[m].value), std::abs(results_[m].rival.value_or(0)));
  }

  // What could not be differentiated.
  void differences(SensitivityReport& report) const {
    for_each_on_threads(numbers_.size(), settings_.threads, [&](std::size_t i) {
      const NumberSlopes::State state = slopes_[i]->state();
      std::vector<std::size_t> open;
      for (std::size_t m = 0; m < results_.size(); ++m) {
        Slope& slope = report.results[m].slopes[i];
        if (state == NumberSlopes::State::kNoInfluence || std::isnan(results_[m].value)) continue;
        if (results_[m].grows || state == NumberSlopes::State::kRows) {
          slope = {};
          slope.remark =
              results_[m].grows ? "the result is without bounds" : "with another value there are other rows";
        } else if (slope.kind == SlopeKind::kNone || !is_exact(m)) {
          open.push_back(m);
        }
      }
      if (!open.empty()) take_differences(i, open, report);
    });
  }

  void take_differences(std::size_t i, const std::vector<std::size_t>& open,
                        SensitivityReport& report) const {
    const double h = kDifferenceStep * models_[i]->scale();
    std::array<std::vector<double>, 5> values;
    for (int k = -2; k <= 2 && !stopped(); ++k) {
      values[static_cast<std::size_t>(k + 2)] = results_with(i, k * h);
    }
    for (std::size_t m = 0; m < results_.size() && !stopped(); ++m) {
      if (std::find(open.begin(), open.end(), m) == open.end()) continue;
      Slope& slope = report.results[m].slopes[i];
      slope = slope_of({values[0][m], values[1][m], values[2][m], values[3][m], values[4][m]}, h,
                       kKinkRounding * largest(m));
      snap(slope, i, m);
    }
  }

  // With one number changed; NaN where it cannot be run so.
  [[nodiscard]] std::vector<double> results_with(std::size_t number, double h) const {
    std::vector<double> values(measures_.size(), kNoValue);
    const auto model = models_[number]->at(h);
    auto analysis = model ? model->start(run_) : Result<Analysis>(tl::unexpected(model.error()));
    if (analysis) {
      PathColumns columns(*analysis, run_);
      const PathResults results(*analysis, columns, measures_, false);
      for (std::size_t m = 0; m < values.size(); ++m) values[m] = results.results()[m].value;
    }
    return values;
  }

  [[nodiscard]] static Slope slope_of(const std::array<double, 5>& r, double h, double rounding) {
    Slope slope;
    const double one = (r[3] - r[1]) / (2 * h), two = (r[4] - r[0]) / (4 * h);
    const double bend = std::abs(r[3] - 2 * r[2] + r[1]), wide = std::abs(r[4] - 2 * r[2] + r[0]);
    slope.up = slope.down = (4 * one - two) / 3;
    if (std::isnan(slope.up)) {
      slope.remark = "with another value the mechanism cannot be run all the way";
      return slope;
    }
    slope.kind = SlopeKind::kDifferences;
    slope.error = std::abs(slope.up - one);
    // Of a smooth function the bend grows by 4, of a kink by 2.
    if (wide < kKink * 4 * bend && bend > kKinkOf * h * std::abs(slope.up) + rounding) {
      slope.kind = SlopeKind::kKink;
      slope.up = (2 * (r[3] - r[2]) - (r[4] - r[2]) / 2) / h;
      slope.down = (2 * (r[2] - r[1]) - (r[2] - r[0]) / 2) / h;
    }
    return slope;
  }

  const Model& model_;
  const SensitivitySettings& settings_;
  std::vector<Measure> measures_;
  RunSettings run_;
  std::vector<ProfileNumber> numbers_;
  std::optional<PathColumns> columns_;
  std::vector<PathResult> results_;
  std::vector<std::unique_ptr<NumberModels>> models_;
  std::vector<std::unique_ptr<NumberSlopes>> slopes_;
  std::map<double, std::size_t> place_index_;                // by the row
  std::vector<std::vector<std::vector<double>>> at_places_;  // of each number at each place all columns
  std::vector<std::vector<double>> means_;                   // of each number of each measure
};

}  // namespace

Result<SensitivityReport> sensitivity(const Model& model, const SensitivitySettings& settings) {
  auto numbers = numbers_for(model, settings.by);
  if (!numbers) {
    return tl::unexpected(std::move(numbers.error()));
  }
  SensitivityReport report;
  report.title = model.mechanism().title;
  for (const ProfileNumber& number : *numbers) report.numbers.push_back(number.number);
  std::vector<Measure> measures;
  WantedResults wanted = results_for(model, settings);
  for (NamedMeasure& one : wanted.results) {
    measures.push_back(one.measure);
    ResultSensitivity& result = report.results.emplace_back();
    result.name = std::move(one.name);
    result.measure = std::move(one.measure);
    result.slopes.resize(report.numbers.size());
  }
  report.in_time = wanted.in_time;
  RunSettings run;
  run.in_time = wanted.in_time;
  run.samples = settings.samples;
  run.tolerance = settings.tolerance;
  run.stop = settings.stop;
  const auto made = settings_for(model, measures, run);
  if (!made) {
    return tl::unexpected(made.error());
  }
  if (auto error =
          Differentiator(model, settings, std::move(measures), *made, *std::move(numbers)).work(report)) {
    return tl::unexpected(*std::move(error));
  }
  return report;
}

}  // namespace higherpair
