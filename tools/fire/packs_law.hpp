#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace higherpair::fire {

/// The kinds of chains for which the packs law can be tested.
[[nodiscard]] std::span<const std::string_view> chain_kinds();

/// Compares rows computed many at a time (DyadChain) with those of a run that follows the motion, with all
/// forces. Prints their differences in units in the last place, and every case in which the run finds
/// something that they have missed.
/// \param kind  one of chain_kinds()
/// \return number of such cases
[[nodiscard]] long try_packs(std::string_view kind, std::uint64_t seed, long first, long count);

}  // namespace higherpair::fire
