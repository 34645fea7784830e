#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/dynamics/preload.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace higherpair {

/// The motion of the drivers over a whole run, as a function of one parameter, for example the row number.
struct DriverPath {
  /// ascending; between two neighbours the drivers' motion is smooth and no driver reverses. A single knot:
  /// the drivers do not move.
  std::vector<double> knots;
  std::function<void(double at, std::vector<DriverMotion>& drivers)> motion;
  /// With several drivers in time: the same, the parameter being the time [s]; else null, and a run goes
  /// straight from place to place.
  std::shared_ptr<const DriverCurve> curve{};

  /// The drivers' motion at a place of the path.
  [[nodiscard]] std::vector<DriverMotion> at(double place) const {
    std::vector<DriverMotion> drivers;
    motion(place, drivers);
    return drivers;
  }

  /// The place between two places at which a run that moves from one to the other has covered a share of its
  /// path, as RunEvent::share.
  [[nodiscard]] double place_of(double share, double from, double to) const;

  /// Moves a run from one place to another.
  void move(Run& run, double from, double to) const;
};

/// The straight path between two positions of the drivers, with velocities and accelerations interpolated
/// linearly; its parameter runs from 0 to `length`.
[[nodiscard]] DriverPath straight_path(std::vector<DriverMotion> from, std::vector<DriverMotion> to,
                                       double length = 1);

/// How far the driver that moves most goes between two positions, in units of `turn` [rad] if it turns, else
/// of `slide` times the mechanism's size.
[[nodiscard]] double largest_move(const Run& run, const std::vector<DriverMotion>& from,
                                  const std::vector<DriverMotion>& to, double turn, double slide);

/// Where a contact begins to pull.
struct ContactOpening {
  enum class Kind {
    kRoot,    ///< the contact force passes through 0
    kPole,    ///< it changes sign by growing without bound: a change point, not a lift-off
    kPulled,  ///< it pulls from the start, or right after a gap or a jump of the motion
  };
  std::size_t contact = 0;
  Kind kind = Kind::kRoot;
  double at = 0;      ///< parameter of the path
  double driver = 0;  ///< coordinate of the first driven joint [rad or m]
};

/// The smallest force of a contact along the whole path.
struct LowestForce {
  double force = 0;  ///< [N]; < 0: the contact would have to pull
  double at = 0;     ///< where, as in ContactOpening
  double driver = 0;
};

/// Coefficients of a series in Chebyshev polynomials T_0, T_1, …
using ForceSeries = std::array<double, 16>;

/// The contact forces on a stretch of the path in which they are smooth. The force of a contact is the sum of
/// its parts at rest (weights, loads, springs), from dampers and from inertia; the other columns are the
/// contributions of a unit of each preload. With u the factor on the speed of the drivers, p the preloads:
///     N = rest + u dampers + u² inertia + Σ p_k column_k
struct ForcePiece {
  static constexpr std::size_t kParts = 3;

  double from = 0;  ///< parameter of the path; the series run from -1 to 1 between `from` and `to`
  double to = 0;
  double noise = 0;            ///< smaller forces are rounding [N]
  bool singular_from = false;  ///< the stretch before it is left out
  bool singular_to = false;    ///< and the one after it
  std::vector<bool> known;     ///< of Mechanism::contacts: whether the balance determines the force
  /// kParts + number of preloads for the first contact, then for the second …
  std::vector<ForceSeries> columns;
};

/// The weighted sum of the first columns of a contact's force in a piece, one for each weight.
[[nodiscard]] ForceSeries weighted_force(const ForcePiece& piece, std::size_t contact,
                                         std::span<const double> weights);

/// Contact forces along a whole path, whatever its rows.
struct ContactForces {
  std::vector<Preload> preloads;                   ///< those that the pieces have columns for
  std::vector<ContactOpening> openings;            ///< in the order of the path
  std::vector<std::optional<LowestForce>> lowest;  ///< of Mechanism::contacts; none where it is never defined
  std::vector<ForcePiece> pieces;
  bool complete = true;  ///< false: only the first kMostPieces pieces were kept

  static constexpr std::size_t kMostPieces = 20000;
};

/// Follows the contact forces along a path: where the motion is smooth they are interpolated at Chebyshev
/// points, on pieces that are halved until the series has converged to within rounding. Zeros and minima are
/// therefore those of the force itself. Stretches without a position or without rates are left out, and so is
/// everything closer to a singular position than 1.5e-5 of 30 degrees (of a quarter of the size on a slide).
/// Ends early where is_stopped(start).
/// \param start  the mechanism at the path's first positions, as start_run returns it
/// \param preloads  those that the pieces get columns for
[[nodiscard]] ContactForces follow_contact_forces(const Run& start, const DriverPath& path,
                                                  std::vector<Preload> preloads = {});

}  // namespace higherpair
