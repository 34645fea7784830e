#pragma once

#include "higherpair/front/sweep.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace higherpair::cli {

/// A block of a sweep as bytes in the machine's representation, for records of the journal and for messages
/// between ranks.
/// \param width  number of values in each row
[[nodiscard]] std::string block_bytes(const SweepBlock& block, std::size_t width);

/// The block; none if there are too few or too many bytes, or the width differs.
[[nodiscard]] std::optional<SweepBlock> block_of(std::string_view bytes, std::size_t width);

/// Receives a block; returns false to get no more.
using TakeBlock = std::function<bool(const SweepBlock&)>;

/// A receiver of journal records that passes them on as blocks numbered from 0; it refuses any other record.
[[nodiscard]] std::function<bool(std::string_view)> records_as_blocks(std::size_t width, TakeBlock take);

}  // namespace higherpair::cli
