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

/// Rank 0 of a sweep on many ranks: hands out blocks as ranks ask for them, and passes the results to `take`
/// in order. The number of results waiting for an earlier block is limited, whatever the number of variants.
/// If a block is so late that no other may be begun, or no other is left, it is given to a second rank as
/// well and the first result counts: a slow rank does not delay the others.
class Dispatcher {
public:
  using Take = std::function<bool(const SweepBlock&)>;

  /// \param identity  which the sweep of every rank has to match
  /// \param threads   of each rank
  Dispatcher(const Sweep& sweep, std::string identity, int threads, const std::atomic<bool>& stop);

  /// Runs the sweep from block `first` on.
  void run(std::int64_t first, const Take& take);

private:
  struct Asker {
    int rank = 0;
    std::int64_t blocks = 0;  // number of blocks wanted
  };
  struct Issue {
    int rank = 0;  // to which it was given first
    bool again = false;
  };

  void serve(const Received& message);
  void hand_out();
  void accept(SweepBlock&& block);
  bool work_here();
  [[nodiscard]] std::int64_t choose(int rank);

  const Sweep& sweep_;
  std::string identity_;
  int threads_;
  const std::atomic<bool>& stop_;
  const Take* take_ = nullptr;
  std::int64_t window_;     // largest number of blocks in work or waiting
  std::int64_t next_ = 0;   // first block that has not been given out
  std::int64_t taken_ = 0;  // all blocks before this one have been passed on
  bool ended_ = false;
  std::map<std::int64_t, Issue> issued_;      // given out and not returned yet
  std::map<std::int64_t, SweepBlock> ready_;  // waiting for earlier blocks
  std::vector<Asker> askers_;
  std::vector<bool> agreed_;  // whether the rank's sweep matches
  BlockThreads own_;
  std::size_t own_wanted_;
};

/// Tells all other ranks that there is no more work, and waits until they have confirmed it.
void dismiss_workers();

}  // namespace higherpair::cli
