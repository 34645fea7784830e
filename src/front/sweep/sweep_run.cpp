#include "higherpair/front/sweep.hpp"
#include "numeric/arena.hpp"

#include <algorithm>
#include <tbb/parallel_pipeline.h>

namespace higherpair {

// Blocks per thread that are in progress or wait for an earlier one: memory does not grow with the sweep.
constexpr std::size_t kBlocksPerThread = 4;

void run_sweep(const Sweep& sweep, std::int64_t first, int threads,
               const std::function<bool(const SweepBlock&)>& take) {
  threads = thread_count(threads);
  std::int64_t next = std::max<std::int64_t>(first, 0);
  std::atomic<bool> ended = false;
  const auto number = [&](tbb::flow_control& control) {
    if (ended || next >= sweep.blocks()) {
      control.stop();
      return next;
    }
    return next++;
  };
  const auto work = [&](std::int64_t block) {
    return ended ? SweepBlock{0, 0, 0, {}, {}, false} : sweep.block(block);
  };
  const auto hand_over = [&](const SweepBlock& block) {
    if (!ended && (!block.complete || !take(block))) {
      ended = true;
    }
  };
  on_threads(threads, [&] {
    tbb::parallel_pipeline(
        kBlocksPerThread * static_cast<std::size_t>(threads),
        tbb::make_filter<void, std::int64_t>(tbb::filter_mode::serial_in_order, number) &
            tbb::make_filter<std::int64_t, SweepBlock>(tbb::filter_mode::parallel, work) &
            tbb::make_filter<SweepBlock, void>(tbb::filter_mode::serial_in_order, hand_over));
  });
}

}  // namespace higherpair
