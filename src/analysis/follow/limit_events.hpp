#pragma once

#include "higherpair/analysis/run.hpp"

#include <cstddef>

namespace higherpair {

/// The event of a group's limit at s on a path.
[[nodiscard]] RunEvent limit_event(const Run& run, std::size_t g, const Path& path, double s);

/// Reports a limit unless it has been reported: where the motion comes to a limit and goes on from there,
/// both find the same limit.
void report_limit(Run& run, const Path& path, RunEvent event);

}  // namespace higherpair
