#pragma once

#include "higherpair/analysis/run.hpp"

#include <cstddef>

namespace higherpair {

/// The limit of a group at s on a path.
[[nodiscard]] RunEvent limit_event(const Run& run, std::size_t g, const Path& path, double s);

/// Whether two events are one limit, by what it is and where the first driver is.
[[nodiscard]] bool is_same_limit(const Run& run, const RunEvent& a, const RunEvent& b);

/// Reports a limit unless it has been: where the motion comes to a limit and goes on from there it is one.
void report_limit(Run& run, const Path& path, RunEvent event);

}  // namespace higherpair
