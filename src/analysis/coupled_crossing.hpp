#pragma once

#include "higherpair/analysis/run.hpp"

#include <optional>

namespace higherpair {

/// Whether the branches of a coupled group really cross within a step at whose end its determinant has the
/// other sign: looked at ever closer, the motion stays smooth. Branches that only come near to each other
/// turn away there, and a step across is a jump. run.trial is used up.
[[nodiscard]] bool passes_crossing(Run& run, const Path& path, std::size_t g, double s, double h);

/// Where in such a step its branches cross, from s; none where that cannot be told. run.trial is used up.
[[nodiscard]] std::optional<double> place_of_crossing(Run& run, const Path& path, std::size_t g, double s,
                                                      double h);

}  // namespace higherpair
