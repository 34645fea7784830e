#pragma once

#include "group_solver.hpp"

namespace higherpair {

/// Newton's method on all conditions of a coupled group, from where `from` and its rates lead after `h`;
/// least squares where there are more conditions than coordinates.
/// \param held  bodies that keep their angle in `from`
[[nodiscard]] GroupStatus place_coupled(const Model& model, std::size_t g, const State& from, double h,
                                        const std::vector<double>& drivers, State& to,
                                        const std::vector<int>& held = {});

/// Velocities and accelerations from the same conditions.
void move_coupled(const Model& model, std::size_t g, const std::vector<DriverMotion>& drivers, State& state);

/// The conditions of a group where its bodies stand, with the drivers' rates.
void group_rows(const Model& model, const Group& group, const std::vector<DriverMotion>& drivers,
                const State& state, std::vector<ConstraintRow>& rows);

}  // namespace higherpair
