#include "higherpair/front/sweep.hpp"

#include "front/analysis_impl.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "higherpair/numeric/stop.hpp"
#include "sweep_data.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

// Number of variants that are read before a sweep is run, and the time after which no more are read.
constexpr std::int64_t kTried = 1000;
constexpr std::chrono::seconds kTrying{2};

// Severity of each RowStatus, in its order, and of `not_started`.
constexpr std::array<int, kSweepStatusCount> kSeverity = {0, 5, 1, 3, 4, 2, 6};

std::string text_of(const Event& event) {
  return fmt::format("{} at driver = {}: {}", name_of(event.type), event.driver, event.cause);
}

std::int64_t cut(std::int64_t size, std::int64_t part, std::int64_t parts) {
  // part size/parts without overflow
  return size / parts * part + size % parts * part / parts;
}

// Computes one variant after the other; each block has a worker of its own.
class Worker {
public:
  explicit Worker(const Sweep::Data& data)
      : data_(data),
        models_(ModelVariants::of(data.model, data.paths).value()),
        variables_(data.task.plan.variables.size()),
        numbers_(data.paths.size()) {
    if (!data.writes_rows()) measures_.emplace(data.measures, data.run_columns);
    if (data.chain) chain_ = ChainVariants::of(*data.chain);
  }

  /// The values of all paths in a variant.
  [[nodiscard]] const std::vector<double>& numbers(std::int64_t variant) {
    data_.variants.values(variant, variables_);
    std::size_t next = 0;
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      for (std::size_t k = 0; k < data_.task.plan.variables[i].paths.size(); ++k) {
        numbers_[next++] = variables_[i];
      }
    }
    return numbers_;
  }

  [[nodiscard]] Result<Model> model(std::int64_t variant) { return models_.with(numbers(variant)); }
  [[nodiscard]] ModelVariants& models() { return models_; }

  /// Appends the rows of a variant to the block; false if the run was stopped.
  [[nodiscard]] bool add(std::int64_t variant, SweepBlock& block) {
    variant_ = variant;
    const bool writes = chain_ && data_.chain->writes();
    if (writes && chain_->solve(numbers(variant))) {
      add_proven(block);
      return goes_on();
    }
    const Result<Model> made = model(variant);
    if (made && chain_ && !writes && chain_->solve(*made)) {
      add_proven(block);
      return goes_on();
    }
    auto analysis = made ? made->start(data_.run) : Result<Analysis>(tl::unexpected(made.error()));
    if (!analysis) {
      add_not_started(analysis.error().diagnostics.front().message, block);
      return goes_on();
    }
    if (data_.writes_rows()) {
      add_rows(*analysis, block);
    } else {
      add_results(*analysis, block);
    }
    block.good += analysis->good() ? 1 : 0;
    return !analysis->stopped();
  }

