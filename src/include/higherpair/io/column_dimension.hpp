#pragma once

#include "higherpair/io/units.hpp"
#include "higherpair/mechanism/description.hpp"

#include <optional>
#include <string_view>

namespace higherpair {

/// The dimension of a column of a table, by its name; of a glob if all that it can stand for has the same.
/// None if no such column has numbers with one. Whether the run has the column is not looked at. The jerk of
/// a contact is that of the joint on which it moves a body, which the plan of the mechanism knows.
/// \pre all that the mechanism names is there
[[nodiscard]] std::optional<Dimension> column_dimension(const Mechanism& mechanism, std::string_view column);

/// The dimension of a figure of check(), by its item and the name of its quantity: "contacts.touch",
/// "contact_pressure". None if there is no such quantity.
[[nodiscard]] std::optional<Dimension> figure_dimension(const Mechanism& mechanism, std::string_view item,
                                                        std::string_view quantity);

}  // namespace higherpair
