#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace higherpair::fire {

/// The chains of which the law of packs is tried.
[[nodiscard]] std::span<const std::string_view> chain_kinds();

/// Rows that are worked out many at a time (DyadChain) against those of a run that follows the motion, with
/// all forces. Prints how far they are from each other, in units in the last
/// place, and every case in which the run finds what they have missed. \return how many of these there are
/// \param kind  one of chain_kinds()
[[nodiscard]] long try_packs(std::string_view kind, std::uint64_t seed, long first, long count);

}  // namespace higherpair::fire
