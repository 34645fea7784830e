#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/mechanism/jerk_rows.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// The jerks of a row; SI units, ground frame.
struct JerkRow {
  std::vector<std::optional<BodyJerk>> bodies;   ///< of Mechanism::bodies; none where not defined
  std::vector<std::optional<BodyJerk>> linkage;  ///< the same of the frozen equivalent linkage: every contact
                                                 ///< replaced by its link, the motion up to acceleration kept
};

/// The third time derivatives of run.row, the drivers' accelerations being constant: group by group from the
/// conditions of its joints, contacts and drivers, differentiated once more. None where the row has no rates
/// or the conditions leave a group's jerks open; of the frozen linkage besides where a rolling contact was
/// all that set a body in motion (discs about their centres). Allocates.
[[nodiscard]] JerkRow jerks_of(const Run& run);

}  // namespace higherpair
