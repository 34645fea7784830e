#pragma once

#include "higherpair/analysis/run.hpp"

namespace higherpair {

/// Whether two runs of one model that have reached the same row, through different preceding rows, continue
/// alike from there: bodies and contacts in the same places (to 1e-9 rad, or relative to the size; angles
/// including whole turns) on the same branches, contacts and joints in the same states, the same limit at
/// this row or before, the same change points reported, outputs moving in the same senses. Either of two such
/// runs may replace the other: no event is lost or repeated, and rows agree to within rounding.
[[nodiscard]] bool go_on_alike(const Run& a, const Run& b);

}  // namespace higherpair
