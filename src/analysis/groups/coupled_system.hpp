#pragma once

#include "group_solver.hpp"
#include "higherpair/mechanism/constraint_rows.hpp"

#include <optional>
#include <vector>

#include <Eigen/Core>

// The system of all conditions of a coupled group. The coordinates are (x, y, size·θ) of each body of the
// group.

namespace higherpair {

/// Copies the group's bodies and contacts from one state to another.
void take_group(const Group& group, const State& from, State& to);

/// Moves the group's contacts to the nearest common normals of their bodies; false where there is none.
[[nodiscard]] bool place_contacts(const Planned& model, const Group& group, State& to);

/// The rows of the group's joints, contacts, drivers and idle bodies; the latter keep their angles.
/// \param contacts  on the common normals of their bodies
[[nodiscard]] std::vector<ConstraintRow> group_rows(const Planned& model, const Group& group,
                                                    const std::vector<DriverMotion>& drivers,
                                                    const State& state,
                                                    const std::vector<ContactMotion>& contacts);

/// Appends rows that hold bodies at the angles that they have in state `in`.
void hold_angles(const std::vector<int>& held, const State& in, const State& to, double size,
                 std::vector<ConstraintRow>& rows);

/// Positions in ground of the points of the group's joints and of its contacts [m]. \param body  if given:
/// only those of this body
[[nodiscard]] std::vector<Vector2d> places_of(const Planned& model, const Group& group, const State& state,
                                              std::optional<int> body = std::nullopt);

/// A point of ground that the mechanism is joined to [m]: distances that decide what is far out are measured
/// from it, as the origin of ground may be anywhere.
[[nodiscard]] Vector2d place_of_ground(const Mechanism& mechanism);

/// The largest distance of a place of coupled bodies, or of their contacts, from place_of_ground() [m];
/// infinite where one is undefined, 0 without coupled bodies.
[[nodiscard]] double farthest_coupled(const Planned& model, const State& state);

/// Σ weight · (derivatives of a row by the coordinates).
[[nodiscard]] Eigen::VectorXd gradient_of(const Group& group, const std::vector<ConstraintRow>& rows,
                                          const Eigen::VectorXd& weights, double size);

/// The derivatives of the rows by the coordinates.
[[nodiscard]] Eigen::MatrixXd jacobian_of(const Group& group, const std::vector<ConstraintRow>& rows,
                                          double size);

}  // namespace higherpair
