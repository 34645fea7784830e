#pragma once

#include "design_row_reader.hpp"

#include <span>

namespace higherpair {

/// Number of parts into which the path between two positions of the drivers is divided to check whether the
/// dyads can be closed there.
[[nodiscard]] int closure_parts(const DesignSetup& setup, std::span<const double> from,
                                std::span<const double> to);

/// Computes the rows of a mechanism of drivers and dyads: positions in closed form, no rates. \param
/// mechanism  becomes rows.mechanism
void place_rows(const DesignSetup& setup, std::unique_ptr<const Mechanism> mechanism, const Plan& plan,
                int branch, DesignRows& rows);

}  // namespace higherpair
