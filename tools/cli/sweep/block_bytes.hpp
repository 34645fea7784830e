#pragma once

#include "higherpair/front/sweep.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace higherpair::cli {

/// A block of a sweep as bytes with a checksum, in the order of the machine: what the journal holds, and what
/// ranks send to each other. \param width  values in each row
[[nodiscard]] std::string block_bytes(const SweepBlock& block, std::size_t width);

/// The block; none where bytes are missing, too many, changed, or of another width.
[[nodiscard]] std::optional<SweepBlock> block_of(std::string_view bytes, std::size_t width);

/// So many bytes tell how long a block is.
inline constexpr std::size_t kBlockHeadSize = 48;

/// How many bytes the block takes whose head these are; none where they are no head, or it takes more than
/// `most`.
[[nodiscard]] std::optional<std::size_t> block_size(std::string_view head, std::size_t width,
                                                    std::size_t most);

}  // namespace higherpair::cli
