#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/geometry/body_jerk.hpp"

#include <optional>
#include <span>
#include <vector>

namespace higherpair {

/// The jerks of a row; SI units, ground frame.
struct JerkRow {
  std::vector<std::optional<BodyJerk>> bodies;  ///< of Mechanism::bodies; none where not defined
  /// The same for the frozen equivalent linkage: every contact replaced by its link, with the motion up to
  /// acceleration unchanged.
  std::vector<std::optional<BodyJerk>> linkage;
};

/// The third time derivatives of run.row: group by group from the conditions of its joints, contacts and
/// drivers, differentiated once more. None where the row has no rates, and where the conditions leave a
/// group's jerks undetermined, or determined by rounding, next to where branches nearly cross; for the frozen
/// linkage also where a body's motion was determined by a rolling contact alone (discs about their centres).
/// Allocates.
/// \param higher  rates of the drivers; none: their accelerations are constant
[[nodiscard]] JerkRow jerks_of(const Run& run, std::span<const HigherRates> higher = {});

/// Only JerkRow::bodies.
[[nodiscard]] std::vector<std::optional<BodyJerk>> true_jerks_of(const Run& run,
                                                                 std::span<const HigherRates> higher = {});

/// Third time derivative of a joint's coordinate in run.row [rad/s³ or m/s³]: the angle of the second body
/// relative to the first, or the displacement of the second point along the line of the first.
/// \param bodies one of the members of JerkRow; none where a body of the joint has none
[[nodiscard]] std::optional<double> joint_jerk(const Run& run, int joint,
                                               const std::vector<std::optional<BodyJerk>>& bodies);

}  // namespace higherpair
