#pragma once

#include "higherpair/front/sweep.hpp"

#include <atomic>
#include <string>

namespace higherpair::cli {

/// What all ranks but rank 0 do: blocks of the sweep, until rank 0 has no more work.
/// \param identity  says what the sweep is
/// \param stop      ends the blocks under way; set where they are not wanted any more
/// \param interrupted  once true, nothing more is begun
void work_for_rank_0(const Sweep& sweep, const std::string& identity, int threads, std::atomic<bool>& stop,
                     const std::atomic<bool>& interrupted);

/// The same of a rank that cannot work.
void only_listen();

}  // namespace higherpair::cli
