#pragma once

#include "free_assembly.hpp"
#include "higherpair/mechanism/analyse_mobility.hpp"

#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// The sets of joints and contacts whose conditions depend on each other, from the left null space of their
/// Jacobian: two rows belong to one set if a dependence involves both.
/// \param left  orthonormal columns, yᵀJ = 0, by the rows of conditions_at()
[[nodiscard]] std::vector<Redundancy> find_redundancies(const SizedMechanism& sized,
                                                        const MechanismPosition& position,
                                                        const Eigen::MatrixXd& left);

/// The rows of conditions_at() that others imply wherever the mechanism can go, such as those of a second
/// guide. Of rows that imply each other, the last in `order`.
/// \param order  rows of joints and contacts
/// \return none if the mechanism cannot be assembled near its poses, or is shaky: it yields without going
/// anywhere
[[nodiscard]] std::vector<int> repeated_rows(const Mechanism& mechanism, const std::vector<int>& order);

}  // namespace higherpair
