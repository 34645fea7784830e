#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace higherpair::fuzz {

/// An input made from one of `inputs` by a few random changes: bits, bytes and numbers replaced, parts
/// removed, repeated, or inserted from another input. The same `number` gives the same input everywhere.
/// \pre inputs is not empty
[[nodiscard]] std::string mutated(const std::vector<std::string>& inputs, std::uint64_t number);

}  // namespace higherpair::fuzz
