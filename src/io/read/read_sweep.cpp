// [sweep]: the variants and the results wanted of each.
#include "higherpair/io/tasks.hpp"
#include "higherpair/numeric/contains.hpp"
#include "read_measure.hpp"
#include "reading.hpp"
#include "sweep_reading.hpp"

#include <array>
#include <utility>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

constexpr std::array kTakenNames = {"variant", "status", "cause", "row", "time"};

std::optional<SweepMethod> read_method(TableReader& table) {
  const auto choice = table.need("method", "one of grid, list, random, sobol", as_choice,
                                 {"grid", "list", "random", "sobol"});
  return choice ? std::optional(static_cast<SweepMethod>(*choice)) : std::nullopt;
}

void read_results_of(TableReader& table, const Mechanism& mechanism, SweepTask& task) {
  read_results(table, unit_of_place(mechanism, task.in_time),
               [&](const std::string& name, const std::optional<Measure>& measure, TableReader& entry) {
                 SweepResult result;
                 result.name = name;
                 result.where = entry.flag("where", false);
                 const bool has_place =
                     !measure || (measure->of != MeasureKind::kRange && measure->of != MeasureKind::kMean &&
                                  measure->of != MeasureKind::kRms);
                 if (result.where && !has_place) {
                   entry.refuse("where", fmt::format("\"{}\" is of all rows and has no position",
                                                     name_of(measure->of)));
                 }
                 result.measure = measure.value_or(Measure());
                 task.results.push_back(std::move(result));
               });
}

void read_rows(TableReader& table, SweepTask& task) {
  const auto item = table.take("rows");
  if (!item) {
    return;
  }
  const auto items =
      as_items(table.reading(), *item, "a list of columns, names or globs, such as [\"follower.*\"]");
  for (const Item& one : items.value_or(std::vector<Item>{})) {
    task.rows.push_back(as_text(table.reading(), one).value_or("*"));
  }
}

void read_what(TableReader& table, const Mechanism& mechanism, SweepTask& task) {
  task.in_time = table.flag("time", false);
  task.counts = table.flag("counts", false);
  read_results_of(table, mechanism, task);
  read_rows(table, task);
  constexpr const char* kEither =
      "where `rows` are written there is no row of results: leave one of the two out";
  if (!task.rows.empty() && !task.results.empty()) {
    table.refuse("results", kEither);
  }
  if (!task.rows.empty() && task.counts) {
    table.refuse("counts", kEither);
  }
}

// Every name that becomes a column must be unique.
void check_names(TableReader& table, const SweepTask& task) {
  std::vector<std::string> names(kTakenNames.begin(), kTakenNames.end());
  const auto check = [&](const std::string& part, const std::string& name) {
    if (contains(names, name)) {
      table.reading().mistakes.push_back(
          {table.mark(),
           fmt::format("{}.{}.{}: there is another column `{}` in the table; choose another name",
                       table.path(), part, name, name)});
    }
    names.push_back(name);
  };
  for (const SweepVariable& variable : task.plan.variables) check("variables", variable.name);
  for (const SweepResult& result : task.results) check("results", result.name);
}

void check_size(TableReader& table, const VariantPlan& plan) {
  const double count = count_of(plan);
  if (plan.method == SweepMethod::kGrid && count > static_cast<double>(kMostVariants)) {
    table.reading().mistakes.push_back(
        {table.mark(),
         fmt::format(
             "{}: this grid has {:.15g} variants, and at most {} are possible: give the variables fewer "
             "values, or let method = \"sobol\" with a `count` fill the same space evenly",
             table.path(), count, kMostVariants)});
  }
}

}  // namespace

void read_results(TableReader& task, const NumberUnit& place,
                  const std::function<void(const std::string& name, const std::optional<Measure>& measure,
                                           TableReader& table)>& finish) {
  for_each_table(task.reading(), task.take("results"), "a measure (a table)",
                 [&](const std::string& name, TableReader& table) {
                   finish(name, read_measure(table, place), table);
                   table.finish();
                 });
}

void read_sweep(TableReader& root, const Table& document, Profile& profile) {
  profile.sweep = read_task<SweepTask>(root, "sweep", [&](const Item&, TableReader& table, SweepTask& task) {
    const Mistakes mistakes(table.reading());
    const auto method = read_method(table);
    const bool draws = method == SweepMethod::kRandom || method == SweepMethod::kSobol;
    task.plan.method = method.value_or(SweepMethod::kGrid);
    if (draws) {
      task.plan.count =
          table.need("count", "how many variants are drawn", as_count, {1, kMostVariants}).value_or(1);
      task.plan.seed = table.take("seed", as_seed).value_or(1);
    } else if (method) {
      table.refuse("count", "only random and sobol have one; a variable of a grid has its own `count`");
      table.refuse("seed", "only random and sobol have one");
      table.refuse("correlations", "only draws (random, sobol) can be correlated");
    } else {
      table.knows({"count", "seed"});
    }
    read_sweep_variables(table, document, method, task);
    if (draws || !method) {
      read_correlations(table,
                        {"variable", "variables with `normal`, without `min` and `max`,", "sweep.variables"},
                        task.plan);
    }
    read_what(table, profile.mechanism, task);
    table.finish();
    check_names(table, task);
    if (mistakes.none()) {
      check_size(table, task.plan);
    }
  });
}

}  // namespace higherpair::io_detail
