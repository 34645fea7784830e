#pragma once

#include "higherpair/mechanism/plan.hpp"

#include <string>

#include <tl/expected.hpp>

namespace higherpair {

/// Whether a plan, redimensioned, is one of a mechanism that has the same bodies, joints, contacts and
/// drivers as the planned one: the same coordinates enter their conditions. They do not where pins of a body
/// come to coincide or part, or where a roller is round about its pin in one of them only.
[[nodiscard]] bool can_be_redimensioned(const Plan& plan, const Mechanism& mechanism);

/// The plan of a mechanism that differs from the planned one in its dimensions only: redimensioned(), or a
/// new one where that is not possible, which fails as make_plan() does.
[[nodiscard]] tl::expected<Plan, std::string> plan_like(const Plan& plan, const Mechanism& mechanism);

/// Fills in the groups of a plan again, in place, for a mechanism with other dimensions; does not allocate
/// for groups of joints alone. Like redimensioned(), except that Plan::size is kept. A dyad that degenerates
/// with its new dimensions (a link of zero length) becomes CoupledBodies.
void redimension_groups(Plan& plan, const Mechanism& mechanism);

}  // namespace higherpair
