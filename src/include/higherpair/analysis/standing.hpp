#pragma once

#include "higherpair/analysis/run.hpp"

namespace higherpair {

/// Whether two runs of one model that have come to the same row, over different rows before it, go on alike
/// from there: bodies and contacts at the same places (to 1e-9 rad, or of the size; angles with their whole
/// turns) on the same branches, contacts and joints in the same states, the same limit here or before, the
/// same change points named, outputs moving in the same senses. Of two that do either may take the
/// place of the other: no event is lost or comes twice, and rows agree to within rounding.
[[nodiscard]] bool go_on_alike(const Run& a, const Run& b);

}  // namespace higherpair
