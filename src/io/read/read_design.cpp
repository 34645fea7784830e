#include "read_design.hpp"

#include "higherpair/io/design_task.hpp"
#include "number_unit.hpp"
#include "reading.hpp"

#include <cstdint>
#include <memory>
#include <utility>

namespace higherpair::io_detail {
namespace {

class DesignReader {
public:
  DesignReader(Reading& reading, const Table& document, Profile& profile, LawBook& laws)
      : reading_(reading), document_(document), profile_(profile), laws_(laws) {}

  DesignTask read(TableReader& table) {
    task_.place = place_of(reading_, table.mark());
    if (const auto variables = table.need("variables", "the numbers that may be chosen, one table each")) {
      for_each_table(reading_, *variables, "a variable (a table)",
                     [&](const std::string& name, TableReader& variable) {
                       read_variable(name, variable, document_, task_.variables);
                     });
      if (task_.variables.empty() && reading_.mistakes.empty()) {
        report(reading_, *variables, "expected at least one variable, NAME = { path = …, min = …, max = … }");
      }
    }
    for_each_in_list(table, "objectives", [&](TableReader& item) {
      if (auto objective = read_objective(item, profile_, laws_))
        task_.objectives.push_back(*std::move(objective));
    });
    for_each_in_list(table, "constraints", [&](TableReader& item) {
      if (auto constraint = read_constraint(item, profile_))
        task_.constraints.push_back(*std::move(constraint));
    });
    read_options(table);
    table.finish();
    return std::move(task_);
  }

private:
  void read_options(TableReader& table) {
    if (const auto method = table.take("method")) {
      if (const auto choice = as_choice(reading_, *method, design_method_names())) {
        task_.method = static_cast<DesignMethod>(*choice);
      }
    }
    task_.keep_branch = table.flag("keep_branch", false);
    if (const auto starts = table.take("starts", as_count, {1})) task_.starts = static_cast<int>(*starts);
    task_.seed = table.take("seed", as_seed);
    task_.target = table.take("target", as_number_in, no_unit());
  }

  Reading& reading_;
  const Table& document_;
  Profile& profile_;
  LawBook& laws_;
  DesignTask task_;
};

}  // namespace

void read_design(TableReader& root, const Table& document, LawBook& laws, Profile& profile) {
  if (auto table = as_reader(root.reading(), root.take("design"), "a design task (a table)")) {
    DesignReader reader(root.reading(), document, profile, laws);
    profile.design = std::make_shared<const DesignTask>(reader.read(*table));
  }
}

}  // namespace higherpair::io_detail
