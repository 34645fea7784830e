#pragma once

#include "design_row_reader.hpp"

#include <array>
#include <optional>
#include <span>

namespace higherpair {

/// Number of parts into which the path between two positions of the drivers is divided to check whether the
/// dyads can be closed there.
[[nodiscard]] int closure_parts(const DesignSetup& setup, std::span<const DriverMotion> from,
                                std::span<const DriverMotion> to);

/// The vertex of the parabola through three values at equal distances.
struct GapVertex {
  double value = 0;
  std::array<double, 3> weights = {};  ///< derivatives of the value by the three
};

/// None where the middle value is not the largest.
[[nodiscard]] std::optional<GapVertex> vertex_of(double a, double b, double c);

/// Computes the rows of a mechanism of drivers and dyads: positions in closed form, no rates. \param
/// mechanism  becomes rows.mechanism
void place_rows(const DesignSetup& setup, std::unique_ptr<const Mechanism> mechanism, const Plan& plan,
                int branch, DesignRows& rows);

}  // namespace higherpair
