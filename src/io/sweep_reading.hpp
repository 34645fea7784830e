#pragma once

#include "higherpair/io/sweep_task.hpp"
#include "table_reader.hpp"

#include <optional>
#include <string>
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

/// `correlations`: of normal variables.
void read_correlations(TableReader& sweep, std::optional<SweepMethod> method, VariantPlan& plan);

}  // namespace higherpair::io_detail