private:
  [[nodiscard]] bool goes_on() const { return !is_raised(data_.run.stop); }

  void begin_row(SweepBlock& block) const {
    block.values.push_back(static_cast<double>(variant_));
    block.values.insert(block.values.end(), variables_.begin(), variables_.end());
  }

  void end_row(int status, std::string cause, SweepBlock& block) const {
    block.values.push_back(status);
    block.causes.push_back(std::move(cause));
  }

  void add_not_started(std::string cause, SweepBlock& block) const {
    begin_row(block);
    const std::size_t empty = data_.columns.size() - variables_.size() - 2;
    block.values.insert(block.values.end(), empty, kNoValue);
    end_row(kNotStarted, std::move(cause), block);
  }

  void add_rows(Analysis& analysis, SweepBlock& block) {
    const std::size_t first = block.causes.size();
    while (analysis.next(row_)) {
      begin_row(block);
      for (const std::size_t slot : data_.row_slots) {
        block.values.push_back(row_.values[slot]);
      }
      end_row(static_cast<int>(row_.status), "", block);
    }
    for (const Event& event : analysis.events()) {
      const std::size_t row = first + static_cast<std::size_t>(event.row);
      if (!analysis.good() && ends_path(event.type) && row < block.causes.size() &&
          block.causes[row].empty()) {
        block.causes[row] = text_of(event);
      }
    }
  }

  void add_results(Analysis& analysis, SweepBlock& block) {
    measures_->clear();
    std::array<std::int64_t, kNotStarted> counts{};
    RowStatus worst = RowStatus::kOk;
    double worst_at = kNoValue;
    while (analysis.next(row_)) {
      measures_->add(row_);
      const auto status = static_cast<std::size_t>(row_.status);
      ++counts[status];
      if (kSeverity[status] > kSeverity[static_cast<std::size_t>(worst)]) {
        worst = row_.status;
        worst_at = row_.values[measures_->where_slot()];
      }
    }
    begin_row(block);
    put_results(block, [&](std::size_t i) { return measures_->value(i); });
    if (data_.task.counts) {
      put_counts(counts, analysis.events(), block);
    }
    end_row(static_cast<int>(worst), analysis.good() ? "" : cause_of(analysis, worst, worst_at), block);
  }

  // Adds a variant that is known to be good.
  void add_proven(SweepBlock& block) {
    begin_row(block);
    put_results(block, [&](std::size_t i) { return chain_->value(i, data_.task.results[i].where); });
    end_row(static_cast<int>(RowStatus::kOk), "", block);
    ++block.good;
  }

  template <class Value>
  void put_results(SweepBlock& block, const Value& value) const {
    for (std::size_t i = 0; i < data_.task.results.size(); ++i) {
      const Measured measured = value(i);
      block.values.push_back(std::isfinite(measured.value) ? measured.value : kNoValue);
      if (data_.task.results[i].where) block.values.push_back(measured.where);
    }
  }

  static void put_counts(std::span<const std::int64_t> rows, const std::vector<Event>& events,
                         SweepBlock& block) {
    for (const std::int64_t count : rows) {
      block.values.push_back(static_cast<double>(count));
    }
    const std::size_t first = block.values.size();
    block.values.resize(first + kEventTypeCount, 0.0);
    for (const Event& event : events) {
      block.values[first + static_cast<std::size_t>(event.type)] += 1;
    }
  }

  [[nodiscard]] std::string cause_of(const Analysis& analysis, RowStatus worst, double worst_at) const {
    const auto event = std::find_if(analysis.events().begin(), analysis.events().end(),
                                    [](const Event& one) { return ends_path(one.type); });
    if (event != analysis.events().end()) {
      return text_of(*event);
    }
    return fmt::format("{} at {} = {}", name_of(worst), data_.task.in_time ? "time" : "driver", worst_at);
  }

  const Sweep::Data& data_;
  ModelVariants models_;
  std::optional<MeasureSet> measures_;  // where results are written
  std::optional<ChainVariants> chain_;  // where there is a recipe
  std::vector<double> variables_;
  std::vector<double> numbers_;  // the same, one for each path
  Row row_;
  std::int64_t variant_ = 0;
};

SweepForecast forecast_of(const Sweep::Data& data) {
  SweepForecast forecast;
  Worker worker(data);
  const std::int64_t size = data.end - data.begin;
  const std::int64_t wanted = std::min(size, kTried);
  const auto start = std::chrono::steady_clock::now();
  for (; forecast.tried < wanted && std::chrono::steady_clock::now() - start < kTrying; ++forecast.tried) {
    const std::int64_t variant = data.begin + cut(size, forecast.tried, wanted);
    const auto model = worker.model(variant);
    if (!model && ++forecast.unreadable == 1) {
      forecast.variant = variant;
      forecast.cause = model.error().diagnostics.front().message;
    }
  }
  return forecast;
}

// None where rows or counts are written: a chain does not give events, nor the single rows.
std::optional<ChainRecipe> chain_of(const Sweep::Data& data) {
  constexpr std::int64_t kTries = 5;
  if (data.writes_rows() || data.task.counts) {
    return std::nullopt;
  }
  // Tries from the whole sweep, so that all its parts are computed in the same way.
  Worker worker(data);
  const std::int64_t size = data.variants.size();
  std::vector<std::vector<double>> tries;
  const std::int64_t wanted = std::min(size, kTries);
  for (std::int64_t k = 0; k < wanted; ++k) {
    tries.push_back(worker.numbers(cut(size, k, wanted)));
  }
  return ChainRecipe::of(data.model, data.paths, data.run, data.measures, worker.models(), tries);
}

