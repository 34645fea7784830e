#pragma once

#include "higherpair/front/sweep.hpp"

#include <atomic>
#include <string>

namespace higherpair::cli {

/// The work of all ranks but rank 0: computes blocks of the sweep until rank 0 has no more work.
/// \param identity     identifies the sweep
/// \param stop         ends the blocks in work; set when they are not wanted any more
/// \param interrupted  once true, no further block is begun
void work_for_rank_0(const Sweep& sweep, const std::string& identity, int threads, std::atomic<bool>& stop,
                     const std::atomic<bool>& interrupted);

/// The same for a rank that cannot compute: it only waits for the end.
void only_listen();

}  // namespace higherpair::cli
