#pragma once

#include "higherpair/mechanism/plan.hpp"

namespace higherpair {

/// Fills in the groups of a plan anew for a mechanism with other dimensions, in place, without allocation for
/// groups of joints alone: what redimensioned() does, but Plan::size, and what depends on it, stay as they
/// are. A dyad that its new dimensions make none (a link without length) becomes CoupledBodies.
void redimension_groups(Plan& plan, const Mechanism& mechanism);

}  // namespace higherpair
