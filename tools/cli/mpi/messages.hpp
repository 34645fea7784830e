#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace higherpair::cli {

/// Messages between ranks. Rank 0 hands out blocks and writes the results; all others ask it for blocks.
enum class Message : int {
  kHello = 1,  ///< to rank 0: identity of this rank's sweep (identity_text)
  kAsk,        ///< to rank 0: asks for a number of blocks
  kResult,     ///< to rank 0: a finished block, as block_bytes
  kBye,        ///< to rank 0: the last message
  kWork,       ///< from rank 0: number of a block
  kEnd,        ///< from rank 0: no more work
};

struct Received {
  Message what = Message::kEnd;
  int rank = 0;  ///< the sender
  std::string bytes;

  /// The number in kAsk and kWork.
  [[nodiscard]] std::int64_t number() const;
};

/// The next message from any rank; none if there is none yet.
[[nodiscard]] std::optional<Received> receive();

/// Returns once the message is on its way: meant for short messages, or if there is nothing else to do.
void send(int rank, Message what, const std::string& bytes = "");
void send(int rank, Message what, std::int64_t number);

[[nodiscard]] int own_rank();
[[nodiscard]] int rank_count();

/// Sleeps for a moment when there is nothing to do: waiting for messages in a loop would occupy a core.
void rest();

}  // namespace higherpair::cli
