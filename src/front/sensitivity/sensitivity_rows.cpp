// Derivatives of whole columns, row by row.
#include "difference_slope.hpp"
#include "front/columns/column_set.hpp"
#include "front/run_settings.hpp"
#include "front/tolerances.hpp"
#include "higherpair/front/sensitivity.hpp"
#include "higherpair/mechanism/driver_name.hpp"
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

namespace higherpair {
namespace {

Result<RunSettings> settings_for_columns(const Model& model, RunSettings settings) {
  if (auto refusal = refuse_to_start(model.data())) {
    return tl::unexpected(*std::move(refusal));
  }
  if (auto made = settings_with_columns(model.data(), settings)) {
    return *std::move(made);
  }
  settings.forces = settings.jerk = true;
  return tl::unexpected(columns_of(model.data(), settings, model.units()).error());
}

// The same run with one number changed by -2 h, -h, h and 2 h, row by row.
class SteppedRuns {
public:
  SteppedRuns(NumberModels& models, const RunSettings& settings, double h) {
    for (const double k : {-2.0, -1.0, 1.0, 2.0}) {
      const auto model = models.at(k * h);
      auto analysis = model ? model->start(settings) : Result<Analysis>(tl::unexpected(model.error()));
      if (!analysis) {
        analyses_.clear();
        return;
      }
      analyses_.push_back(*std::move(analysis));
    }
  }

  // Goes on to a row; false where one of the runs does not come to it.
  [[nodiscard]] bool go_to(std::int64_t number) {
    const auto comes = [&](std::size_t k) {
      do {
        if (!analyses_[k].next(rows_[k])) return false;
      } while (rows_[k].number < number);
      return true;
    };
    return analyses_.size() == rows_.size() && comes(0) && comes(1) && comes(2) && comes(3);
  }

  // The values of a column in that row; `unchanged` is that of the run itself.
  [[nodiscard]] std::array<double, 5> values(std::size_t c, double unchanged) const {
    return {rows_[0].values[c], rows_[1].values[c], unchanged, rows_[2].values[c], rows_[3].values[c]};
  }

private:
  std::vector<Analysis> analyses_;
  std::array<Row, 4> rows_;
};

// Derivatives of columns by one number from differences, row by row, with shorter steps where longer ones do
// not agree.
class RowDifferences {
public:
  // \param largest  of each column: smaller changes than its rounding are none
  RowDifferences(NumberModels& models, const RunSettings& settings, std::vector<std::size_t> columns,
                 const std::vector<double>& largest)
      : models_(models), settings_(settings), columns_(std::move(columns)), largest_(largest) {}

  // Writes the derivatives in the next row; NaN where there is none.
  void next(const Row& row, std::vector<double>& slopes) {
    std::vector<DifferenceSlope> found(slopes.size());
    std::vector<std::size_t> open = columns_;
    double h = kDifferenceStep * models_.scale();
    for (std::size_t k = 0; k < kMostDifferenceSteps && !open.empty(); ++k, h *= kShorterDifference) {
      if (k == runs_.size()) runs_.emplace_back(models_, settings_, h);
      if (!runs_[k].go_to(row.number)) continue;
      for (const std::size_t c : open) found[c].add(runs_[k].values(c, row.values[c]), h, largest_[c]);
      std::erase_if(open, [&](std::size_t c) { return !found[c].needs_shorter_step(); });
    }
    for (const std::size_t c : columns_) slopes[c] = slope_of(found[c]);
  }

private:
  // None at a kink or jump, where no steps agree.
  [[nodiscard]] static double slope_of(const DifferenceSlope& found) {
    const Slope& slope = found.slope();
    const bool told = !found.needs_shorter_step() || slope.error <= kDifferencesTell * std::abs(slope.up);
    return slope.kind == SlopeKind::kDifferences && told ? slope.up : kNoValue;
  }

