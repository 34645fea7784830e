#pragma once

#include "chain_variants.hpp"
#include "higherpair/analysis/status.hpp"
#include "higherpair/front/sweep.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair {

/// Status of a variant, or of one of its rows: a RowStatus, or this one.
inline constexpr int kNotStarted = 6;
inline constexpr int kSweepStatusCount = 7;

inline constexpr std::size_t kEventTypeCount = static_cast<std::size_t>(EventType::kLawJump) + 1;

/// The names of all statuses, for a column of words.
[[nodiscard]] std::span<const std::string_view> sweep_statuses();

/// A sweep, ready to be run.
struct Sweep::Data {
  Model model;
  SweepTask task;
  Variants variants;
  std::vector<std::string> paths;      ///< of all variables, one after the other
  std::vector<Measure> measures;       ///< of the task's results
  RunSettings run;                     ///< for every variant
  std::vector<Column> run_columns;     ///< of a variant's run
  std::vector<std::size_t> row_slots;  ///< of these, the ones that are written where rows are
  std::vector<Column> columns;         ///< of the table
  std::int64_t begin = 0;              ///< first variant of this part
  std::int64_t end = 0;                ///< one past the last
  std::int64_t block_variants = 1;
  SweepForecast forecast;
  std::optional<ChainRecipe> chain;  ///< where most variants need not be read and run

  [[nodiscard]] bool writes_rows() const { return !task.rows.empty(); }
};

/// The place of a task in the profile; the model as a whole for one that a program made.
[[nodiscard]] Place place_of(const SweepTask& task, const Model& model);

/// Sets up the run of every variant and the columns of the table. Fails for names that do not exist.
[[nodiscard]] Result<Sweep::Data> sweep_table(const Model& model, const SweepSettings& settings);

}  // namespace higherpair
