#pragma once

#include "higherpair/io/tasks.hpp"
#include "table_reader.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace higherpair::io_detail {

/// The paths that the variables of a task set, and where they are looked for.
struct SweepPaths {
  const Table& document;
  std::vector<std::string> taken;
  std::string task = "sweep";  ///< the table that has them, whose own numbers are none
};

/// `path` of a variable: one or several, each of a number in the document that no other variable sets.
void read_paths(TableReader& table, SweepPaths& paths, SweepVariable& variable);

/// What values a variable takes; `item` is its table.
void read_distribution(TableReader& table, const Item& item, std::optional<SweepMethod> method,
                       SweepVariable& variable);

/// `variables` of a sweep: their paths, which have to exist in the document, and their values. Where the
/// method is not known, only what does not depend on it is checked.
void read_sweep_variables(TableReader& sweep, const Table& document, std::optional<SweepMethod> method,
                          SweepTask& task);

/// How messages call what scatters.
struct CorrelationWords {
  std::string one;       ///< "variable"
  std::string possible;  ///< those that can be correlated
};

/// `correlations` of a task: between those of the plan's variables that are normal and not cut off.
void read_correlations(TableReader& task, const CorrelationWords& words, VariantPlan& plan);

/// `results`: named measures. \param finish  takes what else is in the table of one, and the measure where it
/// is right
void read_results(TableReader& task,
                  const std::function<void(const std::string& name, const std::optional<Measure>& measure,
                                           TableReader& table)>& finish);

/// A task of the profile in a table of its own. \param read  the keys of the table, which is the item \return
/// none where there is no such table, or something in it is wrong, which is reported
template <class Task>
std::shared_ptr<const Task> read_task(
    TableReader& root, const std::string& key,
    const std::function<void(const Item& item, TableReader& table, Task& task)>& read) {
  Reading& reading = root.reading();
  const std::size_t mistakes = reading.mistakes.size();
  const auto item = root.take(key);
  auto table = as_reader(reading, item, "a table");
  if (!table) {
    return nullptr;
  }
  Task task;
  task.place = place_of(reading, table->mark());
  read(*item, *table, task);
  return reading.mistakes.size() == mistakes ? std::make_shared<const Task>(std::move(task)) : nullptr;
}

}  // namespace higherpair::io_detail