  NumberModels& models_;
  const RunSettings& settings_;
  std::vector<std::size_t> columns_;
  const std::vector<double>& largest_;
  std::vector<SteppedRuns> runs_;  // by the length of their steps
};

class RowDifferentiator {
public:
  RowDifferentiator(const Model& model, const SensitivitySettings& settings, RunSettings run,
                    const std::vector<ProfileNumber>& numbers)
      : model_(model), settings_(settings), run_(std::move(run)), numbers_(numbers) {}

  [[nodiscard]] Result<SlopeTable> work(const std::function<void(const SlopeTable&)>& begin,
                                        const std::function<bool(const RowSlopes&)>& take) {
    auto analysis = model_.start(run_);
    if (!analysis) return tl::unexpected(analysis.error());
    columns_.emplace(*analysis, run_);
    SlopeTable table;
    for (const ProfileNumber& number : numbers_) table.numbers.push_back(number.number);
    choose_slots(table);
    if (auto error = object_to_columns(table)) return tl::unexpected(*std::move(error));
    if (auto error = make_models()) return tl::unexpected(*std::move(error));
    begin(table);
    Row row;
    while (!stopped() && analysis->next(row)) {
      if (!take_row(analysis->impl().run, row, take)) break;
    }
    table.good = analysis->good();
    table.stopped = stopped();
    return table;
  }

private:
  [[nodiscard]] bool stopped() const { return is_raised(run_.stop); }

  // Leaves out columns of words, and the residual, which is mere rounding.
  void choose_slots(SlopeTable& table) {
    for (std::size_t c = 0; c < columns_->columns().size(); ++c) {
      rounding_.push_back(rounding_of(*columns_, c));
      const Column& column = columns_->columns()[c];
      if (!column.words.empty() || column.name == "residual") continue;
      slots_.push_back(c);
      table.columns.push_back(column);
    }
  }

