#include "mpi/block_threads.hpp"

#include <utility>

namespace higherpair::cli {

BlockThreads::BlockThreads(const Sweep& sweep, int threads) : sweep_(sweep) {
  for (int i = 0; i < threads; ++i) {
    threads_.emplace_back([this] { work(); });
  }
}

BlockThreads::~BlockThreads() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  given_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void BlockThreads::give(std::int64_t block) {
  ++under_way_;
  {
    const std::lock_guard lock(mutex_);
    wanted_.push_back(block);
  }
  given_.notify_one();
}

std::optional<SweepBlock> BlockThreads::collect() {
  const std::lock_guard lock(mutex_);
  if (done_.empty()) {
    return std::nullopt;
  }
  SweepBlock block = std::move(done_.front());
  done_.pop_front();
  --under_way_;
  return block;
}

void BlockThreads::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    given_.wait(lock, [this] { return ended_ || !wanted_.empty(); });
    if (ended_) {
      return;
    }
    const std::int64_t number = wanted_.front();
    wanted_.pop_front();
    lock.unlock();
    SweepBlock block = sweep_.block(number);
    lock.lock();
    done_.push_back(std::move(block));
  }
}

}  // namespace higherpair::cli
