#include "mpi/dispatcher.hpp"

#include "sweep/block_bytes.hpp"
#include "tell.hpp"

#include <utility>

namespace higherpair::cli {
namespace {

constexpr std::int64_t kNone = -1;
// Blocks per thread of all ranks: one in work, one waiting for the thread, and as many results waiting for a
// late one.
constexpr std::int64_t kBlocksPerThread = 4;
// With at most this many ranks, rank 0 also computes blocks itself.
constexpr int kMostToWorkBeside = 32;

}  // namespace

Dispatcher::Dispatcher(const Sweep& sweep, std::string identity, int threads, const std::atomic<bool>& stop)
    : sweep_(sweep),
      identity_(std::move(identity)),
      threads_(threads),
      stop_(stop),
      window_(kBlocksPerThread * threads * rank_count()),
      agreed_(static_cast<std::size_t>(rank_count()), false),
      own_(sweep, rank_count() <= kMostToWorkBeside ? threads : 0),
      own_wanted_(rank_count() <= kMostToWorkBeside ? static_cast<std::size_t>(threads) + 1 : 0) {}

void Dispatcher::run(std::int64_t first, const Take& take) {
  take_ = &take;
  next_ = taken_ = first;
  while (!ended_ && taken_ < sweep_.blocks()) {
    bool idle = true;
    while (const auto message = receive()) {
      serve(*message);
      idle = false;
    }
    if (work_here()) idle = false;
    if (stop_) ended_ = true;
    if (idle) {
      rest();
    } else {
      hand_out();
    }
  }
}

void Dispatcher::serve(const Received& message) {
  const auto rank = static_cast<std::size_t>(message.rank);
  switch (message.what) {
    case Message::kHello:
      agreed_[rank] = message.bytes == identity_;
      if (!agreed_[rank]) {
        tell(
            "higherpair: rank {} does not take part: it has another profile, or another version of "
            "this program\n",
            message.rank);
      }
      break;
    case Message::kAsk:
      if (agreed_[rank]) askers_.push_back({message.rank, message.number()});
      break;
    case Message::kResult:
      if (auto block = block_of(message.bytes, sweep_.columns().size())) {
        accept(*std::move(block));
      }
      break;
    case Message::kBye:
    case Message::kWork:
    case Message::kEnd:
      break;
  }
}

// A second result of the same block is dropped.
void Dispatcher::accept(SweepBlock&& block) {
  const std::int64_t number = block.number;
  issued_.erase(number);
  if (ended_ || !block.complete || number < taken_ || number >= next_) {
    return;
  }
  ready_.try_emplace(number, std::move(block));
  for (auto first = ready_.begin(); !ended_ && first != ready_.end() && first->first == taken_;
       first = ready_.begin()) {
    ended_ = !(*take_)(first->second);
    ready_.erase(first);
    ++taken_;
  }
}

// Computes blocks on this rank; returns whether one was finished or begun.
bool Dispatcher::work_here() {
  bool worked = false;
  while (auto block = own_.collect()) {
    accept(*std::move(block));
    worked = true;
  }
  while (own_.under_way() < own_wanted_) {
    const std::int64_t block = choose(0);
    if (block == kNone) break;
    own_.give(block);
    worked = true;
  }
  return worked;
}

void Dispatcher::hand_out() {
  for (Asker& asker : askers_) {
    while (asker.blocks > 0) {
      const std::int64_t block = choose(asker.rank);
      if (block == kNone) break;
      send(asker.rank, Message::kWork, block);
      --asker.blocks;
    }
  }
  std::erase_if(askers_, [](const Asker& asker) { return asker.blocks == 0; });
}

std::int64_t Dispatcher::choose(int rank) {
  if (next_ < sweep_.blocks() && next_ < taken_ + window_) {
    issued_[next_] = {rank, false};
    return next_++;
  }
  for (auto& [number, issue] : issued_) {
    if (issue.rank != rank && !issue.again) {
      issue.again = true;
      return number;
    }
  }
  return kNone;
}

void dismiss_workers() {
  for (int rank = 1; rank < rank_count(); ++rank) {
    send(rank, Message::kEnd);
  }
  for (int gone = 1; gone < rank_count();) {
    const auto message = receive();
    if (!message) {
      rest();
    } else if (message->what == Message::kBye) {
      ++gone;
    }
  }
}

}  // namespace higherpair::cli
