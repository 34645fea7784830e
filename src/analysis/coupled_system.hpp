#pragma once

#include "group_solver.hpp"
#include "higherpair/mechanism/constraint_rows.hpp"

#include <optional>
#include <vector>

#include <Eigen/Core>

// The conditions of coupled bodies, all at once. Their coordinates are (x, y, size·θ) of each body of the
// group.

namespace higherpair {

/// The group's bodies and contacts as they are in another state.
void take_group(const Group& group, const State& from, State& to);

/// Puts the group's contacts onto the common normals of their bodies that are nearest; false where there is
/// none.
[[nodiscard]] bool place_contacts(const Planned& model, const Group& group, State& to);

/// The rows of the group's joints, contacts, driven joints and idle bodies, which keep their angles.
/// \param contacts  on the common normals of their bodies
[[nodiscard]] std::vector<ConstraintRow> group_rows(const Planned& model, const Group& group,
                                                    const std::vector<double>& drivers, const State& state,
                                                    const std::vector<ContactMotion>& contacts);

/// Appends rows of bodies that keep the angles that they have in a state.
void hold_angles(const std::vector<int>& held, const State& in, const State& to, double size,
                 std::vector<ConstraintRow>& rows);

[[nodiscard]] Eigen::VectorXd values_of(const std::vector<ConstraintRow>& rows);

/// Where the points of the group's joints and its contacts are in ground [m]. \param body  only of this one
[[nodiscard]] std::vector<Vector2d> places_of(const Planned& model, const Group& group, const State& state,
                                              std::optional<int> body = std::nullopt);

/// Σ weight · (derivatives of a row by the coordinates).
[[nodiscard]] Eigen::VectorXd gradient_of(const Group& group, const std::vector<ConstraintRow>& rows,
                                          const Eigen::VectorXd& weights, double size);

/// The derivatives of the rows by the coordinates.
[[nodiscard]] Eigen::MatrixXd jacobian_of(const Group& group, const std::vector<ConstraintRow>& rows,
                                          double size);

}  // namespace higherpair
