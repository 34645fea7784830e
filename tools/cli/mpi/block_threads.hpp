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

/// Threads that compute blocks of a sweep, in the order in which they are given.
class BlockThreads {
public:
  BlockThreads(const Sweep& sweep, int threads);
  /// Waits for the blocks in work; those not yet begun are dropped.
  ~BlockThreads();
  BlockThreads(const BlockThreads&) = delete;
  BlockThreads& operator=(const BlockThreads&) = delete;

  void give(std::int64_t block);
  /// A finished block, complete or not; none if there is none yet.
  [[nodiscard]] std::optional<SweepBlock> collect();

  /// Number of blocks given but not collected.
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
