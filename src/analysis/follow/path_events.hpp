#pragma once

#include "inputs.hpp"

#include <string_view>

// Events on the path from one row to the next.

namespace higherpair {

/// Sets where an event is: at s on the path or, where that goes on as it ends, beyond it.
void place_event(RunEvent& event, const Path& path, double s);

/// An event at s on the path; at an end of it if s is beyond that.
[[nodiscard]] RunEvent event_at(EventType type, const Path& path, double s, std::string_view cause);

/// Whether two events have the same type and are of the same joint or contact.
[[nodiscard]] bool is_same_item(const RunEvent& a, const RunEvent& b);

/// Whether all drivers are at the same positions at two events.
/// \param near  relative to a driver's scale and to its position
[[nodiscard]] bool is_at_same_drivers(const Run& run, const RunEvent& a, const RunEvent& b, double near);

/// Adds an event of a contact at s on the path to the run's events.
/// \returns the event, for what else is known of it
RunEvent& report_contact(Run& run, EventType type, const Path& path, double s, std::size_t contact,
                         std::string_view cause);

/// Describes a rate that jumps. `before` and `after` are per unit of s; what is rounding compared with the
/// other becomes 0.
void set_jump(RunEvent& event, const Path& path, EventJump jump);

/// Sets the joint or contact at which an event of a group happens.
void name_item(const Run& run, std::size_t g, RunEvent& event);

}  // namespace higherpair
