#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/geometry/body_jerk.hpp"

#include <optional>
#include <span>
#include <vector>

namespace higherpair {

/// The jerks of a row; SI units, ground frame.
struct JerkRow {
  std::vector<std::optional<BodyJerk>> bodies;   ///< of Mechanism::bodies; none where not defined
  std::vector<std::optional<BodyJerk>> linkage;  ///< the same of the frozen equivalent linkage: every contact
                                                 ///< replaced by its link, the motion up to acceleration kept
};

/// The third time derivatives of run.row: group by group from the conditions of its joints, contacts and
/// drivers, differentiated once more. None where the row has no rates or the conditions leave a group's jerks
/// open; of the frozen linkage besides where a rolling contact was all that set a body in motion (discs about
/// their centres). Allocates. \param higher  of the drivers; none: their accelerations are constant
[[nodiscard]] JerkRow jerks_of(const Run& run, std::span<const HigherRates> higher = {});

/// JerkRow::bodies alone.
[[nodiscard]] std::vector<std::optional<BodyJerk>> true_jerks_of(const Run& run,
                                                                 std::span<const HigherRates> higher = {});

/// Third time derivative of a joint's coordinate in run.row [rad/s³ or m/s³]: the angle of the second body
/// relative to the first, or the displacement of the second point along the line of the first.
/// \param bodies one of the members of JerkRow; none where a body of the joint has none
[[nodiscard]] std::optional<double> joint_jerk(const Run& run, int joint,
                                               const std::vector<std::optional<BodyJerk>>& bodies);

}  // namespace higherpair
