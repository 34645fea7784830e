#pragma once

#include "group_solver.hpp"

#include <Eigen/Core>

namespace higherpair {

// The coordinates of a group: (x, y, size·θ) of its bodies, then size·φ of its contacts' normals [m].

[[nodiscard]] Eigen::VectorXd coordinates_of(const Planned& model, const Group& group, const State& state);

/// \param from  state whose contacts are taken over, with normals turned by the coordinates
void set_coordinates(const Planned& model, const Group& group, const State& from, const Eigen::VectorXd& x,
                     State& state);

/// The conditions of a group: values F [m], derivatives J by its coordinates, and derivatives F_s by the
/// path's coordinate, through the drivers and the known bodies, whose rates must be set. A contact
/// contributes its gap and the distance along the tangent, with the angle of its normal as a coordinate,
/// which stays regular where both curves have the same curvature. False where a curve has no point with the
/// normal.
[[nodiscard]] bool group_system(const Planned& model, const Group& group,
                                const std::vector<DriverMotion>& drivers, State& state, Eigen::VectorXd& F,
                                Eigen::MatrixXd& J, Eigen::VectorXd& F_s);

}  // namespace higherpair
