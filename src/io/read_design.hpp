#pragma once

#include "higherpair/io/design_task.hpp"
#include "higherpair/io/fit_task.hpp"
#include "reading.hpp"

#include <optional>

namespace higherpair::io_detail {

/// An entry of [[design.objectives]] or [[design.constraints]]; none where it is wrong.
[[nodiscard]] std::optional<DesignTask::Objective> read_objective(TableReader& table, const Profile& profile);
[[nodiscard]] std::optional<DesignTask::Constraint> read_constraint(TableReader& table,
                                                                    const Profile& profile);

/// A number without a unit of its own: it is in the unit of something that is not known here.
[[nodiscard]] std::optional<double> as_plain_number(Reading& reading, const Item& item);
/// The same at a key that may be absent.
[[nodiscard]] std::optional<double> optional_plain_number(TableReader& table, const std::string& key);

/// [fit], where there is one.
std::optional<FitTask> read_fit(TableReader& root, const Mechanism& mechanism);

}  // namespace higherpair::io_detail