// What is wrong with a task that a program made; that of a profile was checked by its reader.
std::string fault_of(const SweepTask& task) {
  const VariantPlan& plan = task.plan;
  if (std::string fault = higherpair::fault_of(plan); !fault.empty()) {
    return fault;
  }
  const auto no_path = std::find_if(plan.variables.begin(), plan.variables.end(),
                                    [](const SweepVariable& variable) { return variable.paths.empty(); });
  if (no_path != plan.variables.end()) {
    return fmt::format("variables.{}: expected at least one path", no_path->name);
  }
  return task.units.size() == plan.variables.size()
             ? ""
             : fmt::format("units: {} for {} variables: each needs its own", task.units.size(),
                           plan.variables.size());
}

Result<void> check(const Model& model, const SweepSettings& settings) {
  if (!settings.task && !model.profile().sweep) {
    return wrong(model, "there is no [sweep]: it says which variants there are, and what is wanted of each");
  }
  if (std::string fault = settings.task ? fault_of(*settings.task) : ""; !fault.empty()) {
    return wrong(place_of(*settings.task, model), "sweep." + fault);
  }
  if (settings.parts < 1 || settings.part < 1 || settings.part > settings.parts) {
    return wrong(model,
                 fmt::format("part {} of {}: parts are counted from 1", settings.part, settings.parts));
  }
  return {};
}

}  // namespace

Result<Sweep> Sweep::of(const Model& model, const SweepSettings& settings) {
  if (const auto good = check(model, settings); !good) {
    return tl::unexpected(good.error());
  }
  auto data = sweep_table(model, settings);
  if (!data) {
    return tl::unexpected(std::move(data.error()));
  }
  if (const auto models = ModelVariants::of(model, data->paths); !models) {
    return tl::unexpected(models.error());
  }
  data->begin = cut(data->variants.size(), settings.part - 1, settings.parts);
  data->end = cut(data->variants.size(), settings.part, settings.parts);
  data->forecast = forecast_of(*data);
  const SweepForecast& forecast = data->forecast;
  if (forecast.tried > 0 && forecast.unreadable == forecast.tried) {
    return wrong(place_of(data->task, model),
                 fmt::format("sweep: not one variant of {} that were tried can be read; variant {}: {}",
                             forecast.tried, forecast.variant, forecast.cause));
  }
  data->chain = chain_of(*data);
  return Sweep(std::make_shared<const Data>(*std::move(data)));
}

std::int64_t Sweep::size() const {
  return data_->end - data_->begin;
}

std::int64_t Sweep::first() const {
  return data_->begin;
}

std::int64_t Sweep::blocks() const {
  return (size() + data_->block_variants - 1) / data_->block_variants;
}

std::int64_t Sweep::variants_of(std::int64_t block) const {
  return block >= 0 && block < blocks()
             ? std::min(data_->block_variants, size() - block * data_->block_variants)
             : 0;
}

const std::vector<Column>& Sweep::columns() const {
  return data_->columns;
}

std::size_t Sweep::first_result() const {
  return 1 + data_->task.plan.variables.size();
}

std::size_t Sweep::result_count() const {
  return data_->writes_rows() ? 0 : columns().size() - first_result() - 1;
}

const SweepForecast& Sweep::forecast() const {
  return data_->forecast;
}

SweepBlock Sweep::block(std::int64_t number) const {
  SweepBlock block;
  block.number = number;
  const std::int64_t variants = variants_of(number);
  if (variants == 0) {
    return block;
  }
  Worker worker(*data_);
  const std::int64_t first = data_->begin + number * data_->block_variants;
  for (std::int64_t k = 0; k < variants; ++k) {
    if (!worker.add(first + k, block)) {
      block.complete = false;
      break;
    }
    ++block.variants;
  }
  return block;
}

}  // namespace higherpair
