#include "mpi/worker.hpp"

#include "mpi/block_threads.hpp"
#include "mpi/messages.hpp"
#include "sweep/block_bytes.hpp"

namespace higherpair::cli {
namespace {

class Worker {
public:
  Worker(const Sweep& sweep, int threads)
      : sweep_(sweep), wanted_(static_cast<std::size_t>(threads) + 1), threads_(sweep, threads) {}

  /// Asks for one block more than there are threads, so that a thread that ends one can begin the next at
  /// once.
  void ask() {
    const std::size_t expected = threads_.under_way() + asked_;
    if (expected < wanted_) {
      send(0, Message::kAsk, static_cast<std::int64_t>(wanted_ - expected));
      asked_ = wanted_ - threads_.under_way();
    }
  }

  void begin(std::int64_t block) {
    --asked_;
    threads_.give(block);
  }

  /// Sends finished blocks to rank 0; returns whether there were any.
  bool hand_in() {
    bool any = false;
    while (const auto block = threads_.collect()) {
      if (block->complete) send(0, Message::kResult, block_bytes(*block, sweep_.columns().size()));
      any = true;
    }
    return any;
  }

private:
  const Sweep& sweep_;
  std::size_t wanted_;
  std::size_t asked_ = 0;
  BlockThreads threads_;
};

}  // namespace

void work_for_rank_0(const Sweep& sweep, const std::string& identity, int threads, std::atomic<bool>& stop,
                     const std::atomic<bool>& interrupted) {
  send(0, Message::kHello, identity);
  {
    Worker worker(sweep, threads);
    for (;;) {
      if (interrupted) stop = true;
      bool idle = !worker.hand_in();
      if (!stop) worker.ask();
      if (const auto message = receive()) {
        if (message->what == Message::kEnd) break;
        worker.begin(message->number());
        idle = false;
      }
      if (idle) rest();
    }
    stop = true;
  }
  send(0, Message::kBye);
}

void only_listen() {
  for (;;) {
    const auto message = receive();
    if (message && message->what == Message::kEnd) break;
    rest();
  }
  send(0, Message::kBye);
}

}  // namespace higherpair::cli
