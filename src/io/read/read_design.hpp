#pragma once

#include "higherpair/io/design_task.hpp"
#include "higherpair/io/tasks.hpp"
#include "laws.hpp"
#include "reading.hpp"

#include <optional>

namespace higherpair::io_detail {

/// Reads a table of [design.variables] and adds it to `variables`.
void read_variable(const std::string& name, TableReader& table, const Table& document,
                   std::vector<DesignTask::Variable>& variables);

/// Reads an entry of [[design.objectives]] or [[design.constraints]]; none if it has a mistake.
[[nodiscard]] std::optional<DesignTask::Objective> read_objective(TableReader& table, Profile& profile,
                                                                  LawBook& laws);
[[nodiscard]] std::optional<DesignTask::Constraint> read_constraint(TableReader& table,
                                                                    const Profile& profile);

/// Reads the table `path` of an objective; none if it has a mistake.
[[nodiscard]] std::optional<DesignTask::PointPath> read_point_path(TableReader& table,
                                                                   const Mechanism& mechanism);

/// What may be chosen of the placement of a path, or is not known of it: its key `free`.
struct FreePlacement {
  bool position = false, turn = false, scale = false;
};
[[nodiscard]] FreePlacement read_free(Reading& reading, const Item& free);

/// Whether an objective or constraint has the key `reach` or `size`.
[[nodiscard]] bool is_extent(const TableReader& table);
/// Reads it; none if it has a mistake. \pre is_extent
[[nodiscard]] std::optional<DesignTask::Extent> read_extent(TableReader& table, const Mechanism& mechanism);

/// Reads [fit].
void read_fit(TableReader& root, Profile& profile);

}  // namespace higherpair::io_detail
