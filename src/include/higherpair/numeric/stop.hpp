#pragma once

#include <atomic>

namespace higherpair {

/// Whether somebody wants a long computation to end: a flag of theirs that another thread or a signal may
/// raise; null where nobody may ask.
[[nodiscard]] inline bool is_raised(const std::atomic<bool>* stop) {
  return stop != nullptr && stop->load(std::memory_order_relaxed);
}

}  // namespace higherpair
