// Computes the rows of a run on several threads. A scout moves along the path ahead of them and leaves a copy
// of the run at the end of every block; the next block is computed from there, on its own. Blocks are handed
// over in order: where one ends in another state than the next one has begun with (a row within rounding of a
// change point), the next one is computed again from that end. Analysis::next does the same with one block
// after the other.
#include "front/analysis_impl.hpp"
#include "higherpair/front/motion.hpp"
#include "numeric/arena.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <tbb/parallel_pipeline.h>
#include <utility>

namespace higherpair {
namespace {

// Blocks per thread that are in progress or wait for an earlier one.
constexpr std::size_t kRowBlocksPerThread = 2;

struct Block {
  RowBlock rows;
  RunPlace from;  // state at the row before; for the first block, at the start
  RunPlace end;   // state at its last row
  BlockTexts texts;
  RowsFound found;
  bool complete = false;  // false: stopped
};

class BlockRun {
public:
  using MakeTexts = std::function<void(const RowBlock&, BlockTexts&)>;
  using Take = std::function<bool(const RowBlock&, const BlockTexts&)>;

  BlockRun(Analysis::Impl& whole, const MakeTexts& texts, const Take& take)
      : whole_(whole), texts_(texts), take_(take), start_(whole.make_worker()), scout_(whole.run) {}

  [[nodiscard]] bool has_more() const { return !ended_ && next_ < whole_.schedule.size(); }

  // Called in order, for one block at a time.
  Block begin() {
    Block block = take_memory();
    block.rows.first = next_;
    block.from = next_ == 0 ? RunPlace{start_->run, {}} : scout_.go_to(whole_.schedule, next_ - 1);
    next_ += kBlockRows;
    return block;
  }

  // Called for any number of blocks at once.
  void work_out(Block& block) {
    if (ended_) {
      return;
    }
    auto worker = take_worker();
    worker->begin_at(block.rows.first, block.from);
    worker->found = {.idle = std::vector<IdleMoment>(whole_.found.idle.size())};
    block.rows.statuses.clear();
    block.rows.values.clear();
    const std::int64_t wanted = std::min(kBlockRows, whole_.schedule.size() - block.rows.first);
    Row row;
    while (static_cast<std::int64_t>(block.rows.size()) < wanted && worker->next_row(row)) {
      block.rows.statuses.push_back(row.status);
      block.rows.values.insert(block.rows.values.end(), row.values.begin(), row.values.end());
    }
    block.complete = static_cast<std::int64_t>(block.rows.size()) == wanted;
    if (block.complete) {
      block.end = {worker->run, worker->history};
      block.found = std::move(worker->found);
      for (std::string& text : block.texts) text.clear();
      texts_(block.rows, block.texts);
    }
    give_back(std::move(worker));
  }

  // Called in order, for one block at a time.
  void hand_over(Block& block) {
    if (block.complete && last_ && !go_on_alike(*last_, block.from)) {
      block.from = *std::move(last_);
      work_out(block);
    }
    if (ended_ || !block.complete || !take_(block.rows, block.texts)) {
      ended_ = true;
      return;
    }
    whole_.add_block(std::move(block.found), block.rows.first + static_cast<std::int64_t>(block.rows.size()));
    last_ = std::move(block.end);
    const std::lock_guard lock(mutex_);
    written_.push_back({std::move(block.rows), std::move(block.texts)});
  }

private:
  struct Memory {
    RowBlock rows;
    BlockTexts texts;
  };

  // A block that uses the memory of one that has been handed over: blocks take megabytes, which the system
  // would clear each time.
  Block take_memory() {
    Block block;
    const std::lock_guard lock(mutex_);
    if (!written_.empty()) {
      block.rows = std::move(written_.back().rows);
      block.texts = std::move(written_.back().texts);
      written_.pop_back();
    }
    return block;
  }

  // A copy of the run, with buffers of its own.
  std::unique_ptr<Analysis::Impl> take_worker() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) {
      return start_->make_worker();
    }
    auto worker = std::move(idle_.back());
    idle_.pop_back();
    return worker;
  }

  void give_back(std::unique_ptr<Analysis::Impl> worker) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(worker));
  }

  Analysis::Impl& whole_;
  const MakeTexts& texts_;
  const Take& take_;
  std::unique_ptr<const Analysis::Impl> start_;
  RowScout scout_;
  std::int64_t next_ = 0;
  std::atomic<bool> ended_ = false;
  std::optional<RunPlace> last_;  // at the end of the last block handed over
  std::mutex mutex_;
  std::vector<std::unique_ptr<Analysis::Impl>> idle_;
  std::vector<Memory> written_;
};

}  // namespace

void run_blocks(Analysis& analysis, int threads,
                const std::function<void(const RowBlock&, BlockTexts&)>& texts,
                const std::function<bool(const RowBlock&, const BlockTexts&)>& take) {
  threads = thread_count(threads);
  BlockRun run(analysis.impl(), texts, take);
  if (threads == 1 || analysis.size() <= kBlockRows) {
    while (run.has_more()) {
      Block block = run.begin();
      run.work_out(block);
      run.hand_over(block);
    }
    return;
  }
  using Passed = std::shared_ptr<Block>;
  const auto begin = [&](tbb::flow_control& control) -> Passed {
    if (!run.has_more()) {
      control.stop();
      return nullptr;
    }
    return std::make_shared<Block>(run.begin());
  };
  const auto work_out = [&](Passed block) {
    run.work_out(*block);
    return block;
  };
  const auto hand_over = [&](const Passed& block) { run.hand_over(*block); };
  on_threads(threads, [&] {
    tbb::parallel_pipeline(kRowBlocksPerThread * static_cast<std::size_t>(threads),
                           tbb::make_filter<void, Passed>(tbb::filter_mode::serial_in_order, begin) &
                               tbb::make_filter<Passed, Passed>(tbb::filter_mode::parallel, work_out) &
                               tbb::make_filter<Passed, void>(tbb::filter_mode::serial_in_order, hand_over));
  });
}

}  // namespace higherpair
