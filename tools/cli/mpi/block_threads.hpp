#pragma once

#include "higherpair/front/sweep.hpp"

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace higherpair::cli {

/// Threads that work out blocks of a sweep, first given first begun.
class BlockThreads {
public:
  BlockThreads(const Sweep& sweep, int threads);
  /// Waits for the blocks under way; those that are not begun are forgotten.
  ~BlockThreads();
  BlockThreads(const BlockThreads&) = delete;
  BlockThreads& operator=(const BlockThreads&) = delete;

  void give(std::int64_t block);
  /// A block that is done, complete or not; none: there is none yet.
  [[nodiscard]] std::optional<SweepBlock> collect();

  /// Given and not collected.
  [[nodiscard]] std::size_t under_way() const { return under_way_; }

private:
  void work();

  const Sweep& sweep_;
  std::mutex mutex_;
  std::condition_variable given_;
  std::deque<std::int64_t> wanted_;
  std::deque<SweepBlock> done_;
  bool ended_ = false;
  std::size_t under_way_ = 0;
  std::vector<std::thread> threads_;
};

}  // namespace higherpair::cli
