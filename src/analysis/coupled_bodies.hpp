#pragma once

#include "group_solver.hpp"

namespace higherpair {

/// Newton's method on all conditions of a coupled group, from where `from` and its rates lead after `h`;
/// least squares where there are more conditions than coordinates.
/// \param held  where rolling begins: bodies that keep their angle in `from`; the conditions may repeat each
///              other and leave some freedom then, and the nearest position is taken
[[nodiscard]] GroupStatus place_coupled(const Planned& model, std::size_t g, const State& from, double h,
                                        const std::vector<double>& drivers, State& to,
                                        const std::optional<std::vector<int>>& held = {});

/// Places the bodies however far the drivers have moved from where `from` is: at the solution in mode
/// to.groups[g].mode that begins where they violate the conditions least near `from`. Where none does they
/// are left at that place, and `way` says how they came there; from one position to the next a
/// solution is so come upon where it begins. They stay where they are in `from` where the place is far away,
/// or the solution that begins is another one: of other parts of the group that have turned over on the way,
/// or, with conditions in surplus, one that cannot be known. Golubitsky and Schaeffer, Singularities and
/// Groups 1, I.3 (reduction); Griewank and Reddien, SIAM J. Numer. Anal. 21, 1984 (bordered matrices).
[[nodiscard]] GroupStatus place_coupled_anew(const Planned& model, std::size_t g, const State& from,
                                             const std::vector<double>& drivers, State& to,
                                             std::optional<LeastViolation>& way);

/// Sets whether the group's bodies are where their conditions have lost their rank, and on which branch.
void judge_coupled(const Planned& model, std::size_t g, State& state);

/// The determinant of the group's conditions at the present poses of its bodies, scaled: GroupState::sine.
[[nodiscard]] double coupled_sine(const Planned& model, std::size_t g, const State& state);

/// Velocities and accelerations from the same conditions.
void move_coupled(const Planned& model, std::size_t g, const std::vector<DriverMotion>& drivers,
                  State& state);

}  // namespace higherpair
