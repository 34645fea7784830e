#include "read_design.hpp"

#include "higherpair/io/design_task.hpp"
#include "number_unit.hpp"
#include "reading.hpp"

#include <memory>
#include <utility>

namespace higherpair::io_detail {
namespace {

void read_options(TableReader& table, DesignTask& task) {
  if (const auto method = table.take("method")) {
    if (const auto choice = as_choice(table.reading(), *method, design_method_names())) {
      task.method = static_cast<DesignMethod>(*choice);
    }
  }
  task.keep_branch = table.flag("keep_branch", false);
  if (const auto starts = table.take("starts", as_count, {1})) task.starts = static_cast<int>(*starts);
  task.seed = table.take("seed", as_seed);
  task.target = table.take("target", as_number_in, no_unit());
}

DesignTask read_task(TableReader& table, const Table& document, LawBook& laws, Profile& profile) {
  Reading& reading = table.reading();
  DesignTask task;
  task.place = place_of(reading, table.mark());
  if (const auto variables = table.need("variables", "the numbers that may be chosen, one table each")) {
    for_each_table(reading, *variables, "a variable (a table)",
                   [&](const std::string& name, TableReader& variable) {
                     read_variable(name, variable, document, task.variables);
                   });
    if (task.variables.empty() && reading.mistakes.empty()) {
      report(reading, *variables, "expected at least one variable, NAME = { path = …, min = …, max = … }");
    }
  }
  for_each_in_list(table, "objectives", [&](TableReader& item) {
    if (auto objective = read_objective(item, profile, laws))
      task.objectives.push_back(*std::move(objective));
  });
  for_each_in_list(table, "constraints", [&](TableReader& item) {
    if (auto constraint = read_constraint(item, profile)) task.constraints.push_back(*std::move(constraint));
  });
  read_options(table, task);
  table.finish();
  return task;
}

}  // namespace

void read_design(TableReader& root, const Table& document, LawBook& laws, Profile& profile) {
  if (auto table = as_reader(root.reading(), root.take("design"), "a design task (a table)")) {
    profile.design = std::make_shared<const DesignTask>(read_task(*table, document, laws, profile));
  }
}

}  // namespace higherpair::io_detail