  // The objection to a name or glob of columns none of which has derivatives.
  [[nodiscard]] std::optional<Error> object_to_columns(const SlopeTable& table) const {
    for (const std::string& glob : run_.columns) {
      if (std::none_of(table.columns.begin(), table.columns.end(),
                       [&](const Column& column) { return matches(glob, column.name); })) {
        return Error{ErrorKind::kInput,
                     {about("setting columns " + glob,
                            "has no derivatives: columns of words have none, and the residual is rounding")}};
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Error> make_models() {
    auto models = models_by(model_, numbers_, natural_scales(*columns_));
    if (!models) return models.error();
    models_ = *std::move(models);
    std::vector<std::size_t> arcs;
    std::copy_if(slots_.begin(), slots_.end(), std::back_inserter(arcs),
                 [&](std::size_t slot) { return !has_exact_slope(columns_->columns()[slot]); });
    slopes_.resize(numbers_.size());
    differences_.resize(numbers_.size());
    in_parallel([&](std::size_t i) {
      slopes_[i] = std::make_unique<NumberSlopes>(*columns_, *models_[i]);
      const NumberSlopes::State state = slopes_[i]->state();
      const auto& columns = state == NumberSlopes::State::kOther ? slots_ : arcs;
      const bool needed = state == NumberSlopes::State::kOther || state == NumberSlopes::State::kExact;
      if (needed && !columns.empty()) {
        differences_[i] = std::make_unique<RowDifferences>(*models_[i], run_, columns, largest_);
      }
    });
    return find_largest();
  }

  // Of all rows, for differences. Values within rounding of the column's scale are none.
  [[nodiscard]] std::optional<Error> find_largest() {
    for (const double rounding : rounding_) largest_.push_back(rounding / kKinkRounding);
    if (std::none_of(differences_.begin(), differences_.end(),
                     [](const auto& one) { return one != nullptr; })) {
      return std::nullopt;
    }
    auto analysis = model_.start(run_);
    if (!analysis) return analysis.error();
    Row row;
    while (!stopped() && analysis->next(row)) {
      for (std::size_t c = 0; c < largest_.size(); ++c) {
        largest_[c] = std::fmax(largest_[c], std::abs(row.values[c]));
      }
    }
    return std::nullopt;
  }

  template <class F>
  void in_parallel(F f) const {
    for_each_on_threads(numbers_.size(), settings_.threads, [&](std::size_t i) {
      if (!stopped()) f(i);
    });
  }

  [[nodiscard]] bool take_row(const Run& run, const Row& row,
                              const std::function<bool(const RowSlopes&)>& take) {
    const PathPlace place = columns_->place_of_row(row.number);
    std::vector<double> values, slopes(numbers_.size() * slots_.size(), kNoValue);
    for (const std::size_t slot : slots_) values.push_back(row.values[slot]);
    const RatesAsked rates = rates_to_ask(*columns_, run, place);
    in_parallel([&](std::size_t i) {
      const std::vector<double> all = slopes_at(i, run, row, place, rates);
      for (std::size_t c = 0; c < slots_.size(); ++c) slopes[i * slots_.size() + c] = all[slots_[c]];
    });
    return !stopped() && take({row.number, values, slopes});
  }

  [[nodiscard]] std::vector<double> slopes_at(std::size_t i, const Run& run, const Row& row,
                                              const PathPlace& place, RatesAsked rates) {
    const std::size_t count = columns_->columns().size();
    const NumberSlopes::State state = slopes_[i]->state();
    std::vector<double> slopes(count, state == NumberSlopes::State::kNoInfluence ? 0.0 : kNoValue);
    if (state == NumberSlopes::State::kExact) {
      const auto sided = slopes_[i]->at(run, place, rates);
      for (std::size_t c = 0; sided && c < count; ++c) {
        slopes[c] = slope_of((*sided)[c], kNoSlopeOfRounding * rounding_[c] / models_[i]->scale());
      }
    }
    if (differences_[i]) differences_[i]->next(row, slopes);
    return slopes;
  }

  // None at a kink, unless both sides are rounding.
  [[nodiscard]] static double slope_of(const SidedSlope& sided, double rounding) {
    const bool none = sided.is_kink() && std::max(std::abs(sided.down), std::abs(sided.up)) > rounding;
    return none ? kNoValue : (sided.down + sided.up) / 2;
  }

  const Model& model_;
  const SensitivitySettings& settings_;
  RunSettings run_;
  const std::vector<ProfileNumber>& numbers_;
  std::vector<double> rounding_;  // of the columns of the run
  std::optional<PathColumns> columns_;
  std::vector<std::size_t> slots_;  // of the columns of the table
  std::vector<std::unique_ptr<NumberModels>> models_;
  std::vector<std::unique_ptr<NumberSlopes>> slopes_;
  std::vector<std::unique_ptr<RowDifferences>> differences_;  // of the numbers that need them
  std::vector<double> largest_;                               // of the columns of the run
};

}  // namespace

Result<SlopeTable> sensitivity_rows(const Model& model, const std::vector<std::string>& columns,
                                    const SensitivitySettings& settings,
                                    const std::function<void(const SlopeTable&)>& begin,
                                    const std::function<bool(const RowSlopes&)>& take) {
  const auto numbers = numbers_for(model, settings.by);
  if (!numbers) {
    return tl::unexpected(numbers.error());
  }
  RunSettings run = run_settings(settings, results_for(model, settings).in_time);
  run.columns = columns;
  if (!columns.empty()) {
    const Mechanism& mechanism = model.mechanism();
    if (!mechanism.drivers.empty()) {
      run.columns.push_back(run.in_time ? "time" : driver_name(mechanism.drivers.front()));
    }
  }
  return settings_for_columns(model, std::move(run)).and_then([&](const RunSettings& made) {
    return RowDifferentiator(model, settings, made, *numbers).work(begin, take);
  });
}

}  // namespace higherpair
