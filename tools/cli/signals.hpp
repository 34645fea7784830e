#pragma once

#include <atomic>

namespace higherpair::cli {

/// From this call on INT, TERM and HUP end the program at once with kExitInterrupted, which is for use while
/// no output has been begun, and a write to a pipe that nobody reads fails.
void end_on_signals();

/// From this call on INT, TERM and HUP only set interruption().
void listen_to_signals();
[[nodiscard]] const std::atomic<bool>& interruption();

}  // namespace higherpair::cli
