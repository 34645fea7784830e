#pragma once

#include "higherpair/front/sweep.hpp"
#include "mpi/block_threads.hpp"
#include "mpi/messages.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace higherpair::cli {

/// Rank 0 of a sweep on many: hands out blocks as ranks ask for them, and gives the results to `take` in
/// their order. Blocks that wait for one before them are as many as may be under way, whatever the number of
/// variants. Where one is so late that nothing else may be begun, or nothing else is left, it is given to
/// another rank as well, and what comes first counts: a slow rank does not hold up the others.
class Dispatcher {
public:
  using Take = std::function<bool(const SweepBlock&)>;

  /// \param identity  what the sweep of every rank has to be
  /// \param threads   of each rank
  Dispatcher(const Sweep& sweep, std::string identity, int threads, const std::atomic<bool>& stop);

  /// From block `first` on.
  void run(std::int64_t first, const Take& take);

private:
  struct Asker {
    int rank = 0;
    std::int64_t blocks = 0;  // that it wants
  };
  struct Issue {
    int rank = 0;  // that has it, or had it first
    bool again = false;
  };

  void serve(const Received& message);
  void hand_out();
  void accept(SweepBlock block);
  bool work_here();
  [[nodiscard]] std::int64_t choose(int rank);

  const Sweep& sweep_;
  std::string identity_;
  int threads_;
  const std::atomic<bool>& stop_;
  const Take* take_ = nullptr;
  std::int64_t window_;     // blocks under way or waiting
  std::int64_t next_ = 0;   // that nobody has been given
  std::int64_t taken_ = 0;  // all before it have been
  bool ended_ = false;
  std::map<std::int64_t, Issue> issued_;      // and not come back yet
  std::map<std::int64_t, SweepBlock> ready_;  // for those before them
  std::vector<Asker> askers_;
  std::vector<bool> agreed_;  // ranks whose sweep is the same
  BlockThreads own_;
  std::size_t own_wanted_;
};

/// Tells all other ranks that there is no more work, and waits until they have understood.
void dismiss_workers();

}  // namespace higherpair::cli
