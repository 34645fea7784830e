#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/dynamics/contact_forces.hpp"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace higherpair {

/// Which extremes of a quantity are sought.
struct Sought {
  bool least = false;
  bool greatest = false;
  double noise = 0;  ///< smaller values are rounding: 0
};

/// Quantities that are computed together at the position of a run.
struct PathQuantities {
  std::vector<Sought> sought;  ///< one for each
  /// Writes their values for a run that has moved to a parameter of the path; `values` is preset to NaN,
  /// which means undefined.
  std::function<void(const Run& run, double at, std::span<double> values)> values;
};

/// A place next to a singular position, towards which a quantity goes on beyond its extreme elsewhere.
struct PathGrowth {
  double at = 0;      ///< parameter of the path, of the sample beside the singular position
  double driver = 0;  ///< coordinate of the first driven joint [rad or m]
  /// What it tends to there: infinite (-infinite for the least) if it grows faster than the logarithm of the
  /// distance, else as if it went on with the root of the distance.
  double limit = 0;
};

struct PathExtreme {
  double value = 0;
  double at = 0;       ///< parameter of the path
  double driver = 0;   ///< coordinate of the first driven joint [rad or m]
  bool grows = false;  ///< it is still growing towards a singular position, next to which nothing is known
  std::optional<PathGrowth> growth;  ///< where it goes on beyond `value`, the farthest; none if nowhere
};

/// Extremes of one quantity; none where it is nowhere defined, or was not sought.
struct PathRange {
  std::optional<PathExtreme> least, greatest;
};

/// Cuts a path where path_extremes() can examine no more of it: a million samples, some 1400 turns of a
/// driver, fill hundreds of megabytes. Returns the parameter at which it was cut; none if it has fewer.
[[nodiscard]] std::optional<double> cut_to_examined(const Run& start, DriverPath& path);

/// Smallest and largest values of quantities along a whole path, whatever its rows. Samples (two for each
/// degree of a turning driver, and one in each part of a boundary that a contact passes) show near which
/// places they can lie; there the quantity is interpolated at Chebyshev points of positions that the run
/// moves to, on intervals that are halved until the series has converged to within rounding. At jumps both
/// one-sided limits count. Of equal extremes the first one on the path is taken. Extremes that lie entirely
/// between two samples may be missed. The stretch between a limit position or dead point and the samples next
/// to it is not searched, since rates there are rounding or unbounded; whether the quantity grows beyond the
/// extreme there is judged from a few positions on it. Ends early where is_stopped(start).
/// \param start   the mechanism at the path's first positions, as start_run returns it
/// \param breaks  ascending parameters of the path at which derivatives are known to jump
/// \return for each block of quantities a range of each
[[nodiscard]] std::vector<std::vector<PathRange>> path_extremes(const Run& start, const DriverPath& path,
                                                                const std::vector<PathQuantities>& blocks,
                                                                const std::vector<double>& breaks = {});

}  // namespace higherpair
