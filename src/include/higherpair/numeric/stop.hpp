#pragma once

#include <atomic>

namespace higherpair {

/// Whether a long computation has been asked to end, by a flag that another thread or a signal handler may
/// raise; null: it cannot be asked.
[[nodiscard]] inline bool is_raised(const std::atomic<bool>* stop) {
  return stop != nullptr && stop->load(std::memory_order_relaxed);
}

}  // namespace higherpair
