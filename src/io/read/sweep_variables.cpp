#include "sweep_reading.hpp"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

// Checks that all lists have the same length; missing values are reported elsewhere.
void check_lists(Reading& reading, const Item& item, const std::vector<SweepVariable>& variables) {
  const SweepVariable* first = nullptr;
  for (const SweepVariable& variable : variables) {
    const std::size_t count = variable.distribution.values.size();
    if (count > 0 && first == nullptr) first = &variable;
    if (count > 0 && count != first->distribution.values.size()) {
      reading.mistakes.push_back(
          {item.value->mark,
           fmt::format("{}.{}.values: {} values, but {} has {}; in a list all variables have equally many",
                       path_of(reading, item), variable.name, count, first->name,
                       first->distribution.values.size())});
    }
  }
}

// Whether a value of a variable, the table, has no unit of its own.
bool has_plain_values(const Value& variable) {
  const auto is_number = [](const Value& value) { return number_in(value).has_value(); };
  bool any = false;
  for (const char* key : {"values", "normal", "triangular", "uniform", "min", "max"}) {
    const Value* value = find(std::get<Table>(variable.content), key);
    const auto* items = value == nullptr ? nullptr : std::get_if<Array>(&value->content);
    any = any || (value != nullptr && is_number(*value)) ||
          (items != nullptr && std::any_of(items->begin(), items->end(), is_number));
  }
  return any;
}

// The unit at the first path of a variable; its other paths may have other units.
std::string unit_of(const Reading& reading, const SweepVariable& variable) {
  const auto dimension =
      variable.paths.empty() ? std::nullopt : varied_dimension(reading, variable.paths.front());
  return dimension ? unit_text(*dimension, reading.units) : "1";
}

}  // namespace

void read_sweep_variables(TableReader& sweep, const Table& document, std::optional<SweepMethod> method,
                          SweepTask& task) {
  SweepPaths paths{document, {}};
  std::vector<Mistake>& notes = sweep.reading().notes;
  const auto item = sweep.need("variables", "the variables (tables), each with `path` and its values");
  if (!item) {
    return;
  }
  for_each_table(sweep.reading(), *item, "a variable (a table)",
                 [&](const std::string& name, TableReader& table) {
                   SweepVariable variable;
                   variable.name = name;
                   read_paths(table, paths, variable);
                   task.units.push_back(unit_of(sweep.reading(), variable));
                   const Value* value = find(std::get<Table>(item->value->content), name);
                   const NumberUnit unit = unit_of_paths(sweep.reading(), variable.paths);
                   read_distribution(table, {value}, method, unit, variable);
                   if (has_plain_values(*value)) {
                     notes.insert(notes.end(), paths.with_unit.begin(), paths.with_unit.end());
                   }
                   paths.with_unit.clear();
                   table.finish();
                   task.plan.variables.push_back(std::move(variable));
                 });
  if (task.plan.variables.empty()) {
    report(sweep.reading(), *item, "expected at least one variable");
  } else if (method == SweepMethod::kList) {
    check_lists(sweep.reading(), *item, task.plan.variables);
  } else if (method == SweepMethod::kSobol && task.plan.variables.size() > kMostSobolVariables) {
    report(sweep.reading(), *item,
           fmt::format("a Sobol sequence has at most {} variables; method = \"random\" has no limit",
                       kMostSobolVariables));
  }
}

}  // namespace higherpair::io_detail
