#pragma once

#include "group_solver.hpp"

namespace higherpair {

/// Places a coupled group by Newton's method on all its conditions, starting from where `from` and its rates
/// lead after `h`; least squares where there are more conditions than coordinates.
/// \param held  where rolling begins: bodies that keep their angle in `from`. The conditions may then be
///              dependent and leave some freedom; the nearest position is taken
[[nodiscard]] GroupStatus place_coupled(const Planned& model, std::size_t g, const State& from, double h,
                                        const std::vector<DriverMotion>& drivers, State& to,
                                        const std::optional<std::vector<int>>& held = {});

/// Places the bodies however far the drivers have moved from `from`: at the solution in mode
/// to.groups[g].mode that begins where the conditions are violated least near `from`. If none begins there
/// they are left at that place, and `continuation` records how they came there; continued from one position
/// to the next, this finds a solution where it begins. The bodies stay where they are in `from` if that place
/// is far away, or if the solution that begins is another one: one in which other parts of the group have
/// turned over on the way, or, with surplus conditions, one that cannot be identified. Golubitsky and
/// Schaeffer, Singularities and Groups 1, I.3 (reduction); Griewank and Reddien, SIAM J. Numer. Anal. 21,
/// 1984 (bordered matrices).
[[nodiscard]] GroupStatus place_coupled_anew(const Planned& model, std::size_t g, const State& from,
                                             const std::vector<DriverMotion>& drivers, State& to,
                                             std::optional<LeastViolation>& continuation);

/// Sets the group's sine and mode: whether its conditions have lost their rank, and on which branch it is.
void judge_coupled(const Planned& model, std::size_t g, State& state);

/// How far the group's conditions are from singular at the present poses of its bodies: the smallest pivot,
/// with the sign of the determinant (GroupState::sine).
[[nodiscard]] double coupled_sine(const Planned& model, std::size_t g, const State& state);

/// Sets velocities and accelerations from the same conditions.
void move_coupled(const Planned& model, std::size_t g, const std::vector<DriverMotion>& drivers,
                  State& state);

}  // namespace higherpair
