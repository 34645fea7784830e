#pragma once

#include "free_assembly.hpp"

#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// The sets of joints and contacts whose conditions depend on each other, from the left null space of their
/// Jacobian: two rows are of one set if a dependence holds them together.
/// \param left  orthonormal columns, yᵀJ = 0, by the rows of conditions_at()
[[nodiscard]] std::vector<Redundancy> find_redundancies(const SizedMechanism& sized,
                                                        const MechanismPosition& position,
                                                        const Eigen::MatrixXd& left);

}  // namespace higherpair
