#pragma once

#include "higherpair/analysis/run.hpp"
#include "step.hpp"

#include <string_view>
#include <vector>

namespace higherpair {

/// Sets the ends of a path.
void set_path(Path& path, const std::vector<double>& from, const std::vector<double>& to);

/// The first driver's coordinate at s.
[[nodiscard]] double driver_at(const Path& path, double s);

/// An event at s on the path.
[[nodiscard]] RunEvent event_at(EventType type, const Path& path, double s, std::string_view cause);

/// Says where on the path an event happens.
void set_place(RunEvent& event, const Path& path, double s);

/// Names the joint or contact at which an event of a group happens.
void name_item(const Run& run, std::size_t g, RunEvent& event);

/// Follows the path; false if the branch is lost on the way (run.at.held is then false and an event says
/// where). Sets run.at.drivers to where run.at.state is, and run.at.beside to the end itself where that
/// is near a crossing or a limit.
bool follow(Run& run, const Path& path);

/// Looks for the branch held last at the drivers' positions; true if it is there again. An event says where
/// on the way `from` the row before this stretch begins.
bool resume(Run& run, const std::vector<double>& drivers, const std::vector<double>& from);

}  // namespace higherpair
