#pragma once

#include "design_row_reader.hpp"

#include <span>

namespace higherpair {

/// Between two positions of the drivers, into how many parts their path is divided to see whether dyads reach
/// there.
[[nodiscard]] int closure_parts(const DesignSetup& setup, std::span<const double> from,
                                std::span<const double> to);

/// The rows of a mechanism of drivers and dyads, positions in closed form, without rates. \param mechanism
/// becomes rows.mechanism
void place_rows(const DesignSetup& setup, std::unique_ptr<const Mechanism> mechanism, const Plan& plan,
                int branch, DesignRows& rows);

}  // namespace higherpair
