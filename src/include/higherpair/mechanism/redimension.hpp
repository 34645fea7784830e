#pragma once

#include "higherpair/mechanism/plan.hpp"

namespace higherpair {

/// Fills in the groups of a plan again, in place, for a mechanism with other dimensions; does not allocate
/// for groups of joints alone. Like redimensioned(), except that Plan::size, and what depends on it, are
/// kept. A dyad that degenerates with its new dimensions (a link of zero length) becomes CoupledBodies.
void redimension_groups(Plan& plan, const Mechanism& mechanism);

}  // namespace higherpair
