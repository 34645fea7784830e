#pragma once

#include "higherpair/cam/motion_law.hpp"

#include <optional>

namespace higherpair {

/// The first error in a description, if there is one.
[[nodiscard]] std::optional<LawFault> fault_of(const LawDescription& description);

}  // namespace higherpair
