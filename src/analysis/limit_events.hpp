#pragma once

#include "higherpair/analysis/run.hpp"

#include <cstddef>

namespace higherpair {

/// Reports that a group cannot be placed beyond s on a path.
void add_limit(Run& run, std::size_t g, const Path& path, double s);

/// Where on the path the limit of a tracked pair lies, that is known in the coordinate of the driver.
[[nodiscard]] double place_of(const Run& run, std::size_t g, const Path& path, const LimitPosition& limit);

/// The same of a tracked pair, whose limit is known in the coordinate of the driver that moves it.
void add_limit(Run& run, std::size_t g, const Path& path, const LimitPosition& limit);

/// Reports a limit unless it has been: where the motion comes to a limit and goes on from there it is one.
void report_limit(Run& run, const Path& path, RunEvent event);

}  // namespace higherpair
