#pragma once

#include <cstddef>

namespace higherpair::testing {

/// How often operator new has been called in this program.
[[nodiscard]] std::size_t allocation_count();

}  // namespace higherpair::testing
