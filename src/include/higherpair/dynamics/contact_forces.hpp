#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/dynamics/preload.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace higherpair {

/// What the drivers do over a whole run, as a function of one parameter, for example the number of the row.
struct DriverPath {
  std::vector<double> knots;  ///< ascending; the drivers' motion is smooth between two neighbours, and no
                              ///< driver turns back there. One knot alone: they stay where they are
  std::function<void(double at, std::vector<DriverMotion>& drivers)> motion;
};

/// The straight path between two positions of the drivers, velocities and accelerations changing in
/// proportion; its parameter runs from 0 to `length`.
[[nodiscard]] DriverPath straight_path(std::vector<DriverMotion> from, std::vector<DriverMotion> to,
                                       double length = 1);

/// Where a contact begins to pull.
struct ContactOpening {
  enum class Kind {
    kRoot,    ///< the contact force passes through 0
    kPole,    ///< it changes its sign by growing beyond all bounds: a dead point, not a lift-off
    kPulled,  ///< it pulls from the start, or from the end of a gap or a jump of the motion
  };
  std::size_t contact = 0;
  Kind kind = Kind::kRoot;
  double at = 0;      ///< parameter of the path
  double driver = 0;  ///< coordinate of the first driven joint [rad or m]
};

/// The smallest force of a contact on the whole path.
struct LowestForce {
  double force = 0;  ///< [N]; < 0: the contact would have to pull
  double at = 0;     ///< where, as in ContactOpening
  double driver = 0;
  bool is_minimum = true;  ///< false: it still falls where it is last known, next to a singular position
};

/// Coefficients of a series in Chebyshev polynomials T_0, T_1, …
using ForceSeries = std::array<double, 16>;

/// The contact forces on a stretch of the path in which they are smooth. The force of a contact is the sum
/// of its parts at rest (weights, loads, springs), from dampers and from inertia; the other columns are what
/// a unit of each preload adds to it. With u the factor by which the drivers go faster, p the preloads:
///     N = rest + u dampers + u² inertia + Σ p_k column_k
struct ForcePiece {
  static constexpr std::size_t kParts = 3;

  double from = 0;  ///< parameter of the path; the series run from -1 to 1 between the two
  double to = 0;
  double noise = 0;            ///< forces up to this are rounding [N]
  bool singular_from = false;  ///< something is left out before
  bool singular_to = false;    ///< and behind
  std::vector<bool> known;     ///< of Mechanism::contacts: whether the balance determines the force
  std::vector<ForceSeries>
      columns;  ///< kParts + number of preloads of the first contact, then of the second …
};

/// Contact forces along a whole path, whatever its rows.
struct ContactForces {
  std::vector<Preload> preloads;                   ///< that the pieces have columns for
  std::vector<ContactOpening> openings;            ///< in the order of the path
  std::vector<std::optional<LowestForce>> lowest;  ///< of Mechanism::contacts; none where never defined
  std::vector<ForcePiece> pieces;
  bool complete = true;  ///< false: only the first kMostPieces pieces were kept

  static constexpr std::size_t kMostPieces = 20000;
};

/// Follows the contact forces along a path: where the motion is smooth they are interpolated at Chebyshev
/// points, on pieces that are halved until the series has converged to within rounding. So zeros and minima
/// are those of the force itself. Stretches without a position or without rates are left out, and so is what
/// is nearer to a singular position than 1.5e-5 of 30 degrees (of a quarter of the size on a slide).
/// Ends early where is_stopped(start).
/// \param start  the mechanism at the path's first positions, as start_run returns it
/// \param preloads  that the pieces get columns for
[[nodiscard]] ContactForces follow_contact_forces(const Run& start, const DriverPath& path,
                                                  std::vector<Preload> preloads = {});

}  // namespace higherpair
