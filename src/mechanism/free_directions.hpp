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

/// Null spaces of J. Singular values below `floor` times the largest (or times 1, that of a row, if it is
/// larger) count as zero.
[[nodiscard]] NullSpaces null_spaces(const Eigen::MatrixXd& J, double floor = kRankFloor);

/// Which motions a mechanism really has from an assembled position.
struct Moves {
  NullSpaces here;
  MechanismPosition best;  ///< position with the smallest null space; not the start if possible
  NullSpaces at_best;
  int positions = 1;  ///< number of positions examined
  /// Orthonormal basis of the directions in the null space along which real moves lead away.
  Eigen::MatrixXd real;
};

/// For every basis vector of the null space and some combinations: moves along it by a small step and
/// re-assembles.
[[nodiscard]] Moves explore(const SizedMechanism& sized, const MechanismPosition& start);

}  // namespace higherpair
