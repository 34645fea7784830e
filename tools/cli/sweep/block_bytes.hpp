#pragma once

#include "higherpair/front/sweep.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace higherpair::cli {

/// A block of a sweep as bytes, in the order of the machine: what a record of the journal holds, and what
/// ranks send to each other. \param width  values in each row
[[nodiscard]] std::string block_bytes(const SweepBlock& block, std::size_t width);

/// The block; none where bytes are missing, too many, or of another width.
[[nodiscard]] std::optional<SweepBlock> block_of(std::string_view bytes, std::size_t width);

/// Takes a block; false: no more of them.
using TakeBlock = std::function<bool(const SweepBlock&)>;

/// Takes records of a journal as the blocks whose numbers they have; refuses one that is no such block.
[[nodiscard]] std::function<bool(std::string_view)> records_as_blocks(std::size_t width, TakeBlock take);

}  // namespace higherpair::cli
