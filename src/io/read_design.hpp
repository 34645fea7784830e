#pragma once

#include "higherpair/io/design_task.hpp"
#include "higherpair/io/tasks.hpp"
#include "laws.hpp"
#include "reading.hpp"

#include <optional>

namespace higherpair::io_detail {

/// A table of [design.variables], added to the others.
void read_variable(const std::string& name, TableReader& table, const Table& document,
                   std::vector<DesignTask::Variable>& variables);

/// An entry of [[design.objectives]] or [[design.constraints]]; none where it is wrong.
[[nodiscard]] std::optional<DesignTask::Objective> read_objective(TableReader& table, Profile& profile,
                                                                  LawBook& laws);
[[nodiscard]] std::optional<DesignTask::Constraint> read_constraint(TableReader& table,
                                                                    const Profile& profile);

/// The table `path` of an objective; none where it is wrong.
[[nodiscard]] std::optional<DesignTask::PointPath> read_point_path(TableReader& table,
                                                                   const Mechanism& mechanism);

/// "body.point"; none where there is no such point, which is reported.
[[nodiscard]] std::optional<PointRef> find_point(Reading& reading, const Item& item,
                                                 const Mechanism& mechanism);

/// Whether an objective or constraint has `reach` or `size`.
[[nodiscard]] bool is_extent(TableReader& table);
/// That; none where it is wrong. \pre is_extent
[[nodiscard]] std::optional<DesignTask::Extent> read_extent(TableReader& table, const Mechanism& mechanism);

/// A number without a unit of its own: it is in the unit of something that is not known here.
[[nodiscard]] std::optional<double> as_plain_number(Reading& reading, const Item& item);
/// The same at a key that may be absent.
[[nodiscard]] std::optional<double> optional_plain_number(TableReader& table, const std::string& key);

/// [fit], where there is one.
std::optional<FitTask> read_fit(TableReader& root, const Mechanism& mechanism);

}  // namespace higherpair::io_detail
