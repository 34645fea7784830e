#pragma once

#include "higherpair/io/tasks.hpp"
#include "io/document/table_reader.hpp"
#include "number_unit.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace higherpair::io_detail {

/// The paths set by the variables of a task, and the document in which they are looked up.
struct SweepPaths {
  const Table& document;
  std::vector<std::string> taken;
  std::string task = "sweep";           ///< the task's own table, whose numbers cannot be varied
  std::vector<Mistake> with_unit = {};  ///< a note for each path whose number has a unit of its own
};

/// Reads `path` of a variable: one or several, each of a number in the document that no other variable sets.
void read_paths(TableReader& table, SweepPaths& paths, SweepVariable& variable);

/// Reads the values or the distribution of a variable.
/// \param item  the variable's table
void read_distribution(TableReader& table, const Item& item, std::optional<SweepMethod> method,
                       const NumberUnit& unit, SweepVariable& variable);

/// Reads `variables` of a sweep: their paths, which must exist in the document, and their values. If the
/// method is unknown, only what does not depend on it is checked.
void read_sweep_variables(TableReader& sweep, const Table& document, std::optional<SweepMethod> method,
                          SweepTask& task);

/// The words used in messages about the quantities that scatter.
struct CorrelationWords {
  std::string one;       ///< which of them can be correlated
  std::string possible;  ///< those that can be correlated
  std::string home;      ///< path of the table that they are in
};

/// Reads `correlations` of a task: only variables that are normally distributed and not truncated can be
/// correlated.
void read_correlations(TableReader& task, const CorrelationWords& words, VariantPlan& plan);

/// Reads `results`: named measures.
/// \param place  the unit of `at` of a measure
/// \param finish  reads the other keys of a measure's table and takes the measure, which is none if it is
/// wrong
void read_results(TableReader& task, const NumberUnit& place,
                  const std::function<void(const std::string& name, const std::optional<Measure>& measure,
                                           TableReader& table)>& finish);

/// Reads a task that has a table of its own in the profile.
/// \param read  reads the keys of the table; `item` is the table as an item
/// \return none if there is no such table or it has a mistake, which is reported
template <class Task>
std::shared_ptr<const Task> read_task(
    TableReader& root, const std::string& key,
    const std::function<void(const Item& item, TableReader& table, Task& task)>& read) {
  Reading& reading = root.reading();
  const Mistakes mistakes(reading);
  const auto item = root.take(key);
  auto table = as_reader(reading, item, "a table");
  if (!table) {
    return nullptr;
  }
  Task task;
  task.place = place_of(reading, table->mark());
  read(*item, *table, task);
  return mistakes.none() ? std::make_shared<const Task>(std::move(task)) : nullptr;
}

}  // namespace higherpair::io_detail
