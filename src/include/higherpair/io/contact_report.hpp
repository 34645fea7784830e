#pragma once

#include "higherpair/dynamics/contact_forces.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/profile.hpp"

#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// The contact forces along the path of a run, which do not depend on the number of its rows.
struct ContactForceReport {
  struct Opening {
    ContactOpening what;
    double row = 0;     ///< number of the row, fractional between two rows
    std::string cause;  ///< a sentence: what happens, and which preload would keep all contacts closed
  };

  std::vector<Opening> openings;                   ///< in the order of the path
  std::vector<std::optional<LowestForce>> lowest;  ///< one for each of Mechanism::contacts
  std::optional<double> highest_speed;             ///< as highest_speed() returns it
};

/// Follows the contact forces along a schedule. Advice about springs is verified: with the numbers as printed
/// no contact opens. \param start  the mechanism at the first row, as start_run returns it; its `stop` ends
/// this early
[[nodiscard]] ContactForceReport report_contacts(const Profile& profile, const DriverSchedule& schedule,
                                                 const Run& start);

/// A preload as a part of a sentence, for example "springs.line pulls by 3 N more (free_length 38.5 mm
/// instead of 40 mm)"; the force is rounded up to six digits.
/// \param addition  [N, or N m where it turns]
[[nodiscard]] std::string describe(const Preload& preload, double addition, const Profile& profile);

}  // namespace higherpair
