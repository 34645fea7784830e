#pragma once

#include "free_assembly.hpp"
#include "higherpair/mechanism/analyse_mobility.hpp"
#include "higherpair/mechanism/tolerances.hpp"

#include <Eigen/Core>

namespace higherpair {

/// Orthonormal bases of the null spaces of a Jacobian.
struct NullSpaces {
  int rank = 0;
  Eigen::MatrixXd right;  ///< J v = 0
  Eigen::MatrixXd left;   ///< yᵀJ = 0
};

/// Singular values below `floor` of the largest (or of 1, that of a row) count as zero.
[[nodiscard]] NullSpaces null_spaces(const Eigen::MatrixXd& J, double floor = kRankFloor);

/// Where a mechanism can really go from an assembled position.
struct Moves {
  NullSpaces here;
  MechanismPosition best;  ///< of the smallest null space; off the start where it can be
  NullSpaces at_best;
  int positions = 1;  ///< looked at
  /// Orthonormal; the directions in the null space along which moves lead away.
  Eigen::MatrixXd real;
};

/// Moves along the null space by a small step and re-assembles, for every basis vector and some combinations.
[[nodiscard]] Moves explore(const SizedMechanism& sized, const MechanismPosition& start);

}  // namespace higherpair
