#pragma once

#include "higherpair/geometry/pose.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/profile.hpp"

#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

namespace higherpair {

/// Notes on what is valid in a profile but probably a slip, in addition to Profile::notes: joints and curves
/// that are far from where the poses put them once the mechanism is assembled, and bodies that are turned
/// round. \param bodies  at the first driver position, those of the mechanism in their order
[[nodiscard]] Diagnostics start_notes(const Profile& profile, const std::vector<BodyMotion>& bodies);

/// Notes on drivers whose rows go from start to end against their velocity: the rates are then those of the
/// motion in the other direction.
/// \param schedule  of the profile's rows; none have a note if they are in time or listed
[[nodiscard]] Diagnostics direction_notes(const Profile& profile, const DriverSchedule& schedule);

/// Notes on contacts that may part and did not touch anywhere on the path of a run.
/// \param contacts  indices into Mechanism::contacts
[[nodiscard]] Diagnostics untouched_notes(const Profile& profile, const std::vector<std::size_t>& contacts);

/// Where the (first) driver could start instead, for the end of a message that the mechanism cannot be
/// assembled with its drivers at these positions: "; it is possible, for example, with driver.start
/// from -65.8 to 65.8 deg". Of a driver with a law or listed positions it names these. Empty if something
/// else is wrong. See find_start_ranges. \param drivers    in SI units \param tolerance  as of start_run
/// \param stop       once true, the search is abandoned; may be null
[[nodiscard]] std::string start_advice(const Profile& profile, const std::vector<double>& drivers,
                                       double tolerance, const std::atomic<bool>* stop = nullptr);

}  // namespace higherpair
