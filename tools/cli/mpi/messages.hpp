#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace higherpair::cli {

/// What ranks say to each other. Rank 0 hands out blocks and writes; all others ask it for them.
enum class Message : int {
  kHello = 1,  ///< to rank 0: what the sweep of this rank is (identity_text), or an objection
  kAsk,        ///< to rank 0: for so many blocks
  kResult,     ///< to rank 0: a block, as block_bytes
  kBye,        ///< to rank 0: nothing comes any more
  kWork,       ///< from rank 0: number of a block
  kEnd,        ///< from rank 0: no more work
};

struct Received {
  Message what = Message::kEnd;
  int rank = 0;  ///< from which
  std::string bytes;

  /// Of kAsk and kWork.
  [[nodiscard]] std::int64_t number() const;
};

/// The next message of any rank; none: there is none yet.
[[nodiscard]] std::optional<Received> receive();

/// Returns when it is on its way: for short messages, and where nothing else is to be done.
void send(int rank, Message what, const std::string& bytes = "");
void send(int rank, Message what, std::int64_t number);

[[nodiscard]] int own_rank();
[[nodiscard]] int rank_count();

/// Sleeps for a moment where there is nothing to do: what waits for messages by itself would take a core.
void rest();

}  // namespace higherpair::cli
