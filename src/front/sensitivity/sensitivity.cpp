#include "higherpair/front/sensitivity.hpp"

#include "difference_slope.hpp"
#include "exact_slopes.hpp"
#include "front/analysis_impl.hpp"
#include "front/check/check_parts.hpp"
#include "front/run_settings.hpp"
#include "front/tolerances.hpp"
#include "higherpair/io/tasks.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "higherpair/numeric/stop.hpp"
#include "number_slopes.hpp"
#include "numeric/arena.hpp"
#include "path_results.hpp"
#include "sensitivity_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

// Computes all slopes of one report.
class Differentiator {
public:
  Differentiator(const Model& model, const SensitivitySettings& settings, std::vector<Measure> measures,
                 RunSettings run, std::vector<ProfileNumber> numbers)
      : model_(model),
        settings_(settings),
        measures_(std::move(measures)),
        run_(std::move(run)),
        numbers_(std::move(numbers)) {}

  // Performs the run itself, then computes all slopes.
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
    if (results.end()) leave_open(*results.end(), report);
    if (auto error = make_models()) return error;
    for (std::size_t i = 0; i < models_.size(); ++i) report.numbers[i].scale = models_[i]->scale();
    ExactSlopes exact(*columns_, results_, measures_, slopes_, settings_.threads);
    if (!stopped()) exact.take();
    if (!stopped()) combine(exact, report);
    if (!stopped()) differences(report);
    report.stopped = stopped();
    report.good = report.good && !report.stopped;
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
  [[nodiscard]] bool stopped() const { return is_raised(run_.stop); }

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
      if (is_unbounded(from)) {
        to.remark = growth_text(from, report.where_unit) + ", towards a limit position or dead point";
      }
    }
  }

  // Says that the rest of a path is not examined.
  void leave_open(double end, SensitivityReport& report) const {
    report.events.push_back(
        end_of_examination(columns_->data().profile, columns_->drivers().schedule(), end));
    report.good = false;
    for (ResultSensitivity& result : report.results) {
      if (!is_extreme(result.measure.of) || !result.remark.empty()) continue;
      result.remark =
          fmt::format("not examined beyond {:.6g} {}", where(columns_->place(end)), report.where_unit);
    }
  }

  [[nodiscard]] static bool is_unbounded(const PathResult& result) {
    return result.grows || result.grows_with_other_sign || result.grows_at;
  }

  [[nodiscard]] std::string growth_text(const PathResult& result, const std::string& unit) const {
    if (result.grows) return "it still grows there";
    if (result.grows_at) return fmt::format("it still grows at {:.6g} {}", where(*result.grows_at), unit);
    return "with the other sign it still grows";
  }

  [[nodiscard]] std::optional<Error> make_models() {
    auto models = models_by(model_, numbers_, natural_scales(*columns_));
    if (!models) return models.error();
    models_ = *std::move(models);
    slopes_.resize(numbers_.size());
    for_each_on_threads(numbers_.size(), settings_.threads, [&](std::size_t i) {
      if (!stopped()) slopes_[i] = std::make_unique<NumberSlopes>(*columns_, *models_[i]);
    });
    return std::nullopt;
  }

  [[nodiscard]] bool is_exact(std::size_t m) const {
    return has_exact_slope(columns_->columns()[results_[m].column]) && !results_[m].jumps;
  }

  void combine(const ExactSlopes& exact, SensitivityReport& report) const {
    for (std::size_t m = 0; m < results_.size(); ++m) {
      for (std::size_t i = 0; i < numbers_.size(); ++i) {
        Slope& slope = report.results[m].slopes[i];
        slope = exact.of(i, m);
        snap(slope, i, m);
      }
    }
  }

  // Sets slopes that are rounding to 0.
  void snap(Slope& slope, std::size_t number, std::size_t m) const {
    const double factor = results_[m].constant                 ? kNoSlopeOfConstant
                          : largest(m) <= results_[m].rounding ? kNoSlopeOfRounding
                                                               : 0;
    const double noise = factor * results_[m].rounding;
    const double least = std::max(kNoSlope * largest(m), noise) / models_[number]->scale();
    if (std::abs(slope.up) <= least && std::abs(slope.down) <= least) {
      slope.up = slope.down = 0;
      if (slope.kind == SlopeKind::kKink) slope.kind = SlopeKind::kExact;
    }
  }

  [[nodiscard]] double largest(std::size_t m) const {
    return std::max(std::abs(results_[m].value), std::abs(results_[m].rival.value_or(0)));
  }

  // Finite differences for what could not be differentiated.
  void differences(SensitivityReport& report) const {
    std::vector<std::vector<std::size_t>> open;
    for (std::size_t i = 0; i < numbers_.size(); ++i) open.push_back(open_results(i, report));
    if (std::all_of(open.begin(), open.end(), [](const auto& results) { return results.empty(); })) return;
    const std::vector<double> unchanged = results_of(model_);
    for_each_on_threads(numbers_.size(), settings_.threads, [&](std::size_t i) {
      if (!open[i].empty()) take_differences(i, open[i], unchanged, report);
    });
  }

  // The results whose slopes by a number need differences. Remarks on those that have none.
  [[nodiscard]] std::vector<std::size_t> open_results(std::size_t i, SensitivityReport& report) const {
    const NumberSlopes::State state = slopes_[i]->state();
    std::vector<std::size_t> open;
    for (std::size_t m = 0; m < results_.size(); ++m) {
      Slope& slope = report.results[m].slopes[i];
      if (state == NumberSlopes::State::kNoInfluence || std::isnan(results_[m].value)) continue;
      if (!slope.remark.empty()) continue;
      const bool unbounded = is_unbounded(results_[m]);
      if (unbounded || state == NumberSlopes::State::kRows) {
        slope = {};
        slope.remark = unbounded ? "the result is without bounds" : "with another value there are other rows";
      } else if (slope.kind == SlopeKind::kNone || !is_exact(m)) {
        open.push_back(m);
      }
    }
    return open;
  }

  void take_differences(std::size_t i, std::vector<std::size_t> open, const std::vector<double>& unchanged,
                        SensitivityReport& report) const {
    std::vector<DifferenceSlope> found(results_.size());
    double h = kDifferenceStep * models_[i]->scale();
    for (int k = 0; k < kMostDifferenceSteps && !open.empty(); ++k, h *= kShorterDifference) {
      std::array<std::vector<double>, 5> values;
      for (int step = -2; step <= 2; ++step) {
        values[step + 2] = step == 0 ? unchanged : results_with(i, step * h);
        if (stopped()) return;
      }
      for (const std::size_t m : open) {
        found[m].add({values[0][m], values[1][m], values[2][m], values[3][m], values[4][m]}, h, largest(m));
        Slope& slope = report.results[m].slopes[i];
        slope = found[m].slope();
        snap(slope, i, m);
      }
      std::erase_if(open, [&](std::size_t m) { return !found[m].needs_shorter_step(); });
    }
  }

  // The results with one number changed; NaN where the mechanism cannot be run with it.
  [[nodiscard]] std::vector<double> results_with(std::size_t number, double h) const {
    const auto model = models_[number]->at(h);
    return model ? results_of(*model) : std::vector<double>(measures_.size(), kNoValue);
  }

  [[nodiscard]] std::vector<double> results_of(const Model& model) const {
    std::vector<double> values(measures_.size(), kNoValue);
    if (auto analysis = model.start(run_)) {
      analysis->impl().start.reset();  // without events nothing has to be searched for openings
      PathColumns columns(*analysis, run_);
      const PathResults results(*analysis, columns, measures_, false);
      for (std::size_t m = 0; m < values.size(); ++m) values[m] = results.results()[m].value;
    }
    return values;
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
  const auto made = settings_for(model, measures, run_settings(settings, wanted.in_time));
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
