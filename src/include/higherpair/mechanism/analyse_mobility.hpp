#pragma once

#include "higherpair/contact/common_normal.hpp"
#include "higherpair/mechanism/description.hpp"
#include "higherpair/mechanism/mobility.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// The positions of all bodies and contacts at one instant.
struct MechanismPosition {
  std::vector<BodyMotion> bodies;       ///< of Mechanism::bodies
  std::vector<ContactMotion> contacts;  ///< of Mechanism::contacts
};

/// From where to analyse a mechanism.
struct MobilityQuestion {
  std::vector<double> drivers;  ///< coordinates to hold at the start; empty: leave them free
  std::vector<double>
      velocities;  ///< velocities of the drivers, for `moving`; empty, or a single 0: 1 for each
  /// An assembled position; none: assembled near the poses, with the drivers held or free.
  std::optional<MechanismPosition> start;
};

/// Counts, and determines the rank of the constraint Jacobian J (rows of joints and contacts; columns x, y,
/// size·θ of the moving bodies) at the start and at nearby positions, reached by moves along its null space
/// and re-assembly. Singular values below 1e-8 of the largest count as zero. The smallest null space is
/// taken, and of it only the directions in which those moves really lead away: a null vector along which the
/// mechanism returns to where it was is no freedom but the infinitesimal mobility of a shaky structure.
[[nodiscard]] Mobility analyse_mobility(const Mechanism& mechanism, const MobilityQuestion& question = {});

}  // namespace higherpair
